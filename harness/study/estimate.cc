#include "harness/study/estimate.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "cases/scene/resolution.h"
#include "harness/study/plan.h"

namespace mb {

namespace {

constexpr double explicit_share = 1.0 / 3;       // [-] of a Newmark step
constexpr double adaptive_share = 35;            // [-] stages, error estimate and new factors of an adaptive step
constexpr double sudden = 8;                     // [-] steps after a jump, to those of a smooth load
constexpr double reduced_step = 1e-6;            // [s] + 20 ns a mode: a step of decoupled equations
constexpr double grade_per_sample = 2e-4;        // [s] marks at one time, and writing it
constexpr double timing = 0.02;                  // [s] least total of repeated runs (measure.h)
constexpr double repeated_below = 0.05;          // [s] (bench.h)
constexpr double analysis_per_mode_count = 0.4;  // [-] share of making the modes of every count, for each analysis

double step(double n) { return 9e-3 * std::pow(n / 17187, 1.6); }
double assembly(double n, int degree) { return 3e-4 * n / degree; }
double modes(double n, double r) { return (70 + r) * 10e-3 * std::pow(n / 4539, 1.3); }
double dense(double n) { return 2e-9 * n * n * n; }

class CaseEstimate {
 public:
  CaseEstimate(const Scene& scene, const Catalogue& catalogue)
      : scene_(scene), catalogue_(catalogue), n_samples_(static_cast<double>(sample_times(scene).size())) {}

  Estimate run() const {
    const auto& own = scene_.bodies.front().resolution;
    const double rtol = scene_.truth.relative_tolerance;
    // Two at a time: the finer one beside the others.
    const double truth =
        std::max(truth_run(scene_.truth.finer, rtol),
                 truth_run(scene_.truth.coarser, rtol) + truth_run(own, rtol) + truth_run(own, rtol / 100));
    double all = 0;
    std::set<std::pair<std::string, int>> bases;  // shared among the integrators
    for (const Contender& c : contenders(scene_, catalogue_)) {
      if (bases.insert({c.method, c.settings.modes}).second) all += basis(c);
      all += this->contender(c);
    }
    return {truth, all, analyses()};
  }

 private:
  double n_dofs_of(const Resolution& resolution) const {
    double n = 0;
    for (const Body& body : scene_.bodies) n += n_dofs(body.shape, resolution);
    return n;
  }

  bool is_sudden() const {
    const auto driven = [](const Support& s) { return s.drive && std::holds_alternative<Step>(s.drive->acceleration); };
    const auto shaken = [&](const Body& body) { return std::ranges::any_of(body.supports, driven); };
    const auto struck = [](const Load& load) { return std::holds_alternative<Step>(load.history); };
    return std::ranges::any_of(scene_.loads, struck) || std::ranges::any_of(scene_.bodies, shaken);
  }

  // Steps of the adaptive integrator, as its tolerance alone rules them.
  double n_adaptive(double rtol) const { return 4 * std::pow(rtol, -0.3) * (is_sudden() ? sudden : 1); }

  double truth_run(const Resolution& resolution, double rtol) const {
    const double n = n_dofs_of(resolution);
    return assembly(n, resolution.degree) + n_adaptive(rtol) * adaptive_share * step(n);
  }

  double stepping(const Contender& c, double newmark_step) const {
    const Integrator& integrator = catalogue_.integrator(c.integrator);
    if (integrator.knob == Integrator::Knob::tolerance)
      return n_adaptive(c.settings.relative_tolerance) * adaptive_share * newmark_step;
    if (!(c.settings.time_step > 0)) return n_samples_ * newmark_step;
    const double n_steps = scene_.duration / c.settings.time_step;
    return n_steps * newmark_step * (integrator.conditionally_stable ? explicit_share : 1);
  }

  double basis(const Contender& c) const {
    const double n = n_dofs_of(c.resolution);
    if (is_full_order(c)) return 0;
    if (c.method == "full") return c.integrator == "exact" ? dense(n) : 0;
    const double r = catalogue_.method(c.method).takes_modes() ? c.settings.modes : 24;  // at most quadratic strain
    return modes(n, r);
  }

  double contender(const Contender& c) const {
    const double n = n_dofs_of(c.resolution);
    const bool of_mesh = is_full_order(c) || c.method == "full", closed_form = c.integrator == "exact";
    const double r = catalogue_.method(c.method).takes_modes() ? c.settings.modes : 24;
    const double preparation = is_full_order(c) ? assembly(n, c.resolution.degree) : 0;
    const double online = stepping(c, of_mesh && !closed_form ? step(n) : reduced_step + 2e-8 * r);
    // Online time and the time of stepping alone are repeated where they are short.
    const double timed = online < repeated_below ? 2 * std::max(timing, 6 * online) : online;
    return preparation + online + timed + n_samples_ * grade_per_sample;
  }

  double analyses() const {
    const double n = n_dofs_of(scene_.bodies.front().resolution);
    double once = 0;
    for (const int r : scene_.study.modes) once += modes(n, r);
    return static_cast<double>(scene_.study.analyses.size()) * analysis_per_mode_count * once;
  }

  const Scene& scene_;
  const Catalogue& catalogue_;
  double n_samples_;
};

}  // namespace

Estimate estimate(const Scene& scene, const Catalogue& catalogue) { return CaseEstimate(scene, catalogue).run(); }

}  // namespace mb
