#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "harness/metrics/contact_metrics.h"
#include "harness/metrics/finite_metrics.h"
#include "harness/metrics/linearity.h"
#include "harness/metrics/metric.h"
#include "harness/metrics/motion.h"
#include "harness/metrics/signal.h"
#include "harness/metrics/spectrum.h"

namespace mb {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

const Body& body(const MetricContext& context) { return context.scene.bodies[static_cast<std::size_t>(context.body)]; }

double ratio(double error, double size) { return size > 0 ? error / size : nan; }

// sum_t tau sum_i w_i |d_i|^2 of 3 p x n_t values; w [m^3]. The constant density cancels in every ratio.
template <class Values>
double squared_norm(const Values& d, const VectorXd& w, const VectorXd& tau) {
  const VectorXd w3 = w.replicate(1, 3).transpose().reshaped();
  double sum = 0;
  for (Index k = 0; k < d.cols(); ++k) sum += tau(k) * d.col(k).cwiseAbs2().dot(w3);
  return sum;
}

double displacement_error(const Trajectory& answer, const Trajectory& truth, const MetricContext& context) {
  const MatrixXd d = motion(answer, context).volume, d_true = motion(truth, context).volume;
  const VectorXd tau = trapezoid_weights(truth.t);
  const VectorXd& w = context.points.volume.weights;
  return std::sqrt(ratio(squared_norm(d - d_true, w, tau), squared_norm(d_true, w, tau)));
}

double squared_energy_norm(const MatrixXd& strain, const Matrix6d& D, const VectorXd& w, const VectorXd& tau) {
  double sum = 0;
  for (Index k = 0; k < strain.cols(); ++k) {
    const auto eps = strain.col(k).reshaped(6, w.size());
    sum += tau(k) * (eps.cwiseProduct(D * eps) * w).sum();
  }
  return sum;
}

double strain_error(const Trajectory& answer, const Trajectory& truth, const MetricContext& context) {
  const MatrixXd& all = answer.bodies[static_cast<std::size_t>(context.body)].strain;
  const MatrixXd& all_true = truth.bodies[static_cast<std::size_t>(context.body)].strain;
  if (all.cols() == 0 || all_true.cols() == 0) return nan;
  const Index n = 6 * context.points.volume.weights.size();
  const auto eps = all.topRows(n), eps_true = all_true.topRows(n);
  const Matrix6d D = elasticity_matrix(body(context).material);
  const VectorXd tau = trapezoid_weights(truth.t);
  const VectorXd w = stiffness_weights(body(context).material, context.points.volume);
  return std::sqrt(ratio(squared_energy_norm(eps - eps_true, D, w, tau), squared_energy_norm(eps_true, D, w, tau)));
}

double surface_deviation(const Trajectory& answer, const Trajectory& truth, const MetricContext& context) {
  const MatrixXd gap = motion(answer, context).surface - motion(truth, context).surface;
  if (gap.size() == 0) return nan;
  return gap.reshaped(3, gap.size() / 3).colwise().norm().maxCoeff() / extent(body(context).shape);
}

double pose_translation(const Trajectory& answer, const Trajectory& truth, const MetricContext& context) {
  const auto frames = motion(answer, context).frames, frames_true = motion(truth, context).frames;
  double largest = 0;
  for (std::size_t k = 0; k < frames.size(); ++k) largest = std::max(largest, (frames[k].c - frames_true[k].c).norm());
  return largest;
}

double pose_rotation(const Trajectory& answer, const Trajectory& truth, const MetricContext& context) {
  const auto frames = motion(answer, context).frames, frames_true = motion(truth, context).frames;
  double largest = 0;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    largest = std::max(largest, angle_between(frames[k].R, frames_true[k].R));
  }
  return largest;
}

// [m] over all points and times, rigid motion included.
double largest_displacement(const Trajectory& truth, const MetricContext& context) {
  const MatrixXd& u = truth.bodies[static_cast<std::size_t>(context.body)].displacement;
  return u.size() == 0 ? 0 : u.reshaped(3, u.size() / 3).colwise().norm().maxCoeff();
}

double deviation_size(const Trajectory& truth, const MetricContext& context) {
  return largest_displacement(truth, context) / extent(body(context).shape);
}

double radius_of_gyration(const MetricContext& context) {  // [m]
  const auto& [X, w] = context.points.volume;
  const Matrix3Xd arms = X.colwise() - centroid(X, w);
  return std::sqrt(arms.colwise().squaredNorm().dot(w) / w.sum());
}
// [rad] that displacement turns a body by, there.
double rotation_size(const Trajectory& truth, const MetricContext& context) {
  return largest_displacement(truth, context) / radius_of_gyration(context);
}

// The place of the probe among those of its body.
Index place_of_probe(const MetricContext& context) {
  const auto& probes = context.scene.probes;
  const auto probe = probes.begin() + context.probe;
  return std::count_if(probes.begin(), probe, [&](const Probe& p) { return p.body == probe->body; });
}

