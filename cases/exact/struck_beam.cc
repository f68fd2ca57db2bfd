#include "cases/exact/struck_beam.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "cases/contract/touchdown.h"
#include "cases/exact/fit.h"
#include "cases/exact/timoshenko_impact.h"

namespace mb {
namespace {

constexpr Index n_modes = 160;          // odd ones: those left out have 5e-9 of the compliance
constexpr double steps_of_touch = 3000; /* [-] Hertz's duration by a step */

std::string problem(const Scene& scene) { return one_struck_undamped_body(scene, Theory::euler_bernoulli).text(); }

BeamImpact impact_of(const Scene& scene, double stiffness) {
  const Body& body = scene.bodies[0];
  const Vector3d size = std::get<Box>(body.shape).size;
  const Striker& striker = *striker_of(scene, body)->striker;
  const double area = size.y() * size.z();
  return {size.x(),
          body.material.youngs_modulus * area * size.z() * size.z() / 12,
          body.material.density * area,
          striker.mass,
          stiffness,
          striker.speed};
}

// The numbers of the samples that the times are.
std::vector<Index> samples_at(const VectorXd& t, double rate) {
  std::vector<Index> samples;
  for (const double time : t) {
    const double sample = std::round(time * rate);
    if (!(time >= 0 && std::abs(time * rate - sample) <= 1e-6))
      throw std::invalid_argument(fmt::format("timoshenko-impact: {} s is no multiple of 1/{} s", time, rate));
    samples.push_back(static_cast<Index>(sample));
  }
  return samples;
}

// Of the beam's axis at one x, times x samples: w, w', w'' upwards.
struct Axis {
  VectorXd w, slope, bend;
};
Axis axis_at(const BeamImpact& impact, const BeamMotion& motion, double x) {
  const double L = impact.length, EI = impact.bending_stiffness, xi = L / 2 - std::abs(x), side = x < 0 ? 1 : -1;
  const VectorXd n = VectorXd::LinSpaced(n_modes, 1, 2.0 * n_modes - 1), k = n * pi / L;
  const VectorXd compliance = 2 / (L * EI) * k.array().pow(-4);
  const VectorXd c = (k * x).array().cos(), s = (k * x).array().sin();
  const auto sum = [&](const VectorXd& shape, double by_force) -> VectorXd {
    return -(motion.modes.transpose() * shape + (by_force - compliance.dot(shape)) * motion.force);
  };
  return {sum(c, xi * (3 * L * L - 4 * xi * xi) / (48 * EI)),
          sum(-k.cwiseProduct(s), side * (L * L - 4 * xi * xi) / (16 * EI)),
          sum(-k.cwiseAbs2().cwiseProduct(c), -xi / (2 * EI))};
}

ContactHistory contact_of(const BeamImpact& impact, const BeamMotion& motion, const std::vector<Index>& samples) {
  const auto n = static_cast<Index>(samples.size());
  ContactHistory contact{Matrix3Xd::Zero(3, n), Matrix3Xd::Zero(3, n), VectorXd(n), VectorXd::Zero(n), {}};
  for (Index j = 0; j < n; ++j) {
    const Index at = samples[static_cast<std::size_t>(j)];
    contact.force(2, j) = -motion.force[at];
    contact.impulse(2, j) = -impact.ball_mass * (impact.speed - motion.ball_rate[at]);
    contact.stored[j] = 0.4 * motion.force[at] * std::pow(motion.force[at] / impact.contact_stiffness, 2.0 / 3);
  }
  const double last = motion.t[motion.t.size() - 1];
  const double end = motion.touch_end < last ? motion.touch_end : std::numeric_limits<double>::infinity();
  if (motion.peak > 0)
    contact.touches.push_back({0, end, motion.peak, motion.peak_time, -motion.impulse * Vector3d::UnitZ()});
  return contact;
}

Trajectory at(const Scene& scene, const EvaluationPoints& points, const VectorXd& t) {
  const ContactSize size = touchdown(scene, scene.bodies[0]).meetings.at(0).size;
  const BeamImpact impact = impact_of(scene, size.stiffness);
  const std::vector<Index> samples = samples_at(t, scene.samples_per_second);
  const double interval = 1 / scene.samples_per_second, nu = scene.bodies[0].material.poissons_ratio;
  const Index last = samples.empty() ? 1 : std::max<Index>(1, samples.back());
  const auto n_steps = static_cast<Index>(std::ceil(steps_of_touch * interval / size.duration));
  const BeamMotion motion = beam_impact(impact, {interval, last, n_steps, n_modes});
  const Matrix3Xd all = points.all();
  BodyTrajectory body{MatrixXd::Zero(3 * all.cols(), t.size()), MatrixXd::Zero(6 * points.n_strained(), t.size()),
                      contact_of(impact, motion, samples)};
  for (Index p = 0; p < all.cols(); ++p) {
    const Axis axis = axis_at(impact, motion, all(0, p));
    const double z = all(2, p);
    body.displacement.row(3 * p) = -z * axis.slope(samples).transpose();
    body.displacement.row(3 * p + 2) = axis.w(samples).transpose();
    const Index e = points.strained(p);
    if (e < 0) continue;
    body.strain.row(6 * e) = -z * axis.bend(samples).transpose();
    for (const Index across : {1, 2}) body.strain.row(6 * e + across) = -nu * body.strain.row(6 * e);
  }
  return {t, {body}, {}, Status::ok};
}

}  // namespace

ExactSolution struck_beam() {
  return {"timoshenko-impact",
          "simply supported Euler-Bernoulli beam, struck by a rigid ball in the middle: Volterra's equation",
          "Timoshenko 1913, Z. Math. Phys. 62, 198-209; Goldsmith 1960, Impact, sect. 4.4",
          problem,
          at,
          1e-6};  // of the march's step, as halving it shows
}

}  // namespace mb
