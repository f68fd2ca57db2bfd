// synthetic_report DIRECTORY [CASES | hostile]: writes a report of made-up numbers, marked as such; with CASES the same
// study under that many names, with hostile one whose texts hold markup.
#include <charconv>
#include <cstring>
#include <exception>
#include <iostream>
#include <string_view>

#include "reports/synthetic_hostile.h"

int main(int argc, char** argv) {
  int n_cases = 0;
  const bool is_hostile = argc == 3 && std::string_view(argv[2]) == "hostile";
  const bool known =
      argc == 2 || is_hostile ||
      (argc == 3 && std::from_chars(argv[2], argv[2] + std::strlen(argv[2]), n_cases).ec == std::errc() && n_cases > 0);
  if (!known) {
    std::cerr << "usage: synthetic_report DIRECTORY [CASES | hostile]\n";
    return 2;
  }
  try {
    const mb::ReportInput input = is_hostile    ? mb::synthetic::hostile()
                                  : n_cases > 0 ? mb::synthetic::many(n_cases)
                                                : mb::synthetic::input();
    for (const auto& path : mb::write_report(input, argv[1])) std::cout << path.string() << "\n";
  } catch (const std::exception& error) {
    std::cerr << "synthetic_report: " << error.what() << "\n";
    return 1;
  }
}
