// The modes kept, by two solvers which share nothing but K and M: block Lanczos iterations on the factor of K - sigma M
// (modal/bases/shift_invert.h), and a dense reduction to tridiagonal form. Multiplet by multiplet (two_solvers.h), and
// what the scene's loads make of each.
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "harness/analysis/analyses.h"
#include "harness/analysis/modal_body.h"
#include "harness/analysis/stability_grid.h"
#include "harness/analysis/two_solvers.h"
#include "mechanics/system/modal_form.h"
#include "modal/methods/projection.h"

namespace mb {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Index largest_dense = 2500;  // [-] unknowns: ten seconds

Finding multiplets_table() {
  return table(
      "multiplets", "multiplets", "Modes by two solvers, multiplet by multiplet",
      "Elastic modes of the body's mesh whose eigenvalues differ by at most 1e-6 of themselves, or the rounding of "
      "the factor, eps lambda_max, stand together. "
      "Block Lanczos iterations beside a dense solver of the whole matrix. Gap: to the next eigenvalue "
      "above or below, relative. Subspace distance: sine of the largest angle between what the two solvers "
      "span, in the M norm; of the order of the residual over the gap. Bars: of a frequency twice the distance to that "
      "of the finer mesh of the case and what two solvers share, rounding of K and M, "
      "eps lambda_max/(2 lambda) of it; of the difference of frequency that alone, of the gap what it makes of two "
      "eigenvalues: either is of this mesh's matrices, whatever another's are. Of the distance what rounding makes of "
      "sums over n unknowns, n eps.",
      {{"first mode", ""},
       {"multiplicity", ""},
       {"frequency", "Hz"},
       {"gap", "-"},
       {"difference of frequency", "-"},
       {"subspace distance", "-"},
       {"distance times gap", "-"}});
}

Finding kept_table() {
  return table("multiplets", "multiplets-kept", "Where the study cuts the spectrum",
               "Elastic modes asked for and kept, rounded up to whole multiplets, and the gap that is cut: of the next "
               "eigenvalue from the last that is kept, relative. A multiplet that is cut leaves none. Bars: "
               "of rounding, as the gap is of this mesh's matrices.",
               {{"modes asked for", ""}, {"modes kept", ""}, {"gap at the cut", "-"}});
}

// [-] Of lambda_b/lambda_a - 1, both off by eps lambda_max.
double rounding_of_gap(const Modes& modes, double omega_a, double gap) {
  return 2 * rounding_of_frequency(modes, omega_a) * (2 + gap);
}

// lambda [1/s^2]: of the whole matrix, by the dense solver.
Finding kept(const Modes& modes, const VectorXd& lambda, const std::vector<int>& asked) {
  Finding found = kept_table();
  for (const int r : asked) {
    const Index n = leading(modes, r).size();
    if (n == modes.n_rigid || n == lambda.size()) continue;
    const double gap = lambda[n] / lambda[n - 1] - 1;
    found.rows.push_back({count(r), count(n - modes.n_rigid), gap});
    bar_last_row(found, {{"gap at the cut", rounding_of_gap(modes, std::sqrt(lambda[n - 1]), gap)}});
  }
  return found;
}

Finding answers_table() {
  return table("multiplets", "multiplets-answers", "Whether answers depend on the basis",
               "The scene's motion in closed form, in the modes of either solver, each of which has a basis of its own "
               "within every multiplet: difference of the deformations over all samples, in the M norm, over those in "
               "the most modes. Bar: what rounding makes of sums over n unknowns, n eps.",
               {{"modes kept", ""}, {"difference", "-"}});
}

Modes head(const Modes& modes, Index n) {
  return {modes.n_rigid, modes.omega.head(n), modes.Phi.leftCols(n), {}, modes.lambda_max};
}

// Deformations at the scene's samples, n x n_t.
MatrixXd motion(const System& system, const Modes& modes, const Scene& scene) {
  const MappedSystem mapped =
      mapped_system(project(system, modes), sample_times(scene), scene.duration, scene.study.load_tolerance);
  return modes.Phi.rightCols(mapped.exact.rows()) * mapped.exact;
}

// [-] Of sums over n unknowns.
double rounding_of_sums(Index n) { return static_cast<double>(n) * std::numeric_limits<double>::epsilon(); }

double norm(const SparseMatrix& M, const MatrixXd& u) { return std::sqrt(u.cwiseProduct(M * u).sum()); }

Finding answers(const System& system, const Modes& modes, const ModalForm& dense, const Scene& scene,
                const std::vector<int>& asked) {
  Finding found = answers_table();
  if (!scene.contacts.empty()) return found;  // of loads alone
  const Modes all{modes.n_rigid, dense.lambda.cwiseMax(0).cwiseSqrt(), dense.Phi, {}, modes.lambda_max};
  const double whole = norm(system.M, motion(system, head(all, leading(modes, asked.back()).size()), scene));
  Index before = 0;
  for (const int r : asked) {
    const Modes kept = leading(modes, r);
    const Index n = kept.size();
    if (n == modes.n_rigid || n == before) continue;
    before = n;
    const double off = norm(system.M, motion(system, kept, scene) - motion(system, head(all, n), scene));
    found.rows.push_back({count(n - modes.n_rigid), off / whole});
    bar_last_row(found, {{"difference", rounding_of_sums(system.M.rows())}});
  }
  return found;
}

}  // namespace

std::vector<Finding> multiplets(const AnalysisContext& context) {
  const int most = mode_counts(context).back();
  const auto [meshes, bar_per_distance] = another_mesh(*context.scene);
  const SeenModes other = seen_modes(modal_body(context, most + more_of_other, meshes));
  const ModalBody body = modal_body(context, most);  // last: the context has one model at a time
  const VectorXd on_another_mesh = paired_frequencies(seen_modes(body), other);
  System undamped = body.system;
  if (undamped.M.rows() > largest_dense)
    throw std::invalid_argument(
        fmt::format("multiplets: {} unknowns, a dense solver takes at most {}", undamped.M.rows(), largest_dense));
  undamped.damping = {};
  undamped.modal_damping = {MatrixXd(undamped.M.rows(), 0), VectorXd(0)};
  const ModalForm dense = modal_form(undamped);
  Finding found = multiplets_table();
  const Index n_rigid = body.modes.n_rigid;
  for (const TwiceFound& each : twice_found(undamped.M, body.modes, dense.lambda, dense.Phi)) {
    const double hertz = each.omega / (2 * pi);
    found.rows.push_back({count(each.multiplet.first - n_rigid + 1), count(each.multiplet.n), hertz, each.gap,
                          each.difference, each.distance, each.distance * each.gap});
    const double rounding = rounding_of_frequency(body.modes, each.omega);
    const double off = std::abs(on_another_mesh[each.multiplet.first - n_rigid] - each.omega) / (2 * pi);
    const double mesh = std::isnan(off) ? infinity : bar_per_distance * off;
    const double of_distance = rounding_of_sums(undamped.M.rows());
    bar_last_row(found, {{"frequency", mesh + rounding * hertz},
                         {"gap", rounding_of_gap(body.modes, each.omega, each.gap)},
                         {"difference of frequency", rounding},
                         {"subspace distance", of_distance},
                         {"distance times gap", of_distance * each.gap}});
  }
  const std::vector<int> asked = mode_counts(context);
  return {found, kept(body.modes, dense.lambda, asked), answers(body.system, body.modes, dense, *context.scene, asked)};
}

}  // namespace mb
