#include "reference/fem/box_mesh.h"

#include <deal.II/grid/grid_generator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>
#include <stdexcept>

namespace mb::fem {
namespace {

using Places = std::array<std::vector<double>, 3>;  // [m] along x, y, z

double uniform(std::mt19937& random) {
  return 2 * static_cast<double>(random()) / static_cast<double>(std::mt19937::max()) - 1;
}  // alike in every library

// What a corner may move by along one axis, in the direction of either sign; 0 on a face across it.
double room(const std::vector<double>& places, double x) {
  const auto at = std::min_element(places.begin(), places.end(),
                                   [&](double a, double b) { return std::abs(a - x) < std::abs(b - x); });
  if (at == places.begin() || at + 1 == places.end()) return 0;
  return std::min(*(at + 1) - *at, *at - *(at - 1));
}

void distort(dealii::Triangulation<3>& mesh, const Places& places, double distorted) {
  std::mt19937 random(1989);
  std::set<unsigned> moved;
  for (const auto& cell : mesh.active_cell_iterators())
    for (const unsigned v : cell->vertex_indices()) {
      if (!moved.insert(cell->vertex_index(v)).second) continue;
      auto& x = cell->vertex(v);
      for (unsigned axis = 0; axis < 3; ++axis) x[axis] += distorted * room(places[axis], x[axis]) * uniform(random);
    }
}

}  // namespace

std::vector<double> biased_places(double edge, int n, double bias) {
  const double q = n > 1 ? std::pow(bias, 1.0 / (n - 1)) : 1;
  std::vector<double> ends{0};
  for (int i = 0; i < n; ++i) ends.push_back(ends.back() + std::pow(q, i));
  const double total = ends.back();
  for (double& x : ends) x = edge * (x / total - 0.5);
  return ends;
}

void make_box(dealii::Triangulation<3>& mesh, const Box& box, const Resolution& resolution) {
  const Vector3d h = 0.5 * box.size;
  const std::vector<int>& cells = resolution.cells;
  if (resolution.bias.empty() && resolution.distorted == 0) {
    dealii::GridGenerator::subdivided_hyper_rectangle(mesh, std::vector<unsigned>(cells.begin(), cells.end()),
                                                      dealii::Point<3>(-h[0], -h[1], -h[2]),
                                                      dealii::Point<3>(h[0], h[1], h[2]));
    return;
  }
  const std::vector<double> bias = resolution.bias.empty() ? std::vector<double>(3, 1.0) : resolution.bias;
  bool possible = bias.size() == 3 && resolution.distorted >= 0 && resolution.distorted <= 0.4;
  for (const double ratio : bias) possible = possible && ratio >= 1e-3 && ratio <= 1e3;
  if (!possible) throw std::invalid_argument("no mesh " + to_string(resolution) + " of a box");
  Places places;
  std::vector<std::vector<double>> steps(3);
  for (size_t axis = 0; axis < 3; ++axis) {
    places[axis] = biased_places(box.size[static_cast<Index>(axis)], cells[axis], bias[axis]);
    for (size_t i = 1; i < places[axis].size(); ++i) steps[axis].push_back(places[axis][i] - places[axis][i - 1]);
  }
  dealii::GridGenerator::subdivided_hyper_rectangle(mesh, steps, dealii::Point<3>(-h[0], -h[1], -h[2]),
                                                    dealii::Point<3>(h[0], h[1], h[2]));
  if (resolution.distorted > 0) distort(mesh, places, resolution.distorted);
}

}  // namespace mb::fem
