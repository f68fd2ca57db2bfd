// Polynomial modes on bodies from compact to slender: each load alone, on the mesh of a body of that length.
//
//   error        = |u_d - u| / |u|,   u_d: Ritz modes in polynomials of degree d, u: all modes, both closed in time
//   static error = |Phi_d Lambda_d^-1 Phi_d^T F - G F|_M / |G F|_M,   what is left of it for loads however slow
#include <cmath>
#include <limits>

#include "harness/analysis/analyses.h"
#include "harness/analysis/modal_body.h"
#include "harness/analysis/stretched_scene.h"
#include "modal/bases/eigenmodes.h"
#include "modal/bases/ritz_modes.h"
#include "modal/methods/projection.h"

namespace mb {

namespace {

constexpr double ratios[] = {1, 2, 5, 10, 20, 50};
constexpr int n_modes = 96;  // with the static rest of all others: what half as many are off is the bar
constexpr int highest_degree = 3;
constexpr double deflection = 1e-8;  // [-] static, by the width: loads are scaled to it, that rotations stay small
constexpr double suffices = 0.1;     // [-] deformation error; the limit of the report's claim C4

Finding slenderness_table() {
  return table("slenderness", "slenderness", "Polynomial modes over slenderness",
               "The case's body at other lengths: section, material and loads kept, places along the body moved in "
               "proportion; times of loads as many periods of the lowest elastic mode as in the case. Each load alone, "
               "scaled to a static deflection of 1e-8 of the width. "
               "Truth: 96 eigenmodes of the body's own mesh with the static response of all others, exact in time, as "
               "the Ritz modes are; bar: what half as many modes are off, of errors e times 1 + e, and of static ones "
               "and frequencies what rounding makes of the lowest: all of that mesh, whatever another has. Degree 0: "
               "rigid motion alone, which has no deformation. Frequency: the lowest of the Ritz modes over that of the mesh. Verdict: whether degree 2, "
               "rigid, linear and quadratic modes, leave at most 10 % of the deformation.",
               {{"claim", ""},
                {"load", ""},
                {"length/width", "-"},
                {"degree", ""},
                {"functions", ""},
                {"displacement error", "-"},
                {"static error", "-"},
                {"strain error", "-"},
                {"bar", "-"},
                {"frequency ratio", "-"},
                {"verdict", ""}});
}

// One load of a reduced body, times `scale`.
LinearBody of_load(const LinearBody& all, Index j, double scale) {
  LinearBody one = all;
  one.system.F = scale * all.system.F.col(j);
  one.system.s = {all.system.s[static_cast<size_t>(j)]};
  for (Observation* seen : {&one.displacement, &one.strain})
    if (seen->of_load.cols() > 0) seen->of_load = MatrixXd(scale * seen->of_load.col(j));
  return one;
}

double norm(const SparseMatrix& M, const VectorXd& u) { return std::sqrt(u.dot(M * u)); }

class Bar {
 public:
  Bar(const AnalysisContext& context, Scene scene, double period)
      : exact_(context.catalogue.integrator("exact")),
        model_(model_of_own_mesh(std::make_shared<const Scene>(scene), scene.bodies.front().resolution)),
        shifted_(shifted_factor(system(), physical_shift(scene.bodies.front()))),
        modes_(lowest_modes(system(), n_modes, shifted_)),
        at_rest_(inertia_relief(system(), shifted_, system().F)),
        slowing_(this->period() / (period > 0 ? period : this->period())),
        scene_(slowed(std::move(scene), slowing_)) {}

  double period() const { return 2 * pi / modes_.omega(modes_.n_rigid); }  // [s] of the lowest elastic mode
  const Scene& scene() const { return scene_; }
  const EvaluationPoints& points() const { return model_.bodies.front().points; }
  Index n_loads() const { return system().F.cols(); }

