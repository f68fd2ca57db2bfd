#include <cstdio>
#include <cstdlib>
#include <iostream>

#include "harness/main.h"

// Nothing is left to do once all is written; to return would wait for the threads of the BLAS, one of which, where
// there is no memory for it to begin with, asks for it for good. Sanitizers look for leaks when the program returns.
int main(int argc, char** argv) {
  const int code = mb::harness_main(argc, argv, mb::default_catalogue());
#ifndef MB_SANITIZED
  std::cout.flush();
  std::cerr.flush();
  std::fflush(nullptr);
  std::_Exit(code);
#endif
  return code;
}
