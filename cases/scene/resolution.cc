#include "cases/scene/resolution.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "mechanics/geometry/overloaded.h"

namespace mb {

const char* kind_name(const Shape& shape) {
  static constexpr const char* names[] = {"box", "cylinder", "sphere", "superquadric", "tapered superquadric"};
  return names[shape.index()];
}

std::size_t n_cell_entries(const Shape& shape, Theory theory) {
  if (theory == Theory::solid) return shape.index() < 2 ? 3 - shape.index() : 1;
  return theory == Theory::euler_bernoulli ? 1 : 2;
}

namespace {

double even_n_dofs(const Shape& shape, const Resolution& resolution) {
  const auto nodes = [&](std::size_t i) { return static_cast<double>(resolution.degree * resolution.cells[i]); };
  return 3 * std::visit(overloaded{[&](const Box&) { return (nodes(0) + 1) * (nodes(1) + 1) * (nodes(2) + 1); },
                                   [&](const Cylinder&) {
                                     const double m = nodes(0), p = resolution.degree;
                                     const double disc = m == 0 ? (p + 1) * (p + 1) : (m + 1) * (m + 1) + 4 * m * m;
                                     return disc * (nodes(1) + 1);
                                   },
                                   [&](const auto&) {
                                     const double m = nodes(0);
                                     return (m + 1) * (m + 1) * (m + 1) + m * (6 * m * m + 2);
                                   }},
                        shape);
}

// An average cell before grading.
struct Cells {
  double n, diameter;  // [-], [m]
};
Cells even_cells(const Shape& shape, const std::vector<int>& cells) {
  const auto n = [&](std::size_t i) { return static_cast<double>(cells[i]); };
  return std::visit(
      overloaded{[&](const Box& box) -> Cells {
                   return {n(0) * n(1) * n(2), box.size.cwiseQuotient(Vector3d(n(0), n(1), n(2))).norm()};
                 },
                 [&](const Cylinder& cylinder) -> Cells {
                   const double disc = n(0) == 0 ? 1 : 5 * n(0) * n(0);
                   return {disc * n(1), std::hypot(std::sqrt(2 * pi / disc) * cylinder.radius, cylinder.length / n(1))};
                 },
                 [&](const auto& ball) -> Cells {
                   const double all = 7 * n(0) * n(0) * n(0);
                   return {all, std::sqrt(3.0) * std::cbrt(volume(ball) / all)};
                 }},
      shape);
}

double n_half_waves(const Resolution& resolution) {
  double n = 1;
  for (const int along : resolution.cells) n *= along;
  return n;
}

// Of beams and plates: whether such half waves can be taken.
bool check_half_waves(const Resolution& resolution, Theory theory, const Position& where, Findings& findings) {
  const bool beam = theory == Theory::euler_bernoulli;
  const std::string of = fmt::format("a body of theory '{}'", to_string(theory));
  const auto refuse = [&](const std::string& message, const std::string& help = "") {
    findings.error(where, message, help);
    return false;
  };
  if (resolution.degree != 1 || resolution.graded != 0)
    return refuse(fmt::format("{} has no mesh but half waves: its degree must be 1, and it is not graded", of));
  if (const std::size_t n = beam ? 1 : 2; resolution.cells.size() != n)
    return refuse(fmt::format("'cells' of {} has {} entries: must be {}", of, resolution.cells.size(), n),
                  beam ? "half waves along x" : "half waves along x, along y");
  const double n = n_half_waves(resolution);
  if (n >= 1 && n <= most_half_waves) return true;
  return refuse(fmt::format("{} half waves of {}: must lie in [1, {:.0f}]", n, of, most_half_waves));
}

}  // namespace

double n_dofs(const Shape& shape, const Resolution& resolution, Theory theory) {
  if (theory != Theory::solid) return n_half_waves(resolution) + 1;
  const double even = even_n_dofs(shape, resolution);
  if (resolution.graded == 0 || even == 0) return even;
  const auto [n, diameter] = even_cells(shape, resolution.cells);
  const double halved = 1.5 * 2.0 / 3 * pi * std::pow(grading_reach * diameter, 3) / (volume(shape) / n);
  double all = n;
  for (int i = 0; i < resolution.graded; ++i) all += 7 * std::min(all, halved);
  return even + 3 * std::pow(resolution.degree, 3) * (all - n);
}

double n_elastic(const Shape& shape, const Resolution& resolution, Theory theory) {
  return n_dofs(shape, resolution, theory) - (theory == Theory::solid ? 6 : 1);
}

bool check_mesh(const Shape& shape, const Resolution& resolution, const Position& where, Findings& findings,
                Theory theory) {
  if (theory != Theory::solid) return check_half_waves(resolution, theory, where, findings);
  const std::size_t n = n_cell_entries(shape);
  if (resolution.cells.size() != n) {
    const char* const means[] = {"along x, y, z", "edge splits of the disc (0: one block), layers along z",
                                 "edge splits of its blocks"};
    findings.error(
        where, fmt::format("'cells' of a {} has {} entries: must be {}", kind_name(shape), resolution.cells.size(), n),
        fmt::format("cells of a {}: {}", kind_name(shape), means[std::min<std::size_t>(shape.index(), 2)]));
    return false;
  }
  const bool one_block = std::holds_alternative<Cylinder>(shape) && resolution.cells[0] == 0;
  const auto zero = std::find(resolution.cells.begin() + (one_block ? 1 : 0), resolution.cells.end(), 0);
  if (zero != resolution.cells.end()) {
    findings.error(where, fmt::format("entry {} of 'cells' is 0: only the edge splits of a cylinder's disc may be",
                                      zero - resolution.cells.begin() + 1));
    return false;
  }
  const auto splits = static_cast<unsigned>(resolution.cells[0]);
  if (!std::holds_alternative<Box>(shape) && !one_block && !std::has_single_bit(splits)) {
    findings.error(where, fmt::format("a {} has its blocks halved again and again: {} edge splits are no power of two",
                                      kind_name(shape), splits));
    return false;
  }
  const double n_unknowns = n_dofs(shape, resolution);
  if (n_unknowns <= most_dofs) return true;
  findings.error(where, fmt::format("{} of a {} has {:.0f} degrees of freedom: at most {:.0f}", to_string(resolution),
                                    kind_name(shape), n_unknowns, most_dofs));
  return false;
}

std::optional<Resolution> read_resolution(Section section, const std::optional<Shape>& shape, Theory theory) {
  const auto degree = section.integer("degree", degree_range);
  const std::size_t n = shape ? n_cell_entries(*shape, theory) : 0;
  const Count entries = shape ? Count{n, n} : Count{1, 3};
  const bool disc = !shape || std::holds_alternative<Cylinder>(*shape);
  const auto cells = section.integers("cells", disc ? any_cells_range : cells_range, entries);
  section.finish();
  if (!degree || !cells) return std::nullopt;
  Resolution resolution{*degree, {}};
  for (const auto& entry : *cells) resolution.cells.push_back(entry.value);
  if (shape && !check_mesh(*shape, resolution, section.where("cells"), section.findings(), theory)) return std::nullopt;
  return resolution;
}

}  // namespace mb
