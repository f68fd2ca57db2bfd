// What tests of the oscillator share: tables of cases/exact/tables, and the smallest system there is.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "mechanics/system/exact.h"
#include "mechanics/system/oscillator.h"

namespace mb::testing {

using Row = std::vector<std::string>;

// Rows below the comment and the heading.
inline std::vector<Row> rows(const std::string& name) {
  std::ifstream file(std::string(MB_SOURCE_DIR "/cases/exact/tables/") + name);
  std::vector<Row> result;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::stringstream cells(line);
    Row row;
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
    result.push_back(row);
  }
  if (!result.empty()) result.erase(result.begin());
  return result;
}

// Reads hexadecimal as well.
inline double number(const std::string& cell) { return std::strtod(cell.c_str(), nullptr); }

// The closed-form integrator on the smallest system there is: q'' + c q' + k q = sum of the loads, from rest.
inline std::unique_ptr<Stepper> one_mode(const Oscillator& oscillator, const std::vector<History>& loads,
                                         double amplitude, double duration) {
  System system;
  system.M = MatrixXd::Identity(1, 1).sparseView();
  system.K = MatrixXd::Constant(1, 1, oscillator.k).sparseView();
  system.damping.alpha = oscillator.c;
  system.R = MatrixXd(1, 0);
  system.F = MatrixXd::Constant(1, static_cast<Index>(loads.size()), amplitude);
  system.s = loads;
  system.u0 = system.v0 = VectorXd::Zero(1);
  return exact(system, duration);
}

}  // namespace mb::testing
