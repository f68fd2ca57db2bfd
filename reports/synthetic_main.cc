// synthetic_report DIRECTORY [CASES]: writes a report of made-up numbers, marked as such; with CASES the same study
// under that many names.
#include <charconv>
#include <cstring>
#include <exception>
#include <iostream>

#include "reports/synthetic.h"

int main(int argc, char** argv) {
  int n_cases = 0;
  const bool known =
      argc == 2 ||
      (argc == 3 && std::from_chars(argv[2], argv[2] + std::strlen(argv[2]), n_cases).ec == std::errc() && n_cases > 0);
  if (!known) {
    std::cerr << "usage: synthetic_report DIRECTORY [CASES]\n";
    return 2;
  }
  try {
    const mb::ReportInput input = n_cases > 0 ? mb::synthetic::many(n_cases) : mb::synthetic::input();
    for (const auto& path : mb::write_report(input, argv[1])) std::cout << path.string() << "\n";
  } catch (const std::exception& error) {
    std::cerr << "synthetic_report: " << error.what() << "\n";
    return 1;
  }
}