  // The lowest n modes and the static response of all others.
  Trajectory in_modes(int n, Index load) const {
    const Modes kept = leading(modes_, n);
    return answer(kept, residual_flexibility(kept, system().F, at_rest_), load);
  }
  Modes polynomials(int degree) const {
    const FullModel& full = *model_.bodies.front().full;
    Modes modes = ritz_modes(system(), full.polynomials(std::max(1, degree)));
    return degree > 0 ? modes : leading(modes, 0);
  }
  Trajectory answer(const Modes& modes, const MatrixXd& rest, Index load) const {
    LinearBody reduced = reduce(model_.bodies.front(), modes, rest);
    for (History& history : reduced.system.s) history = slowed(history, slowing_);
    Settings settings;
    settings.load_tolerance = scene_.study.load_tolerance;
    const int used = static_cast<int>(modes.size() - modes.n_rigid);
    return prepare_linear({of_load(reduced, load, scale(load))}, exact_, settings, scene_.duration, used)
        ->simulate({.t = sample_times(scene_)});
  }
  double static_error(const Modes& modes, Index load) const {
    const MatrixXd Phi = modes.Phi.rightCols(modes.size() - modes.n_rigid);
    const VectorXd lambda = modes.omega.tail(Phi.cols()).array().square();
    const VectorXd u = Phi * VectorXd(Phi.transpose() * system().F.col(load)).cwiseQuotient(lambda);
    return norm(system().M, u - at_rest_.col(load)) / norm(system().M, at_rest_.col(load));
  }
  double rounding() const {  // [-] of the lowest elastic frequency, relative
    return rounding_of_frequency(modes_, modes_.omega(modes_.n_rigid));
  }
  double frequency_ratio(const Modes& modes) const {
    if (modes.size() == modes.n_rigid) return std::numeric_limits<double>::quiet_NaN();
    return modes.omega(modes.n_rigid) / modes_.omega(modes_.n_rigid);
  }

 private:
  double scale(Index load) const {
    const Shape& shape = scene_.bodies.front().shape;
    return deflection * extent(shape) / slenderness(shape) / at_rest_.col(load).cwiseAbs().maxCoeff();
  }
  const System& system() const { return model_.bodies.front().full->system(); }

  const Integrator& exact_;
  Model model_;
  ShiftedFactor shifted_;
  Modes modes_;
  MatrixXd at_rest_;  // [m] n x loads, static: of a free body in balance with its inertia
  double slowing_;
  Scene scene_;
};

std::string name_of_load(const Scene& scene, Index j) {
  return j < std::ssize(scene.loads) ? scene.loads[static_cast<size_t>(j)].name : "base";
}

void add_rows(Finding& found, const Bar& bar, double ratio, bool free) {
  const MetricContext context{bar.scene(), 0, bar.points(), free};
  const auto error = [&](const char* name, const Trajectory& answer, const Trajectory& truth) {
    return mark(metric(name), answer, truth, context).value;
  };
  for (Index j = 0; j < bar.n_loads(); ++j) {
    const Trajectory truth = bar.in_modes(n_modes, j);
    const Trajectory fewer = bar.in_modes(n_modes / 2, j);
    const double of_truth = error("displacement-error", fewer, truth), of_strain = error("strain-error", fewer, truth);
    for (int degree = free ? 0 : 1; degree <= highest_degree; ++degree) {
      const Modes modes = bar.polynomials(degree);
      const Trajectory answer = bar.answer(modes, MatrixXd(modes.Phi.rows(), 0), j);
      const double off = error("displacement-error", answer, truth), strain = error("strain-error", answer, truth);
      const double at_rest = bar.static_error(modes, j), frequency = bar.frequency_ratio(modes);
      std::string verdict;
      if (degree == 2) verdict = off <= suffices ? "suffice" : "do not suffice";
      found.rows.push_back({degree == 2 ? "C4" : "", name_of_load(bar.scene(), j), ratio, count(degree),
                            count(modes.size() - modes.n_rigid), off, at_rest, strain, of_truth, frequency, verdict});
      bar_last_row(found, {{"displacement error", of_truth * (1 + off)},
                           {"static error", 2 * bar.rounding() * (1 + at_rest)},
                           {"strain error", of_strain * (1 + strain)},
                           {"frequency ratio", bar.rounding() * frequency}});
    }
  }
}

}  // namespace

std::vector<Finding> polynomials_over_slenderness(const AnalysisContext& context) {
  Finding found = slenderness_table();
  const Scene& scene = *context.scene;
  const double period = Bar(context, stretched(scene, slenderness(scene.bodies.front().shape)), 0).period();
  for (const double ratio : ratios)
    add_rows(found, Bar(context, stretched(scene, ratio), period), ratio, is_free(context));
  return {found};
}

}  // namespace mb
