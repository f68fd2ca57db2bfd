// A comparison with something independent, as one row of docs/verification.md. The document holds what stands in the
// test; results are filled in by cmake/verification-document, which sets MODALBENCH_VERIFICATION_ROWS to a file.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

namespace mb::testing {

// Texts without a vertical bar, which would end a cell.
struct Comparison {
  std::string quantity;     // what is compared, of what, in what norm: "frequencies 7 to 23 of a cube, relative"
  std::string reference;    // exact solution, published, table, converged numbers, second route, manufactured solution
  std::string source;       // who says so: a publication, or the route
  std::string uncertainty;  // of the reference, with unit; "rounding" where that is all
  double tolerance;
  std::string why;  // this tolerance
};

inline std::string row_of(const Comparison& c) {
  const ::testing::TestInfo& test = *::testing::UnitTest::GetInstance()->current_test_info();
  return fmt::format("| {}.{} | {} | {} | {} | {} | {:.2g} | {} |", test.test_suite_name(), test.name(), c.quantity,
                     c.reference, c.source, c.uncertainty, c.tolerance, c.why);
}

// The test fails unless |error| <= tolerance, or where the document does not say so.
inline void expect_verified(const Comparison& comparison, double error) {
  EXPECT_LE(std::abs(error), comparison.tolerance) << comparison.quantity;
  const std::string row = row_of(comparison);
  if (const char* rows = std::getenv("MODALBENCH_VERIFICATION_ROWS")) {
    std::ofstream(rows, std::ios::app) << fmt::format("{} {:.2g} |\n", row, std::abs(error));
    return;
  }
  std::ostringstream document;
  document << std::ifstream(std::string(MB_SOURCE_DIR) + "/docs/verification.md").rdbuf();
  EXPECT_NE(document.str().find(row), std::string::npos)
      << row << "\ndocs/verification.md does not hold this: make it anew by cmake/verification-document";
}

}  // namespace mb::testing
