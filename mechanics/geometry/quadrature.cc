// Product rules on the exact shapes. Gauss in every direction but the circular one, where equally spaced points are
// best; radii are Gauss in r^2 (disc) or r^3 (ball), whose measure is uniform.
#include <algorithm>
#include <array>
#include <cmath>

#include "mechanics/geometry/gauss.h"
#include "mechanics/geometry/overloaded.h"
#include "mechanics/geometry/shape.h"
#include "mechanics/geometry/superquadric_quadrature.h"

namespace mb {

namespace {

constexpr int n_volume = 300, n_surface = 200;  // about; enough for norms of smooth fields to 1e-3

Quadrature concatenate(const std::vector<Quadrature>& parts) {
  Index n = 0;
  for (const auto& part : parts) n += part.weights.size();
  Quadrature all{Matrix3Xd(3, n), VectorXd(n)};
  Index at = 0;
  for (const auto& part : parts) {
    const Index size = part.weights.size();
    all.points.middleCols(at, size) = part.points;
    all.weights.segment(at, size) = part.weights;
    at += size;
  }
  return all;
}

// Points of one box edge per direction, so that spacings are alike and the product is about n.
std::array<int, 3> box_counts(const Vector3d& size, int n, int fixed_axis) {
  double measure = 1;
  for (int i = 0; i < 3; ++i) measure *= i == fixed_axis ? 1 : size[i];
  const double spacing = std::pow(measure / n, fixed_axis < 0 ? 1.0 / 3 : 1.0 / 2);
  std::array<int, 3> counts{1, 1, 1};
  for (int i = 0; i < 3; ++i)
    if (i != fixed_axis) counts[i] = std::clamp(static_cast<int>(std::lround(size[i] / spacing)), 3, 60);
  return counts;
}

// Gauss product over a box; along fixed_axis (if >= 0) the single coordinate `at`.
Quadrature box_rule(const Vector3d& size, int n, int fixed_axis = -1, double at = 0) {
  const auto counts = box_counts(size, n, fixed_axis);
  std::array<Rule, 3> rules;
  for (int i = 0; i < 3; ++i) {
    if (i == fixed_axis) {
      rules[i] = {VectorXd::Constant(1, at), VectorXd::Ones(1)};
    } else {
      rules[i] = gauss_legendre(counts[i]);
      rules[i].x = size[i] * (rules[i].x.array() - 0.5);
      rules[i].w *= size[i];
    }
  }
  const Index total = rules[0].x.size() * rules[1].x.size() * rules[2].x.size();
  Quadrature q{Matrix3Xd(3, total), VectorXd(total)};
  Index p = 0;
  for (Index k = 0; k < rules[2].x.size(); ++k)
    for (Index j = 0; j < rules[1].x.size(); ++j)
      for (Index i = 0; i < rules[0].x.size(); ++i, ++p) {
        q.points.col(p) << rules[0].x[i], rules[1].x[j], rules[2].x[k];
        q.weights[p] = rules[0].w[i] * rules[1].w[j] * rules[2].w[k];
      }
  return q;
}

// Discs of radius R at the heights z, each with the weight wz: n_r radii times n_phi angles.
Quadrature disc_rule(double radius, int n_r, int n_phi, const VectorXd& z, const VectorXd& wz) {
  const Rule radial = gauss_legendre(n_r);
  const Index total = n_r * n_phi * z.size();
  Quadrature q{Matrix3Xd(3, total), VectorXd(total)};
  Index p = 0;
  for (Index k = 0; k < z.size(); ++k)
    for (int i = 0; i < n_r; ++i)
      for (int j = 0; j < n_phi; ++j, ++p) {
        const double r = radius * std::sqrt(radial.x[i]), phi = 2 * pi * (j + 0.5 * (i % 2)) / n_phi;
        q.points.col(p) << r * std::cos(phi), r * std::sin(phi), z[k];
        q.weights[p] = pi * radius * radius * radial.w[i] / n_phi * wz[k];
      }
  return q;
}

Quadrature lateral_rule(const Cylinder& c, int n_phi, int n_z) {
  const Rule axial = gauss_legendre(n_z);
  Quadrature q{Matrix3Xd(3, n_phi * n_z), VectorXd(n_phi * n_z)};
  Index p = 0;
  for (int k = 0; k < n_z; ++k)
    for (int j = 0; j < n_phi; ++j, ++p) {
      const double phi = 2 * pi * j / n_phi;
      q.points.col(p) << c.radius * std::cos(phi), c.radius * std::sin(phi), c.length * (axial.x[k] - 0.5);
      q.weights[p] = 2 * pi * c.radius / n_phi * c.length * axial.w[k];
    }
  return q;
}

// Spheres of the radii r with the weights w: Gauss in cos(theta), equal angles in phi.
Quadrature sphere_rule(const VectorXd& r, const VectorXd& w, int n_theta, int n_phi) {
  const Rule polar = gauss_legendre(n_theta);
  const Index total = r.size() * n_theta * n_phi;
  Quadrature q{Matrix3Xd(3, total), VectorXd(total)};
  Index p = 0;
  for (Index i = 0; i < r.size(); ++i)
    for (int k = 0; k < n_theta; ++k)
      for (int j = 0; j < n_phi; ++j, ++p) {
        const double z = 2 * polar.x[k] - 1, s = std::sqrt(1 - z * z), phi = 2 * pi * j / n_phi;
        q.points.col(p) = r[i] * Vector3d(s * std::cos(phi), s * std::sin(phi), z);
        q.weights[p] = w[i] * polar.w[k] / n_phi;
      }
  return q;
}

Quadrature cylinder_volume(const Cylinder& c) {
  const int n_z = std::clamp(static_cast<int>(std::lround(5 * c.length / (2 * c.radius))), 6, 60);
  const Rule axial = gauss_legendre(n_z);
  return disc_rule(c.radius, 4, 8, c.length * (axial.x.array() - 0.5), c.length * axial.w);
}

Quadrature cylinder_surface(const Cylinder& c) {
  const VectorXd ends = (VectorXd(2) << -0.5 * c.length, 0.5 * c.length).finished();
  const int n_z = std::clamp(static_cast<int>(std::lround(6 * c.length / (2 * c.radius))), 6, 60);
  return concatenate({lateral_rule(c, 12, n_z), disc_rule(c.radius, 3, 10, ends, VectorXd::Ones(2))});
}

Quadrature box_surface(const Box& b) {
  const Vector3d& s = b.size;
  const Vector3d area(s[1] * s[2], s[0] * s[2], s[0] * s[1]);
  std::vector<Quadrature> faces;
  for (int axis = 0; axis < 3; ++axis) {
    const int n = static_cast<int>(std::lround(n_surface * area[axis] / (2 * area.sum())));
    for (const double sign : {-0.5, 0.5}) faces.push_back(box_rule(s, std::max(n, 9), axis, sign * s[axis]));
  }
  return concatenate(faces);
}

Quadrature ball_volume(const Sphere& s) {
  const Rule radial = gauss_legendre(4);
  const VectorXd r = s.radius * radial.x.array().pow(1.0 / 3);
  return sphere_rule(r, volume(Shape{s}) * radial.w, 6, 12);
}

}  // namespace

Quadrature volume_quadrature(const Shape& shape) {
  return std::visit(
      overloaded{[](const Box& b) { return box_rule(b.size, n_volume); },
                 [](const Cylinder& c) { return cylinder_volume(c); }, [](const Sphere& s) { return ball_volume(s); },
                 [](const Superquadric& s) { return superquadric_volume_quadrature(s); },
                 [](const TaperedSuperquadric& s) { return superquadric_volume_quadrature(s); }},
      shape);
}

Quadrature surface_quadrature(const Shape& shape) {
  return std::visit(
      overloaded{[](const Box& b) { return box_surface(b); }, [](const Cylinder& c) { return cylinder_surface(c); },
                 [](const Sphere& s) {
                   return sphere_rule(VectorXd::Constant(1, s.radius),
                                      VectorXd::Constant(1, 4 * pi * s.radius * s.radius), 10, 20);
                 },
                 [](const Superquadric& s) { return superquadric_surface_quadrature(s); },
                 [](const TaperedSuperquadric& s) { return superquadric_surface_quadrature(s); }},
      shape);
}

}  // namespace mb
