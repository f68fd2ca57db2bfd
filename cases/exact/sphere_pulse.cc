#include "cases/exact/sphere_pulse.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "cases/exact/fit.h"
#include "cases/exact/radial_modes.h"
#include "mechanics/system/exact.h"

namespace mb {
namespace {

constexpr double remainder = 1e-9;    // [-] of the series, relative to the peak
constexpr double nearest = 0.05;      // [-] r/a within which strains may keep fewer digits
constexpr Index most_modes = 400000;  // minutes; a pulse that needs more is as good as a jump

double longitudinal_speed(const Material& m) {
  const double nu = m.poissons_ratio;
  return std::sqrt(m.youngs_modulus * (1 - nu) / ((1 + nu) * (1 - 2 * nu)) / m.density);
}

double pulse_number(const SpherePulse& s) {  // Theta
  return 2 * pi * s.radius / (longitudinal_speed(s.material) * s.duration);
}

// Some consecutive modes as one diagonal system, the pulse its load.
System modal_system(const SpherePulse& sphere, const VectorXd& x, const VectorXd& N) {
  const double c = longitudinal_speed(sphere.material);
  const Index n = x.size();
  System system;
  system.M.resize(n, n);
  system.M.setIdentity();
  system.K = SparseMatrix((c / sphere.radius * x).cwiseAbs2().asDiagonal());
  system.R.resize(n, 0);
  system.F = (-2 * sphere.pressure / (sphere.material.density * sphere.radius) * N.cwiseInverse()).eval();
  system.s = {Pulse{sphere.duration}};
  system.u0 = system.v0 = VectorXd::Zero(n);
  return system;
}

// Adds the modes n_before + 1 ... n_before + count.
void add_modes(const SpherePulse& sphere, const VectorXd& r, const VectorXd& t, Index n_before, Index count,
               Series series, RadialField& field) {
  const double kappa = traction_ratio(sphere.material.poissons_ratio), a = sphere.radius;
  const VectorXd x = radial_roots(kappa, n_before, count);
  const VectorXd N = 1 - kappa * (3 - kappa) * x.array().square().inverse();
  const System system = modal_system(sphere, x, N);
  MatrixXd q = exact(system, std::max(t[t.size() - 1], sphere.duration))->run(t).u;
  if (series == Series::mode_acceleration) {
    const VectorXd statics = system.F.col(0).cwiseQuotient(system.K.diagonal());
    for (Index j = 0; j < t.size(); ++j) q.col(j) -= statics * value(system.s[0], t[j]);
  }
  MatrixXd u(r.size(), count), radial(r.size(), count), hoop(r.size(), count);
  for (Index n = 0; n < count; ++n) {
    const double at_surface = spherical_bessel(x[n]).j1;
    for (Index i = 0; i < r.size(); ++i) {
      const Bessel j = spherical_bessel(x[n] * r[i] / a);
      u(i, n) = j.j1 / at_surface;
      radial(i, n) = x[n] / a * j.derivative / at_surface;
      hoop(i, n) = x[n] / a * j.over_z / at_surface;
    }
  }
  field.u.noalias() += u * q;
  field.radial.noalias() += radial * q;
  field.hoop.noalias() += hoop * q;
}

std::string problem(const Scene& scene) {
  Misfit misfit = one_loaded_undamped_body(scene);
  if (!misfit.empty()) return misfit.text();
  const Body& body = scene.bodies[0];
  const Load& load = scene.loads[0];
  const Traction& traction = load.tractions[0];
  misfit.require(std::holds_alternative<Sphere>(body.shape), "the body is not a sphere");
  misfit.require(body.supports.empty(), "the sphere is not free");
  misfit.require(traction.patch.face == "surface", fmt::format("the load acts on {}", traction.patch.face));
  misfit.require(traction.traction.isZero(0), "the load is not a pressure alone");
  misfit.require(std::holds_alternative<Pulse>(load.history), "the history is not a pulse");
  if (!misfit.empty()) return misfit.text();
  const auto& pulse = std::get<Pulse>(load.history);
  misfit.require(pulse.start >= 0, fmt::format("the pulse starts at {} s, before the motion", pulse.start));
  const double a = std::get<Sphere>(body.shape).radius;
  const Index n_modes = modes_needed({a, body.material, 1, pulse.duration}, nearest * a, remainder);
  misfit.require(n_modes <= most_modes,
                 fmt::format("a pulse of {} s is too short: its series needs {} modes, more than {}", pulse.duration,
                             n_modes, most_modes));
  return misfit.text();
}

// Radii that differ by no more than rounding are one: a quadrature has a few hundred points on a few spheres.
struct Radii {
  VectorXd r;  // ascending
  std::vector<Index> of_point;
};
Radii distinct_radii(const Matrix3Xd& points, double a) {
  const VectorXd all = points.colwise().norm();
  std::vector<double> sorted(all.data(), all.data() + all.size()), distinct;
  std::sort(sorted.begin(), sorted.end());
  for (const double r : sorted)
    if (distinct.empty() || r > distinct.back() + 1e-14 * a) distinct.push_back(r);
  Radii radii{Eigen::Map<const VectorXd>(distinct.data(), static_cast<Index>(distinct.size())), {}};
  for (const double r : all) {
    const auto above = std::upper_bound(distinct.begin(), distinct.end(), r);
    radii.of_point.push_back(std::distance(distinct.begin(), above) - 1);
  }
  return radii;
}

// eps = radial n n^T + hoop (I - n n^T), Voigt with engineering shear
Eigen::Matrix<double, 6, 1> cartesian(double radial, double hoop, const Vector3d& n) {
  const double d = radial - hoop;
  Eigen::Matrix<double, 6, 1> strain;
  strain << hoop + d * n[0] * n[0], hoop + d * n[1] * n[1], hoop + d * n[2] * n[2], 2 * d * n[1] * n[2],
      2 * d * n[0] * n[2], 2 * d * n[0] * n[1];
  return strain;
}

Trajectory at(const Scene& scene, const EvaluationPoints& points, const VectorXd& t) {
  const Body& body = scene.bodies[0];
  const auto& pulse = std::get<Pulse>(scene.loads[0].history);
  const double a = std::get<Sphere>(body.shape).radius;
  const SpherePulse sphere{a, body.material, pulse.amplitude * scene.loads[0].tractions[0].pressure, pulse.duration};
  const Matrix3Xd all = points.all();
  const double inmost = points.n_strained() > 0 ? points.strained().colwise().norm().minCoeff() : a;
  const Radii radii = distinct_radii(all, a);
  const RadialField field =
      radial_field(sphere, radii.r, (t.array() - pulse.start).max(0),
                   modes_needed(sphere, std::max(inmost, nearest * a), remainder), Series::mode_acceleration);
  BodyTrajectory answer{MatrixXd(3 * all.cols(), t.size()), MatrixXd(6 * points.n_strained(), t.size())};
  for (Index p = 0; p < all.cols(); ++p) {
    const double r = all.col(p).norm();
    const Vector3d n = r > 0 ? Vector3d(all.col(p) / r) : Vector3d::UnitX();  // at the centre both strains agree
    const Index i = radii.of_point[static_cast<std::size_t>(p)];
    for (Index j = 0; j < t.size(); ++j) {
      answer.displacement.block<3, 1>(3 * p, j) = field.u(i, j) * n;
      if (const Index e = points.strained(p); e >= 0)
        answer.strain.block<6, 1>(6 * e, j) = cartesian(field.radial(i, j), field.hoop(i, j), n);
    }
  }
  return {t, {answer}, {}, Status::ok};
}

}  // namespace

RadialField radial_field(const SpherePulse& sphere, const VectorXd& r, const VectorXd& t, Index n_modes,
                         Series series) {
  constexpr Index block = 512;  // modes at once: bounds the memory of long series
  const MatrixXd zero = MatrixXd::Zero(r.size(), t.size());
  RadialField field{zero, zero, zero};
  if (r.size() == 0 || t.size() == 0) return field;
  if (series == Series::mode_acceleration) {
    const double bulk_modulus = sphere.material.youngs_modulus / (3 * (1 - 2 * sphere.material.poissons_ratio));
    const Pulse s{sphere.duration};
    for (Index j = 0; j < t.size(); ++j)
      field.hoop.col(j).setConstant(-sphere.pressure / (3 * bulk_modulus) * value(s, t[j]));
    field.radial = field.hoop;
    field.u = r.asDiagonal() * field.hoop;
  }
  for (Index n_before = 0; n_before < n_modes; n_before += block)
    add_modes(sphere, r, t, n_before, std::min(block, n_modes - n_before), series, field);
  return field;
}

Index modes_needed(const SpherePulse& sphere, double r_min, double bound) {
  const double Theta = pulse_number(sphere), a_over_r = sphere.radius / r_min;
  const double of_u = std::cbrt(2 * Theta * Theta / (std::pow(pi, 4) * bound));
  const double of_strain = Theta * std::sqrt(3 * a_over_r / (pi * pi * pi * bound));
  return static_cast<Index>(std::ceil(std::max({of_u, of_strain, 64.0})));
}

ExactSolution sphere_radial_pulse() {
  return {"sphere-radial-pulse",
          "free sphere under a uniform pressure pulse sin^2: radial modes with mode acceleration",
          "Lamb 1882, Proc. London Math. Soc. 13; Love 1944, Mathematical Theory of Elasticity, sects. 194-196",
          problem,
          at,
          remainder};
}

}  // namespace mb
