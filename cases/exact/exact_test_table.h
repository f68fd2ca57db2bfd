// Tables of independent figures, for tests.
#pragma once

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace mb {

// Rows below the comments and the heading.
inline std::vector<std::vector<double>> numbers(const std::string& name) {
  std::ifstream file(std::string(MB_SOURCE_DIR "/cases/exact/tables/") + name);
  std::vector<std::vector<double>> rows;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::stringstream cells(line);
    std::vector<double> row;
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::strtod(cell.c_str(), nullptr));
    rows.push_back(row);
  }
  if (!rows.empty()) rows.erase(rows.begin());
  return rows;
}

}  // namespace mb
