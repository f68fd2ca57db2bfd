// Manufactured solutions of finite strain (finite_manufactured_test.h), at rest and in motion: orders in the mesh and
// in the step.
#include <gtest/gtest.h>

#include <cmath>

#include "mechanics/algebra/cholesky.h"
#include "mechanics/algebra/fitted_order_test.h"
#include "mechanics/algebra/worse_test.h"
#include "mechanics/system/newmark.h"
#include "mechanics/verified_test.h"
#include "reference/fem/finite_manufactured_test.h"
#include "reference/sundials/sundials.h"

namespace mb {
namespace {

using testing::Field;
using testing::FiniteBox;

double error_at_rest(const Resolution& mesh) {
  const FiniteBox box(mesh);
  const System& s = box.system();
  const VectorXd load = box.load([&](const Field& f) -> Vector3d { return -box.divergence(f, 0, 1, 0); });
  VectorXd u = s.u0, f;
  std::optional<Cholesky> factor;
  for (int part = 1; part <= 3; ++part)  // of the load
    for (int i = 0; i < 20; ++i) {
      EXPECT_TRUE(s.stored_energy->force(u, s.v0, f));
      const VectorXd r = load * part / 3 - f;
      if (r.norm() < 1e-11 * load.norm()) break;
      EXPECT_LT(i, 15);
      SparseMatrix K = 0 * s.K;
      EXPECT_TRUE(s.stored_energy->add_tangent(u, 1, 0, K));
      factor ? factor->refactor(K) : void(factor.emplace(K));
      u += factor->solve(r);
    }
  return box.error(u, 1);
}

// Largest distance of the order in the mesh from p + 1, over p: of three meshes whose cells are alike, of cubics two.
template <typename Error>
double distance_of_orders(const Error& error) {
  struct Series {
    int degree;
    std::vector<std::vector<int>> meshes;
  };
  double off = 0;
  for (const auto& [degree, meshes] : {Series{1, {{4, 4, 6}, {6, 6, 9}, {8, 8, 12}}},
                                       {2, {{2, 2, 4}, {3, 3, 6}, {4, 4, 8}}},
                                       {3, {{2, 2, 3}, {4, 4, 6}}}}) {
    std::vector<double> size, errors;
    for (const std::vector<int>& cells : meshes) {
      size.push_back(1. / cells[0]);
      errors.push_back(error(Resolution{degree, cells}));
    }
    const double order = testing::fitted_order(size, errors);
    off = worse(off, std::abs(order - (degree + 1)));
  }
  return off;
}

TEST(FiniteStrainVerification, ManufacturedSolutionsConvergeAtFullOrder) {
  EXPECT_GT(FiniteBox({1, {4, 4, 6}}).largest_gradient(), 0.3);
  testing::expect_verified(
      {.quantity =
           "distance of the order in the mesh from p + 1, absolute: elements of degree p = 1, 2, 3, displacement of "
           "a neo-Hookean box at rest under large strain, L2 norm",
       .reference = "manufactured solution",
       .source = "a field of sines; its body force by hand from the stress that the material states",
       .uncertainty = "1e-11 of the load, at which Newton's method stops",
       .tolerance = 0.1,
       .why = "On two to twelve cells a side the error's next term is left, on either side: 0.07 was seen."},
      distance_of_orders(error_at_rest));
}

constexpr double omega = 19;  // [rad/s] some third of the first mode's
constexpr double end = 0.4;   // [s] 1.2 periods
const Rayleigh damping{3.7, 2.3e-3};

// u = f sin(omega t). Its body force is periodic: so many of its harmonics as double precision tells.
class MovingBox {
 public:
  explicit MovingBox(const Resolution& mesh) : box_(mesh, damping), system_(box_.system()) {
    constexpr Index n_samples = 48, n_harmonics = n_samples / 2 - 1;
    MatrixXd sampled(system_.u0.size(), n_samples), waves(n_samples, 2 * n_harmonics + 1);
    for (Index k = 0; k < n_samples; ++k) {
      const double angle = 2 * pi * static_cast<double>(k) / n_samples;
      sampled.col(k) = box_.load([&](const Field& f) { return body_force(f, std::sin(angle), std::cos(angle)); });
      waves(k, 0) = 1.0 / n_samples;
      for (Index h = 1; h <= n_harmonics; ++h) {
        const double turned = static_cast<double>(h) * angle;
        waves.block<1, 2>(k, 2 * h - 1) << 2 * std::sin(turned) / n_samples, 2 * std::cos(turned) / n_samples;
      }
    }
    system_.F = sampled * waves;
    system_.s = {Step{}};
    for (Index h = 1; h <= n_harmonics; ++h) {
      const double omega_h = static_cast<double>(h) * omega;
      system_.s.insert(system_.s.end(), {Harmonic{omega_h}, Harmonic{.omega = omega_h, .phase = pi / 2}});
    }
    EXPECT_LT(system_.F.rightCols(2).norm(), 1e-9 * system_.F.norm()) << "the last harmonic";
    // The rate at which it starts is f's projection by energy, so that little else rings.
    const VectorXd elastic = box_.load([&](const Field& f) -> Vector3d { return -box_.divergence(f, 1, 0, 1); });
    system_.v0 = omega * Cholesky(system_.K).solve(elastic);
  }
  const System& system() const { return system_; }
  double error(const VectorXd& u) const { return box_.error(u, std::sin(omega * end)); }

