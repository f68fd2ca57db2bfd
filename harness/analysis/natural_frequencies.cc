// Natural frequencies on the meshes of the case against published ones,
//
//   error = f_h / f - 1        order = ln(error_coarse / error_fine) / ln(h_coarse / h_fine)
//
// mode by mode in ascending order, and the band that the meshes alone give the finest of a sequence (gci.h).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "harness/analysis/analyses.h"
#include "harness/analysis/modal_body.h"
#include "harness/metrics/gci.h"
#include "modal/bases/eigenmodes.h"

namespace mb {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
// An order is told from errors that stand this far above what the reference is uncertain by.
constexpr double resolved = 20;  // [-]

struct OnMesh {
  Resolution resolution;
  VectorXd hertz;  // of the elastic modes
};

OnMesh on_mesh(const AnalysisContext& context, const Resolution& resolution, int n) {
  const System& system = context.model(resolution).bodies.front().full->system();
  const Body& body = context.scene->bodies.front();
  const Modes modes = lowest_modes(system, n, shifted_factor(system, physical_shift(body)));
  if (modes.size() - modes.n_rigid < n)
    throw std::invalid_argument(fmt::format("{} has fewer modes than the reference", to_string(resolution)));
  return {resolution, modes.omega.segment(modes.n_rigid, n) / (2 * pi)};
}

// h_a / h_b where the cells of b are those of a scaled evenly, of the same degree; else NaN.
double refinement(const Resolution& a, const Resolution& b) {
  if (a.degree != b.degree || a == b || a.cells.size() != b.cells.size()) return nan;
  const double ratio = static_cast<double>(b.cells.front()) / a.cells.front();
  for (size_t i = 0; i < a.cells.size(); ++i)
    if (b.cells[i] != ratio * a.cells[i]) return nan;
  return ratio;
}

struct BarredOrder {
  double order = nan, bar = nan;  // [-] bar: what the reference leaves open of both errors
};

// Between the finest two meshes of one degree and shape of cell, where the order is nearest its limit; NaN where there
// are none or an error is not resolved.
BarredOrder observed_order(const std::vector<OnMesh>& meshes, const std::vector<double>& errors, double uncertainty) {
  int finest = 0;  // cells of the coarser of the pair
  BarredOrder found;
  for (size_t a = 0; a < meshes.size(); ++a)
    for (size_t b = 0; b < meshes.size(); ++b) {
      const double ratio = refinement(meshes[a].resolution, meshes[b].resolution);
      const bool told = std::min(errors[a], errors[b]) > resolved * uncertainty;
      const int coarser = meshes[a].resolution.cells.front();
      if (!told || !(ratio > 1) || coarser <= finest) continue;
      finest = coarser;
      found = {std::log(errors[a] / errors[b]) / std::log(ratio),
               uncertainty * (1 / errors[a] + 1 / errors[b]) / std::log(ratio)};
    }
  return found;
}

// Of one degree and shape of cell, the finest first, at one ratio.
struct MeshSequence {
  std::vector<size_t> meshes;  // three, or two where there are no three; or none
  double ratio = nan;
};
MeshSequence sequence(const std::vector<OnMesh>& meshes) {
  MeshSequence found;
  const auto ratio_of = [&](size_t a, size_t b) { return refinement(meshes[a].resolution, meshes[b].resolution); };
  const auto is_better = [&](const std::vector<size_t>& other) {
    if (other.size() != found.meshes.size()) return other.size() > found.meshes.size();
    const auto cells = [&](const std::vector<size_t>& all) { return meshes[all[1]].resolution.cells.front(); };
    return cells(other) > cells(found.meshes);
  };
  for (size_t a = 0; a < meshes.size(); ++a)
    for (size_t b = 0; b < meshes.size(); ++b) {
      const double ratio = ratio_of(a, b);
      if (!(ratio > 1)) continue;
      std::vector<size_t> row{b, a};
      for (size_t c = 0; c < meshes.size(); ++c)
        if (row.size() == 2 && ratio_of(c, a) == ratio) row.push_back(c);
      if (is_better(row)) found = {row, ratio};
    }
  return found;
}

// [-] of the finest mesh of a sequence. Frequencies of elements of degree k converge at order 2k (Strang & Fix 1973,
// ch. 6) where modes are smooth; of held bodies they are not.
double convergence_index(const std::vector<OnMesh>& meshes, const MeshSequence& row, Index mode, double least_order) {
  if (row.meshes.empty()) return nan;
  const auto f = [&](size_t i) { return meshes[row.meshes[i]].hertz(mode); };
  const double order = std::min(2.0 * meshes[row.meshes[0]].resolution.degree, least_order);
  if (row.meshes.size() == 2) return gci_of_two(f(0), f(1), row.ratio, order).value_or(nan);
  const auto three = grid_convergence(f(0), f(1), f(2), row.ratio, order);
  return three ? three->fine : nan;
}

// How the column of the index came about, in words.
std::string index_note(const std::vector<OnMesh>& meshes, const MeshSequence& row, double least_order) {
  if (row.meshes.empty()) return " GCI: there are no two meshes of one degree and shape of cell.";
  return fmt::format(
      " GCI: grid convergence index (Roache 1998) of {}, the band about its frequency without the reference, "
      "from {} meshes at a ratio of {:.4g} with a factor of {}.",
      to_string(meshes[row.meshes[0]].resolution), row.meshes.size(), row.ratio,
      row.meshes.size() == 3
          ? "1.25 and their own order, 3 where that is off the order of theory by more than a tenth"
          : fmt::format("3 and the order of theory, twice the degree{}",
                        std::isinf(least_order) ? std::string() : fmt::format(", {:.3g} at most", least_order)));
}

}  // namespace

