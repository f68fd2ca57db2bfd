#include <benchmark/benchmark.h>

#include <iostream>

#include "mechanics/algebra/threads.h"

int main(int argc, char** argv) {
  mb::use_one_thread();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::AddCustomContext("blas", mb::blas_description());
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