 private:
  Vector3d body_force(const Field& f, double sine, double cosine) const {
    const Vector3d inertia = box_.density() * omega * (damping.alpha * cosine - omega * sine) * f.u;
    return inertia - box_.divergence(f, damping.beta, sine, omega * cosine);
  }

  FiniteBox box_;
  System system_;
};

VectorXd at_the_end(const Stepper& stepper) {
  const States states = stepper.run(VectorXd::Constant(1, end));
  EXPECT_EQ(states.status, Status::ok);
  return states.u.col(0);
}

TEST(FiniteStrainVerification, ManufacturedMotionsConvergeAtFullOrder) {
  const auto error = [](const Resolution& mesh) {
    const MovingBox box(mesh);
    return box.error(at_the_end(*sundials(box.system(), 1e-6, end)));
  };
  testing::expect_verified(
      {.quantity = "distance of the order in the mesh from p + 1, absolute: elements of degree p = 1, 2, 3, "
                   "displacement of a neo-Hookean box in damped motion of large strain, L2 norm",
       .reference = "manufactured solution",
       .source = "a field of sines times a sine of time; its body force by hand from the stresses that the material "
                 "states, as 23 harmonics",
       .uncertainty = "1e-6 of the displacement, the tolerance of the steps in time",
       .tolerance = 0.1,
       .why = "On two to twelve cells a side the error's next term is left, on either side: 0.07 was seen."},
      distance_of_orders(error));
}

TEST(FiniteStrainVerification, AverageAccelerationIsOfOrderTwo) {
  const MovingBox box({2, {2, 2, 3}});
  const VectorXd truth = at_the_end(*sundials(box.system(), 1e-9, end));
  const auto error = [&](int n) { return (at_the_end(*newmark(box.system(), end / n)) - truth).norm() / truth.norm(); };
  const std::vector<double> steps{end / 200, end / 400, end / 800}, errors{error(200), error(400), error(800)};
  testing::expect_verified(
      {.quantity = "distance of the order in the step from 2, absolute: average acceleration, displacement of a "
                   "neo-Hookean box in damped motion of large strain",
       .reference = "second route",
       .source = "adaptive Runge-Kutta steps of the same mesh, relative tolerance 1e-9",
       .uncertainty = "1e-9 of the displacement",
       .tolerance = 0.1,
       .why = "Of two halvings of the step the error's next term is left."},
      std::abs(testing::fitted_order(steps, errors) - 2));
}

}  // namespace
}  // namespace mb
