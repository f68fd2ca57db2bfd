// synthetic_report DIRECTORY: writes a report of made-up numbers, marked as such.
#include <exception>
#include <iostream>

#include "reports/synthetic.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: synthetic_report DIRECTORY\n";
    return 2;
  }
  try {
    for (const auto& path : mb::write_report(mb::synthetic::input(), argv[1])) std::cout << path.string() << "\n";
  } catch (const std::exception& error) {
    std::cerr << "synthetic_report: " << error.what() << "\n";
    return 1;
  }
}
