// Natural frequencies on the meshes of the case against published ones,
//
//   error = f_h / f - 1        order = ln(error_coarse / error_fine) / ln(h_coarse / h_fine)
//
// mode by mode in ascending order.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "harness/analysis/analyses.h"
#include "harness/analysis/modal_body.h"
#include "modal/bases/eigenmodes.h"

namespace mb {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
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

// Between the finest two meshes of one degree and shape of cell, where the order is nearest its limit; NaN where there
// are none or an error is not resolved.
double observed_order(const std::vector<OnMesh>& meshes, const std::vector<double>& errors, double uncertainty) {
  int finest = 0;  // cells of the coarser of the pair
  double order = nan;
  for (size_t a = 0; a < meshes.size(); ++a)
    for (size_t b = 0; b < meshes.size(); ++b) {
      const double ratio = refinement(meshes[a].resolution, meshes[b].resolution);
      const bool told = std::min(errors[a], errors[b]) > resolved * uncertainty;
      const int coarser = meshes[a].resolution.cells.front();
      if (!told || !(ratio > 1) || coarser <= finest) continue;
      finest = coarser;
      order = std::log(errors[a] / errors[b]) / std::log(ratio);
    }
  return order;
}

}  // namespace

std::vector<Finding> natural_frequencies(const AnalysisContext& context) {
  const Scene& scene = *context.scene;
  const ReferenceFrequencies& reference = scene.reference_frequencies;
  if (reference.hertz.empty()) throw std::invalid_argument("the case states no [reference_frequencies]");
  const auto n = static_cast<int>(reference.hertz.size());
  std::vector<OnMesh> meshes;
  for (const Resolution& r : {scene.truth.coarser, scene.bodies.front().resolution, scene.truth.finer})
    meshes.push_back(on_mesh(context, r, n));
  Finding found = table(
      "frequencies", "frequencies", "Natural frequencies against published ones",
      fmt::format(
          "Modes in ascending order; relative uncertainty of the reference {:.0e}. Error: f/f_reference - 1, on "
          "the body's mesh where no other is named. Order: between the finest two meshes of one degree whose cells "
          "are of one shape.",
          reference.uncertainty),
      {{"mode", ""}, {"reference", "Hz"}, {"frequency", "Hz"}, {"error", "-"}});
  for (const OnMesh& mesh : meshes) found.columns.push_back({"error " + to_string(mesh.resolution), "-"});
  found.columns.push_back({"order", "-"});
  for (Index i = 0; i < n; ++i) {
    const double f = reference.hertz[static_cast<size_t>(i)];
    std::vector<double> errors;
    for (const OnMesh& mesh : meshes) errors.push_back(mesh.hertz(i) / f - 1);
    found.rows.push_back({count(i + 1), f, meshes[1].hertz(i), errors[1]});
    found.rows.back().insert(found.rows.back().end(), errors.begin(), errors.end());
    found.rows.back().push_back(observed_order(meshes, errors, reference.uncertainty));
  }
  return {found};
}

}  // namespace mb
