#include "harness/analysis/amplitude_sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "harness/analysis/contact_variants.h"
#include "harness/analysis/modal_body.h"
#include "harness/metrics/motion.h"
#include "harness/study/truth.h"
#include "modal/bases/eigenmodes.h"

namespace mb {

namespace {

constexpr double before = 0.25, after = 2;  // [-] durations of the contact
constexpr double samples = 100;             // in one
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Scene with_first_finite(const Scene& scene) {
  Scene finite = linearised(scene);
  finite.bodies.front().kinematics = Kinematics::finite;
  return finite;
}

const Meeting& first_meeting(const Touchdown& down) {
  return *std::ranges::min_element(down.meetings, {}, &Meeting::t);
}

// Duration and samples by the contact at that speed.
Scene thrown(const Scene& scene, double factor) {
  const double T_0 = first_meeting(touchdown(scene, scene.bodies.front())).size.duration;
  const Scene trial = thrown(scene, factor, before * T_0, T_0);
  const double T = first_meeting(touchdown(trial, trial.bodies.front())).size.duration;
  Scene found = thrown(scene, factor, before * T, after * T);
  found.samples_per_second = samples / T;
  return found;
}

void require_finite_possible(const Body& body) {
  if (body.theory != Theory::solid || !is_uniform(body.material) || !body.damping_ratios.empty())
    throw std::invalid_argument("finite strain is of isotropic solids with Rayleigh damping");
}

// [-] Of the surface, by the body's extent.
double largest_deformation(const Trajectory& answer, const MetricContext& of) {
  const MatrixXd surface = motion(answer, of).surface;
  return std::sqrt(surface.reshaped(3, surface.size() / 3).colwise().squaredNorm().maxCoeff()) /
         extent(of.scene.bodies.front().shape);
}

class Sweep {
 public:
  explicit Sweep(const AnalysisContext& context)
      : context_(context),
        scene_(*context.scene),
        n_modes_(std::ranges::max(mode_counts(context))),
        points_(evaluation_points(scene_, scene_.bodies.front())),
        linear_(model(linearised(thrown(scene_, 1)))),
        finite_(model(with_first_finite(thrown(scene_, 1)))) {
    for (size_t i = 0; i < linear_.bodies.size(); ++i)
      modes_.push_back(
          lowest_modes(linear_.bodies[i].full->system(), n_modes_, physical_shift(linear_.scene->bodies[i])));
  }

  AmplitudeRow at(double factor) const {
    const Scene scene = thrown(scene_, factor);
    AmplitudeRow row{first_meeting(touchdown(scene, scene.bodies.front())).size.speed, factor, ""};
    const double rtol = scene_.truth.relative_tolerance;
    const auto loose = tried("linear", row, [&] { return full(linear_, linearised(scene), rtol); });
    const auto linear = tried("linear", row, [&] { return full(linear_, linearised(scene), rtol / 10); });
    const auto finite = tried("finite", row, [&] { return full(finite_, with_first_finite(scene), rtol / 10); });
    const double h = std::ranges::min(scene_.study.contact_steps);
    const auto modal = tried("modal", row, [&] { return reduced(linearised(scene), h); });
    AmplitudeRow aside = row;  // a bar that cannot be had is none
    const auto coarse = tried("modal by twice the step", aside, [&] { return reduced(linearised(scene), 2 * h); });
    const MetricContext of{scene, 0, points_, true};
    const auto error = [&](const std::optional<Trajectory>& a, const std::optional<Trajectory>& b) {
      return a && b ? mark(metric("displacement-error"), *a, *b, of).value : nan;
    };
    row.of_linear = error(linear, finite);
    row.of_steps = error(loose, linear);
    row.of_modal_steps = error(coarse, modal);
    row.modal_linear = error(modal, linear);
    row.modal_finite = error(modal, finite);
    if (linear) row.linear = first_impact(*linear, *linear);
    if (loose) row.loose = first_impact(*loose, *loose);
    if (finite) {
      row.finite = first_impact(*finite, *finite);
      row.strain = largest_principal(finite->bodies.front().strain);
      row.deformation = largest_deformation(*finite, of);
    }
    if (loose && linear) {
      const auto moved = [](double a, double b) { return std::abs(a / b - 1); };
      row.strain_moved =
          moved(largest_principal(loose->bodies.front().strain), largest_principal(linear->bodies.front().strain));
      row.deformation_moved = moved(largest_deformation(*loose, of), largest_deformation(*linear, of));
    }
    if (row.status.empty()) row.status = "ok";
    return row;
  }