std::vector<Finding> natural_frequencies(const AnalysisContext& context) {
  const Scene& scene = *context.scene;
  const ReferenceFrequencies& reference = scene.reference_frequencies;
  if (reference.hertz.empty()) throw std::invalid_argument("the case states no [reference_frequencies]");
  const auto n = static_cast<int>(reference.hertz.size());
  std::vector<OnMesh> meshes;
  for (const Resolution& r : {scene.truth.coarser, own_meshes(scene), scene.truth.finer})
    meshes.push_back(on_mesh(context, r, n));
  const double of_finer = another_mesh(scene).bar_per_distance;
  Finding found = table(
      "frequencies", "frequencies", "Natural frequencies against published ones",
      fmt::format(
          "Modes in ascending order; relative uncertainty of the reference {:.0e}. Error: f/f_reference - 1, on "
          "the body's mesh where no other is named. Order: between the finest two meshes of one degree whose cells "
          "are of one shape. Bar of a frequency: the larger of its distance to that of `coarser` and {:.3g} times that "
          "to `finer`.",
          reference.uncertainty, of_finer),
      {{"mode", ""}, {"reference", "Hz"}, {"frequency", "Hz"}, {"error", "-"}});
  for (const OnMesh& mesh : meshes) found.columns.push_back({"error " + to_string(mesh.resolution), "-"});
  found.columns.push_back({"order", "-"});
  found.columns.push_back({"GCI", "-"});
  const MeshSequence row = sequence(meshes);
  // Where no support holds a body modes are smooth; at a clamp's edge (mesh_bar.h) frequencies have twice its order.
  const double least_order = is_held(scene.bodies.front()) ? 2 * order_of_modes(scene) : infinity;
  found.note += index_note(meshes, row, least_order);
  for (Index i = 0; i < n; ++i) {
    const double f = reference.hertz[static_cast<size_t>(i)];
    std::vector<double> errors;
    for (const OnMesh& mesh : meshes) errors.push_back(mesh.hertz(i) / f - 1);
    found.rows.push_back({count(i + 1), f, meshes[1].hertz(i), errors[1]});
    found.rows.back().insert(found.rows.back().end(), errors.begin(), errors.end());
    const BarredOrder observed = observed_order(meshes, errors, reference.uncertainty);
    found.rows.back().push_back(observed.order);
    found.rows.back().push_back(convergence_index(meshes, row, i, least_order));
    found.bars.emplace_back(found.columns.size(), nan);  // of errors: what the reference leaves open
    for (size_t j = 3; j < 4 + meshes.size(); ++j) found.bars.back()[j] = reference.uncertainty;
    found.bars.back()[4 + meshes.size()] = observed.bar;
    found.bars.back()[2] = std::max(std::abs(meshes[1].hertz(i) - meshes[0].hertz(i)),
                                    of_finer * std::abs(meshes[1].hertz(i) - meshes[2].hertz(i)));
  }
  return {found};
}

}  // namespace mb