// u(point) . direction [m] over time, rigid motion included; zero where it is rounding of the body's motion, whose
// phase says nothing.
VectorXd probe_signal(const Trajectory& trajectory, const MetricContext& context) {
  constexpr double rounding = 1e-12;  // [-] what stored trajectories keep of the values, see trajectory_file.h
  const auto probe = context.scene.probes.begin() + context.probe;
  const Index point =
      context.points.volume.points.cols() + context.points.surface.points.cols() + place_of_probe(context);
  const MatrixXd& u = trajectory.bodies[static_cast<std::size_t>(context.body)].displacement;
  const VectorXd signal = u.middleRows(3 * point, 3).transpose() * probe->direction;
  const bool heard = !(signal.lpNorm<Eigen::Infinity>() <= rounding * u.lpNorm<Eigen::Infinity>());
  return heard ? signal : VectorXd::Zero(signal.size());
}

// [-] A quiet probe has more of an error that is relative to the body's largest motion.
double probe_size(const Trajectory& truth, const MetricContext& context) {
  return largest_displacement(truth, context) / probe_signal(truth, context).cwiseAbs().maxCoeff();
}

// The largest deformation [m] over points and times: rigid motion taken out of free bodies.
double largest_deformation(const Trajectory& truth, const MetricContext& context) {
  const FramedMotion deformed = motion(truth, context);
  double largest = 0;
  for (const MatrixXd* u : {&deformed.volume, &deformed.surface})
    if (u->size() > 0) largest = std::max(largest, u->reshaped(3, u->size() / 3).colwise().norm().maxCoeff());
  return largest;
}
// [rad] A frame is fitted to what deforms with it.
double rotation_share(const Trajectory& truth, const MetricContext& context) {
  return largest_deformation(truth, context) / radius_of_gyration(context);
}
double deviation_share(const Trajectory& truth, const MetricContext& context) {
  return largest_deformation(truth, context) / extent(body(context).shape);
}
double probe_share(const Trajectory& truth, const MetricContext& context) {
  return largest_deformation(truth, context) / probe_signal(truth, context).cwiseAbs().maxCoeff();
}

double probe_error(const Trajectory& answer, const Trajectory& truth, const MetricContext& context) {
  return relative_l2(trapezoid_weights(truth.t), probe_signal(answer, context), probe_signal(truth, context));
}

SpragueGeers probe_marks(const Trajectory& answer, const Trajectory& truth, const MetricContext& context) {
  return sprague_geers(trapezoid_weights(truth.t), probe_signal(answer, context), probe_signal(truth, context));
}
double probe_magnitude(const Trajectory& answer, const Trajectory& truth, const MetricContext& context) {
  return probe_marks(answer, truth, context).magnitude;
}
double probe_phase(const Trajectory& answer, const Trajectory& truth, const MetricContext& context) {
  return probe_marks(answer, truth, context).phase;
}
double probe_combined(const Trajectory& answer, const Trajectory& truth, const MetricContext& context) {
  return probe_marks(answer, truth, context).combined;
}

using Stresses = Eigen::Matrix<double, 6, Eigen::Dynamic>;
VectorXd equivalent(Stresses s) {     // sqrt(3/2 s:s), column by column
  s.bottomRows(3) *= std::sqrt(2.0);  // each shear stress stands twice in s:s
  return std::sqrt(1.5) * s.colwise().norm().transpose();
}

// [Pa] von Mises' equivalent stress at a probe over time, sqrt(3/2 s:s) of the deviator s.
VectorXd von_mises_signal(const Trajectory& trajectory, const MetricContext& context) {
  const MatrixXd& strain = trajectory.bodies[static_cast<std::size_t>(context.body)].strain;
  const Index place = context.points.volume.points.cols() + place_of_probe(context);
  const Material& material = body(context).material;
  const Vector3d X = context.scene.probes[static_cast<std::size_t>(context.probe)].point;
  Stresses s = stiffness_factor(material, X) * elasticity_matrix(material) * strain.middleRows(6 * place, 6);
  s.topRows(3).rowwise() -= s.topRows(3).colwise().mean().eval();
  return equivalent(s);
}

// [-] Of the largest stress anywhere, its mean part included, to the largest equivalent one at the probe.
double stress_size(const Trajectory& truth, const MetricContext& context) {
  const MatrixXd& strain = truth.bodies[static_cast<std::size_t>(context.body)].strain;
  if (strain.cols() == 0) return nan;
  const Material& material = body(context).material;
  const VectorXd factors = stiffness_factors(material, context.points.strained()).replicate(strain.cols(), 1);
  const Stresses all = elasticity_matrix(material) * strain.reshaped(6, factors.size()) * factors.asDiagonal();
  return equivalent(all).maxCoeff() / von_mises_signal(truth, context).maxCoeff();
}