 private:
  Model model(const Scene& scene) const {
    return model_of_own_mesh(std::make_shared<const Scene>(scene), own_meshes(scene_));
  }
  static Model with_scene(const Model& of, const Scene& scene) {
    return {std::make_shared<const Scene>(scene), of.bodies};
  }

  template <class Answer>
  static std::optional<Trajectory> tried(const std::string& what, AmplitudeRow& row, const Answer& answer) {
    std::string reason;
    try {
      Trajectory found = answer();
      if (found.status == Status::ok) return found;
      reason = to_string(found.status);
    } catch (const std::exception& error) {
      reason = error.what();
    }
    row.status += (row.status.empty() ? "" : "; ") + what + ": " + reason;
    return {};
  }

  Trajectory full(const Model& of, const Scene& scene, double rtol) const {
    const Model model = with_scene(of, scene);
    Settings settings;
    settings.relative_tolerance = rtol;
    return context_.catalogue.method("full-order")
        .prepare(model, settings, context_.catalogue.integrator("sundials"))
        ->simulate({.t = sample_times(scene)});
  }

  Trajectory reduced(const Scene& scene, double time_step) const {
    const Model model = with_scene(linear_, scene);
    Settings settings;
    settings.time_step = time_step;
    const auto bases = std::make_shared<const FloatingBases>(floating_bases(model, modes_, true));
    return prepare_floating(bases, context_.catalogue.integrator("exact"), settings)
        ->simulate({.t = sample_times(scene)});
  }

  const AnalysisContext& context_;
  const Scene& scene_;
  int n_modes_;
  EvaluationPoints points_;  // of the first body
  Model linear_, finite_;
  std::vector<Modes> modes_;  // of every body
};

}  // namespace

std::vector<AmplitudeRow> amplitude_sweep(const AnalysisContext& context, const std::vector<double>& factors) {
  require_finite_possible(context.scene->bodies.front());
  const Sweep sweep(context);
  std::vector<AmplitudeRow> rows;
  for (const double factor : factors) rows.push_back(sweep.at(factor));
  return rows;
}

Passed where_passed(const VectorXd& x, const VectorXd& y, double limit) {
  Index below = -1;
  for (Index i = 0; i < x.size(); ++i) {
    if (!std::isfinite(y[i])) continue;
    if (y[i] <= limit) {
      below = i;
      continue;
    }
    if (below < 0) return {0, 0};
    const double share = std::log(limit / y[below]) / std::log(y[i] / y[below]);
    const double at = x[below] * std::pow(x[i] / x[below], share);
    return {at, std::max(x[i] - at, at - x[below])};
  }
  return {std::numeric_limits<double>::infinity(), 0};
}

double largest_principal(const MatrixXd& strain) {
  const auto all = strain.reshaped(6, strain.size() / 6);
  double largest = 0;
  for (Index i = 0; i < all.cols(); ++i) {
    const auto e = all.col(i);
    Eigen::Matrix3d E;
    E << e[0], e[5] / 2, e[4] / 2, e[5] / 2, e[1], e[3] / 2, e[4] / 2, e[3] / 2, e[2];
    const Vector3d principal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(E, Eigen::EigenvaluesOnly).eigenvalues();
    largest = std::max(largest, principal.cwiseAbs().maxCoeff());
  }
  return largest;
}

}  // namespace mb
