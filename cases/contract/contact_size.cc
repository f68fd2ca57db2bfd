#include "cases/contract/contact_size.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "mechanics/contact/hertz.h"
#include "mechanics/contact/hertz_motion.h"
#include "mechanics/geometry/signed_distance.h"

namespace mb {

namespace {

constexpr double flat = 0.05;           // [-] curvature by extent below which a contact is not a point
constexpr double sharpest = 50;         // [-] curvature by extent: edges and corners count as rounded off
constexpr double widest = 0.5;          // [-] contact radius by radius of curvature: beyond, Hertz's says nothing
constexpr double rounding = 1e-12;      // [-] of the wave speed
constexpr double unpressed = 1e-3;      // [-] approach by extent, where nothing is known to press
constexpr double layer_stiffness = 100; /* [-] k_n a / E* */

double youngs_modulus(const Material& m) {
  return m.orthotropy ? m.orthotropy->youngs_moduli.maxCoeff() : m.youngs_modulus;
}
double contact_modulus_of(const Material& m) {
  const double nu = m.orthotropy ? 0 : m.poissons_ratio;
  return youngs_modulus(m) / (1 - nu * nu);
}

// Hessian [1/m] of the shape's distance at X, touched from outside, n. It is that of the surface parallel to it a
// little outside, where edges and corners have one, too: curvature k becomes k/(1 + e k).
Eigen::Matrix3d shape_hessian(const Shape& shape, const Vector3d& X, const Vector3d& n) {
  const double e = extent(shape) / sharpest / 4;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(signed_distance(shape, X + e * n).hessian);
  const Vector3d k = eigen.eigenvalues().unaryExpr([&](double parallel) {
    const double left = 1 - e * parallel;
    return left > 0.25 / sharpest ? parallel / left : sharpest / extent(shape);
  });
  return eigen.eigenvectors() * k.asDiagonal() * eigen.eigenvectors().transpose();
}

// Principal curvatures [1/m] of the gap, k_1 <= k_2: the body's and the obstacle's together, across the normal.
Eigen::Vector2d curvatures(const Body& body, const Vector3d& X, const Pose& pose, const Gap& at) {
  const Eigen::Matrix3d Q = pose.orientation.toRotationMatrix();
  const Eigen::Matrix3d sum = Q * shape_hessian(body.shape, X, Q.transpose() * -at.normal) * Q.transpose() + at.hessian;
  const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - at.normal * at.normal.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(across * sum * across);
  Eigen::Index along = 0;
  (eigen.eigenvectors().transpose() * at.normal).cwiseAbs().maxCoeff(&along);
  const double k_a = eigen.eigenvalues()[along == 0 ? 1 : 0], k_b = eigen.eigenvalues()[along == 2 ? 1 : 2];
  const double most = sharpest / extent(body.shape);
  return {std::clamp(std::min(k_a, k_b), 0.0, most), std::clamp(std::max(k_a, k_b), 0.0, most)};
}

// How far the shape extends along a direction of its frame [m].
double height(const Shape& shape, const Vector3d& n) {
  const Matrix3Xd points = surface_quadrature(shape).points;
  const Eigen::RowVectorXd along = n.transpose() * points;
  return along.maxCoeff() - along.minCoeff();
}

// Of the body alone, or of both.
double effective_modulus(const Body& body, const Body* partner) {
  const double own = contact_modulus_of(body.material);
  return partner ? 1 / (1 / own + 1 / contact_modulus_of(partner->material)) : own;
}
double mass_of(const Body& body) { return body.material.density * volume(body.shape); }
double effective_mass(const Body& body, const Body* partner) {
  if (!partner || is_held(*partner)) return mass_of(body);
  return is_held(body) ? mass_of(*partner) : 1 / (1 / mass_of(body) + 1 / mass_of(*partner));
}

struct Press {
  double mass, speed, weight;  // [kg], [m/s], [N]
  double approach;             // [m] that is taken where neither speed nor weight presses, else 0
};

ContactSize point_contact(const Press& press, double modulus, double radius) {
  const double k = 4.0 / 3 * modulus * std::sqrt(radius);
  // The speed at which an impact would reach the approach that the weight makes: m v^2/2 = 2/5 k delta^(5/2).
  const double resting = std::max(press.approach, std::pow(press.weight / k, 2.0 / 3));
  const double speed = std::max(press.speed, std::sqrt(0.8 * k * std::pow(resting, 2.5) / press.mass));
  const HertzPeaks peaks = hertz_peaks({press.mass, k, speed});
  const double a = std::min(std::sqrt(radius * peaks.approach), widest * radius);
  return {modulus, a, peaks.approach, speed, peaks.duration, peaks.force, 0, 1 / radius};
}

ContactSize flat_contact(const Press& press, const Body& body, double modulus, double l) {
  const double c = std::sqrt(youngs_modulus(body.material) / body.material.density), A = volume(body.shape) / l;
  const double impedance = body.material.density * c * A;
  const double speed = std::max({press.speed, press.weight / impedance, press.approach * c / l});
  return {modulus, std::sqrt(A / pi), speed * l / c, speed, 2 * l / c, impedance * speed, 0, 0};
}

}  // namespace

ContactSize contact_size(const Body& body, const ContactPair& pair, const Vector3d& X, const Pose& pose, const Gap& at,
                         double speed, const Vector3d& gravity, const Body* partner) {
  const double mass = effective_mass(body, partner);
  const double c = std::sqrt(youngs_modulus(body.material) / body.material.density);
  const double felt = speed > rounding * c ? speed : 0;  // along a wall the speed towards it is rounding
  Press press{mass, felt, std::max(0.0, -mass * gravity.dot(at.normal)), 0};
  if (!(press.speed > 0 || press.weight > 0)) press.approach = unpressed * extent(body.shape);
  const Eigen::Vector2d k = curvatures(body, X, pose, at);
  const double modulus = effective_modulus(body, partner), l = extent(body.shape);
  ContactSize size =
      k[1] * l < flat ? flat_contact(press, body, modulus, height(body.shape, pose.orientation.conjugate() * at.normal))
                      : point_contact(press, modulus, 1 / std::sqrt(std::max(k[0], flat / l) * k[1]));
  size.stiffness = pair.stiffness > 0 ? pair.stiffness : layer_stiffness * modulus / size.radius;
  return size;
}

ContactSize strike_size(const Body& body, const ContactPair& pair, const Obstacle& obstacle) {
  const auto* shape = std::get_if<Shape>(&obstacle.surface.shape);
  const Sphere* ball = shape ? std::get_if<Sphere>(shape) : nullptr;
  if (!ball || !obstacle.striker)
    throw std::invalid_argument("obstacle '" + obstacle.name + "' is no ball that strikes '" + body.name + "'");
  const Striker& striker = *obstacle.striker;
  const double modulus = contact_modulus(body.material, {striker.youngs_modulus, striker.poissons_ratio, 1});
  const double k = pair.stiffness > 0 ? pair.stiffness : hertz_stiffness({ball->radius, modulus});
  const HertzPeaks peaks = hertz_peaks({striker.mass, k, striker.speed});
  return {modulus,
          std::sqrt(ball->radius * peaks.approach),
          peaks.approach,
          striker.speed,
          peaks.duration,
          peaks.force,
          k,
          1 / ball->radius};
}

}  // namespace mb