double probe_von_mises(const Trajectory& answer, const Trajectory& truth, const MetricContext& context) {
  for (const Trajectory* one : {&answer, &truth})
    if (one->bodies[static_cast<std::size_t>(context.body)].strain.cols() == 0) return nan;
  return relative_l2(trapezoid_weights(truth.t), von_mises_signal(answer, context), von_mises_signal(truth, context));
}

double truth_above_band(const Trajectory&, const Trajectory& truth, const MetricContext& context) {
  const Index n = truth.t.size();
  if (n < 8) return nan;  // a window of fewer samples tells no frequencies apart
  const double step = (truth.t(n - 1) - truth.t(0)) / static_cast<double>(n - 1);
  const VectorXd steps = truth.t.tail(n - 1) - truth.t.head(n - 1);
  if (!((steps.array() - step).abs().maxCoeff() <= 1e-6 * step)) {
    throw std::invalid_argument("metric truth-above-band: times are not equidistant");
  }
  const VectorXd w = context.points.volume.weights.replicate(1, 3).transpose().reshaped();
  return energy_share_above(motion(truth, context).volume, w, 1 / step, context.scene.samples_per_second / 20);
}

// A share of the energy, which goes with the square of the motion.
double all_of_it(const Trajectory&, const MetricContext&) { return 1; }

double truth_strain(const Trajectory&, const Trajectory& truth, const MetricContext& context) {
  return largest_strain(truth, context);
}
double truth_rotation(const Trajectory&, const Trajectory& truth, const MetricContext& context) {
  return largest_rotation(truth, context);
}

Metric part(Metric metric, const char* whole, double (*share)(const Trajectory&, const MetricContext&)) {
  metric.whole = whole;
  metric.share = share;
  return metric;
}

std::vector<Metric> catalogue() {
  constexpr bool probe = true, free_only = true, truth_alone = true, no = false;
  constexpr auto displacement = "displacement-error", strain = "strain-error";
  return {
      relative({"displacement-error", "-",
                "Relative L2 error of the deformation over space (M norm) and time, each answer in its own best rigid "
                "frame where the body is free.",
                no, no, no, &displacement_error}),
      relative({"strain-error", "-",
                "Relative error of the linear strain in the K norm (strain energy, stands for stress) over space and "
                "time.",
                no, no, no, &strain_error}),
      part({"surface-deviation", "-",
            "Largest distance of the deformed surfaces over points and time, each answer in its own best rigid frame "
            "where the body is free, divided by the largest edge of the bounding box.",
            no, no, no, &surface_deviation, &deviation_size},
           displacement, &deviation_share),
      {"pose-translation", "m", "Largest distance of the centroids over time; free bodies only.", no, free_only, no,
       &pose_translation, &largest_displacement},
      part({"pose-rotation", "rad", "Largest angle between the best rigid frames over time; free bodies only.", no,
            free_only, no, &pose_rotation, &rotation_size},
           displacement, &rotation_share),
      relative(part({"probe-error", "-", "Relative L2 error over time of a probe's displacement along its direction.",
                     probe, no, no, &probe_error, &probe_size},
                    displacement, &probe_share)),
      relative(part(
          {"probe-magnitude", "-", "Sprague and Geers' M of a probe's signal: relative excess of its size, signed.",
           probe, no, no, &probe_magnitude, &probe_size},
          displacement, &probe_share)),
      part({"probe-phase", "-", "Sprague and Geers' P of a probe's signal: phase shift divided by pi, in [0, 1].",
            probe, no, no, &probe_phase, &probe_size},
           displacement, &probe_share),
      relative(part({"probe-combined", "-", "Sprague and Geers' C of a probe's signal: sqrt(M^2 + P^2).", probe, no, no,
                     &probe_combined, &probe_size},
                    displacement, &probe_share)),
      relative(part({"probe-von-mises", "-", "Relative L2 error over time of von Mises' equivalent stress at a probe.",
                     probe, no, no, &probe_von_mises, &stress_size},
                    strain, &stress_size)),
      part({"truth-above-band", "-",
            "Share of the kinetic energy of the truth's deformation (Hann window) above a twentieth of "
            "samples_per_second.",
            no, no, truth_alone, &truth_above_band},
           displacement, &all_of_it),
      part({"truth-strain", "-", "Largest principal strain of the truth over points and times.", no, no, truth_alone,
            &truth_strain},
           strain, &largest_strain),
      part(
          {"truth-rotation", "rad",
           "Largest rotation of a piece of the body in the truth's deformation, |curl u|/2 of polynomials of degree 3.",
           no, no, truth_alone, &truth_rotation},
          displacement, &largest_rotation),
  };
}

}  // namespace

const std::vector<Metric>& metric_catalogue() {
  static const std::vector<Metric> all = [] {
    std::vector<Metric> both = catalogue();
    std::ranges::copy(contact_metrics(), std::back_inserter(both));
    std::ranges::copy(finite_metrics(), std::back_inserter(both));
    return both;
  }();
  return all;
}

}  // namespace mb
