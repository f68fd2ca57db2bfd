#include "mechanics/geometry/graded_rule.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <stdexcept>

#include "mechanics/geometry/gauss.h"
#include "mechanics/geometry/surface_patches.h"

namespace mb {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int max_points = 16;          // along an edge
constexpr double least_finest = 1e-10;  // by the extent: corners of a cell still differ in six digits

struct Leaf {
  const SurfacePatch* patch;
  ParameterCell cell;
};

void validate(const Shape& shape, const std::vector<Vector3d>& foci, const Grading& g, double within) {
  const double least = least_finest * extent(shape);
  if (!(g.finest >= least && std::isfinite(g.finest)))
    throw std::invalid_argument(
        fmt::format("graded_rule: finest is {} m, not finite and at least {} m for this shape", g.finest, least));
  if (!(g.coarsest >= g.finest))
    throw std::invalid_argument(fmt::format("graded_rule: coarsest is {} m, finest {} m", g.coarsest, g.finest));
  if (!(g.grading >= 0 && std::isfinite(g.grading)))
    throw std::invalid_argument(fmt::format("graded_rule: grading is {}, not finite and >= 0", g.grading));
  if (g.points_per_cell_edge < 1 || g.points_per_cell_edge > max_points)
    throw std::invalid_argument(
        fmt::format("graded_rule: {} points per edge of a cell, range 1 to {}", g.points_per_cell_edge, max_points));
  if (!(within >= 0)) throw std::invalid_argument(fmt::format("graded_rule: within is {} m, not >= 0", within));
  if (foci.empty() && within < infinity) throw std::invalid_argument("graded_rule: within a distance of no focus");
  for (std::size_t i = 0; i < foci.size(); ++i)
    if (!foci[i].allFinite())
      throw std::invalid_argument(
          fmt::format("graded_rule: focus {} is ({}, {}, {}) m, not finite", i, foci[i][0], foci[i][1], foci[i][2]));
}

// Lengths [m] along s and t: the longest of three chains through the images of 3 x 3 parameters.
struct Lengths {
  double s = 0, t = 0;
};

Lengths lengths(const SurfacePatch& patch, const ParameterCell& c) {
  const std::array<double, 3> s{c.s0, 0.5 * (c.s0 + c.s1), c.s1}, t{c.t0, 0.5 * (c.t0 + c.t1), c.t1};
  std::array<std::array<Vector3d, 3>, 3> x;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) x[i][j] = patch.at(s[i], t[j]).x;
  Lengths length;
  for (int k = 0; k < 3; ++k) {
    length.s = std::max(length.s, (x[1][k] - x[0][k]).norm() + (x[2][k] - x[1][k]).norm());
    length.t = std::max(length.t, (x[k][1] - x[k][0]).norm() + (x[k][2] - x[k][1]).norm());
  }
  return length;
}

double distance(const SurfacePatch& patch, const ParameterCell& c, const std::vector<Vector3d>& foci) {
  const double s = 0.5 * (c.s0 + c.s1), t = 0.5 * (c.t0 + c.t1);
  const Vector3d centre = patch.at(s, t).x;
  double nearest = infinity;
  for (const Vector3d& focus : foci) nearest = std::min(nearest, (focus - centre).norm());
  return foci.empty() ? infinity : std::max(0.0, nearest - patch.covering_radius(c, s, t));
}

// The cell itself where it is short enough, else its halves or quarters.
std::vector<ParameterCell> halved(const ParameterCell& c, bool across_s, bool across_t) {
  const double s = 0.5 * (c.s0 + c.s1), t = 0.5 * (c.t0 + c.t1);
  if (across_s && across_t) return {{c.s0, s, c.t0, t}, {s, c.s1, c.t0, t}, {c.s0, s, t, c.t1}, {s, c.s1, t, c.t1}};
  if (across_s) return {{c.s0, s, c.t0, c.t1}, {s, c.s1, c.t0, c.t1}};
  return {{c.s0, c.s1, c.t0, t}, {c.s0, c.s1, t, c.t1}};
}

std::vector<Leaf> leaves(const std::vector<SurfacePatch>& patches, const std::vector<Vector3d>& foci, const Grading& g,
                         double within) {
  std::vector<Leaf> list, open;
  for (const SurfacePatch& patch : patches) open.push_back({&patch, {}});
  while (!open.empty()) {
    const auto [patch, cell] = open.back();
    open.pop_back();
    const double d = distance(*patch, cell, foci);
    if (d > within) continue;
    const double h = foci.empty() ? g.coarsest : std::min(g.coarsest, std::max(g.finest, g.grading * d));
    const auto [s, t] = lengths(*patch, cell);
    if (!(s > h || t > h)) {
      list.push_back({patch, cell});
    } else {
      for (const ParameterCell& part : halved(cell, s > h, t > h)) open.push_back({patch, part});
    }
    if (list.size() + open.size() > max_graded_cells)
      throw std::invalid_argument(
          fmt::format("graded_rule: more than {} cells with finest {} m, coarsest {} m, grading {}", max_graded_cells,
                      g.finest, g.coarsest, g.grading));
  }
  return list;
}

}  // namespace

GradedRule graded_rule(const Shape& shape, const std::vector<Vector3d>& foci, const Grading& grading, double within) {
  const std::vector<SurfacePatch> patches = surface_patches(shape);
  validate(shape, foci, grading, within);
  const std::vector<Leaf> cells = leaves(patches, foci, grading, within);
  const int n = grading.points_per_cell_edge;
  const Rule gauss = gauss_legendre(n);
  // Bounds of the samples' shares of an edge: half-way between neighbours.
  VectorXd bound = VectorXd::Unit(n + 1, n);
  for (int i = 1; i < n; ++i) bound[i] = 0.5 * (gauss.x[i - 1] + gauss.x[i]);
  const Index m = static_cast<Index>(cells.size()) * n * n;
  GradedRule rule{Matrix3Xd(3, m), VectorXd(m), Matrix3Xd(3, m), VectorXd(m)};
  Index at = 0;
  for (const auto& [patch, c] : cells) {
    const double ds = c.s1 - c.s0, dt = c.t1 - c.t0;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j, ++at) {
        const double s = c.s0 + gauss.x[i] * ds, t = c.t0 + gauss.x[j] * dt;
        const SurfacePoint p = patch->at(s, t);
        const Vector3d area = p.by_s.cross(p.by_t);
        rule.points.col(at) = p.x;
        rule.normals.col(at) = area.stableNormalized();
        rule.weights[at] = gauss.w[i] * ds * gauss.w[j] * dt * area.stableNorm();
        rule.radius[at] = patch->covering_radius(
            {c.s0 + bound[i] * ds, c.s0 + bound[i + 1] * ds, c.t0 + bound[j] * dt, c.t0 + bound[j + 1] * dt}, s, t);
      }
  }
  return rule;
}

}  // namespace mb
