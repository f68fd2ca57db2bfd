// A ball pressed on a rigid plane and thrown on it, full order on graded meshes, against the exact contact of a finite
// sphere and its impact (cases/exact/sphere_on_plane.h, sphere_impact.h). a/R = 0.02, where Hertz's approach is off by
// 1.1 %.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "cases/exact/sphere_impact.h"
#include "cases/exact/sphere_on_plane.h"
#include "cases/scene/one_body.h"
#include "mechanics/contact/contact_steppers.h"
#include "mechanics/contact/hertz.h"
#include "mechanics/system/static_response.h"
#include "mechanics/verified_test.h"
#include "reference/full_model.h"

namespace mb {
namespace {

using testing::expect_verified;

const Material rubber{1.2e8, 0.3, 1000};
constexpr double R = 0.01, a = 0.02 * R;

// Thrown at the speed at which Hertz's contact gets as wide as a.
Scene thrown_ball(int graded) {
  Scene scene = one_body(Sphere{R}, rubber, {2, {1}, graded});
  scene.loads.clear();
  const double modulus = contact_modulus(rubber);
  const double speed = std::sqrt(4 * modulus * std::pow(a / R, 5) / (5 * pi * rubber.density));
  scene.bodies[0].pose.position = {0, 0, R};
  scene.bodies[0].twist.velocity = {0, 0, -speed};
  scene.obstacles.push_back({"plane", {HalfSpace{}, 0, {}}});
  scene.contacts.push_back({.body = "body", .obstacle = "plane", .stiffness = 100 * modulus / a});
  scene.duration = 1e-3;
  return scene;
}

// The plane as the ball sees it, and the points near it that may touch.
RigidSurface plane() { return {HalfSpace{}, 0, {Vector3d(0, 0, -R), Eigen::Quaterniond::Identity()}}; }
constexpr double reach = 0.02 * R;

// The ball pressed by its own inertia, frictionless: normal displacements of the nodes that may touch,
//
//   u = -delta + G D^T w p,   p = k_n max(0, -(gap + D u)),   G the compliance with inertia relief,
//
// so that delta is the approach of the centre of mass. Newton's method with halved steps.
class PressedBall {
 public:
  explicit PressedBall(int graded) {
    const Scene scene = thrown_ball(graded);
    const auto full = full_model(scene, scene.bodies[0], scene.bodies[0].resolution);
    const System& system = full->system();
    const ContactPoints all = full->contact_points(plane(), reach);
    const SparseMatrix by_point = all.U.transpose();
    std::vector<Index> near, place(static_cast<size_t>(system.u0.size()), -1), unknowns;
    std::vector<Eigen::Triplet<double>> entries;
    for (Index i = 0; i < all.X.cols(); ++i) {
      if (all.X.col(i).head(2).norm() > 1.25 * a) continue;
      for (SparseMatrix::InnerIterator it(by_point, 3 * i + 2); it; ++it) {
        Index& at = place[static_cast<size_t>(it.row())];
        if (at < 0) at = static_cast<Index>(unknowns.size()), unknowns.push_back(it.row());
        entries.emplace_back(static_cast<Index>(near.size()), at, it.value());
      }
      near.push_back(i);
    }
    D_ = SparseMatrix(static_cast<Index>(near.size()), static_cast<Index>(unknowns.size()));
    D_.setFromTriplets(entries.begin(), entries.end());
    w_ = all.w(near);
    gap_ = all.X(2, near).transpose().array() + R;
    MatrixXd F = MatrixXd::Zero(system.u0.size(), D_.cols());
    for (size_t j = 0; j < unknowns.size(); ++j) F(unknowns[j], static_cast<Index>(j)) = 1;
    const double shift = -0.01 * rubber.youngs_modulus / (rubber.density * 4 * R * R);
    G_ = inertia_relief(system, shifted_factor(system, shift), F)(unknowns, Eigen::all);
  }

  double force(double delta, double k_n) const {
    VectorXd u = VectorXd::Constant(D_.cols(), -delta), p;
    const auto residual = [&](const VectorXd& x) -> VectorXd {
      p = k_n * w_.cwiseProduct((-(gap_ + D_ * x)).cwiseMax(0));
      return (x - G_ * (D_.transpose() * p)).array() + delta;
    };
    VectorXd r = residual(u), next;
    for (int k = 0; k < 60 && r.lpNorm<Eigen::Infinity>() > 1e-10 * delta; ++k, r = next) {
      const VectorXd stiffness = ((gap_ + D_ * u).array() < 0).select(k_n * w_, 0.0);
      const MatrixXd pushed = G_ * MatrixXd(D_.transpose() * stiffness.asDiagonal() * D_);
      const VectorXd step = (MatrixXd::Identity(u.size(), u.size()) + pushed).partialPivLu().solve(-r);
      double part = 1;
      next = residual(u + step);
      while (part > 1e-2 && next.norm() > (1 - 0.1 * part) * r.norm()) part /= 2, next = residual(u + part * step);
      u += part * step;
    }
    EXPECT_LE(r.lpNorm<Eigen::Infinity>(), 1e-10 * delta);
    return p.sum();
  }

 private:
  SparseMatrix D_;    // normal displacement of points x unknowns
  VectorXd w_, gap_;  // [m^2], [m] of points
  MatrixXd G_;        // [m/N]
};

// Approaches at which the exact contact, its layer of k_n = layers E*/a included, is 0.5 ... 1 of a wide, and forces.
struct Presses {
  VectorXd delta, force;
};
Presses exact_presses(double layers) {
  const double modulus = contact_modulus(rubber);
  const VectorXd widths = a / R * VectorXd::LinSpaced(11, 0.5, 1);
  Presses all{VectorXd(widths.size()), VectorXd(widths.size())};
  for (Index i = 0; i < widths.size(); ++i) {
    const SphereOnPlane contact = sphere_on_plane(widths[i], rubber.poissons_ratio);
    all.force[i] = contact.force * modulus * R * R;
    all.delta[i] = contact.approach * R + std::cbrt(0.75 * contact.force) * a / (pi * layers);
  }
  return all;
}
VectorXd forces(const PressedBall& ball, const VectorXd& delta, double layers) {
  VectorXd F(delta.size());
  for (Index i = 0; i < delta.size(); ++i) F[i] = ball.force(delta[i], layers * contact_modulus(rubber) / a);
  return F;
}
double rms(const VectorXd& x) { return x.norm() / std::sqrt(static_cast<double>(x.size())); }

const PressedBall& finest() {
  static const PressedBall ball(8);
  return ball;
}

// Graded 6, 7, 8: where the contact ends, nodes are 2a/3, a/3, a/6 apart. Pressure ends in a square root, for which
// order 3/2 to 2 in the force is what quadratic elements and points that press or do not can have; single widths
// scatter, hence the mean of eleven. Beyond graded 8 cells at the contact's edge get no smaller: a third of the
// distance from the focus.
TEST(HertzImpactVerification, ForceConvergesInTheMesh) {
  const Presses exact = exact_presses(100);
  VectorXd error(3);
  for (int i = 0; i < 3; ++i) {
    const VectorXd off =
        forces(i < 2 ? PressedBall(6 + i) : finest(), exact.delta, 100).cwiseQuotient(exact.force).array() - 1;
    error[i] = rms(off);
    RecordProperty("error_of_graded_" + std::to_string(6 + i), std::to_string(error[i]));
    if (i == 2) {
      EXPECT_LT(off.cwiseAbs().maxCoeff(), 0.01);
    }
  }
  EXPECT_GT(error[0], error[1]);
  EXPECT_GT(error[1], error[2]);
  EXPECT_GT(std::log2(error[0] / error[2]) / 2, 1.5);
  expect_verified(
      {.quantity = "force on a ball pressed on a rigid plane through a layer, at 11 approaches of contact "
                   "radius 0.01 to 0.02 R, finest mesh, root mean square",
       .reference = "converged numbers",
       .source = "exact contact of a finite sphere by series, cases/exact/sphere_on_plane.h, the layer's "
                 "share of the approach by Hertz's pressure",
       .uncertainty = "about 6e-4: the layer's second order, 3/2 (E*/(k_n a))^2 at the least width; of the series 5e-7",
       .tolerance = 5e-3,
       .why = "Nodes are a/6 apart where pressure ends in a square root: half a per cent is what such a mesh leaves."},
      error[2]);
}

// The layer takes E*/(pi k_n a) of the approach, 3/2 of it of the force: of first order in 1/k_n, differences halve as
// k_n doubles, but for the second order, (E*/(k_n a))^2, 2e-3 here. Of one mesh, whose error all but cancels. Layers
// much stiffer than k_n a/E* = 1000 find more points that press than unknowns: the mesh locks.
TEST(HertzImpactVerification, LayerIsOfFirstOrder) {
  const Presses exact = exact_presses(std::numeric_limits<double>::infinity());
  const double modulus = contact_modulus(rubber);
  const VectorXd soft = forces(finest(), exact.delta, 25), middle = forces(finest(), exact.delta, 50),
                 stiff = forces(finest(), exact.delta, 100);
  const double first = (middle - soft).cwiseQuotient(exact.force).mean();
  const double second = (stiff - middle).cwiseQuotient(exact.force).mean();
  RecordProperty("order", std::to_string(std::log2(first / second)));
  EXPECT_NEAR(std::log2(first / second), 1, 0.1);
  const VectorXd widths = (0.75 / (modulus * R * R) * exact.force).array().pow(1.0 / 3);  // [R], Hertz's of the force
  const VectorXd taken = 1.5 * a / (pi * 100) * widths.cwiseQuotient(exact.delta);        // by the stiffest
  RecordProperty("share", std::to_string(second / taken.mean()));
  EXPECT_NEAR(second, taken.mean(), 0.1 * taken.mean());
}

// Force, duration and approach of the impact, k_n a/E* = 100, nodes a/6 apart. A step is a hundredth of the contact,
// which average acceleration errs by (omega h)^2/12 = 1e-4 of.
TEST(HertzImpactVerification, ImpactWithinOnePerCent) {
  const Scene scene = thrown_ball(8);
  const Body& body = scene.bodies[0];
  const double speed = -body.twist.velocity.z(), k_n = scene.contacts[0].stiffness;
  const SphereImpactPeaks exact = sphere_impact({rubber, R, speed, k_n});
  const auto full = full_model(scene, body, body.resolution);
  System system = full->system();
  system.v0 = full->translation(body.twist.velocity);
  const std::vector<Contact> contacts{
      {full->contact_points(plane(), reach), plane(), {k_n, 0, {}}, {exact.approach, speed}}};
  const double h = exact.duration / 100;
  const VectorXd t = VectorXd::LinSpaced(56, 0, 110 * h);
  const States states = newmark(system, contacts, h)->run(t);
  ASSERT_EQ(states.status, Status::ok);
  ASSERT_EQ(states.contact.touches.size(), 1u);
  const Touch& touch = states.contact.touches[0];
  const VectorXd Me = system.M * full->translation({0, 0, 1});
  const double mass = Me.dot(full->translation({0, 0, 1}));
  const double approach = -(Me.transpose() * states.u).minCoeff() / mass;
  const Vector3d off(touch.peak_force / exact.force - 1, (touch.end - touch.start) / exact.duration - 1,
                     approach / exact.approach - 1);
  expect_verified(
      {.quantity = "largest force, duration and largest approach of a ball thrown on a rigid plane at the "
                   "speed at which Hertz's contact radius gets 0.02 R",
       .reference = "converged numbers",
       .source = "energy integral of a finite sphere's law of contact, cases/exact/sphere_impact.h",
       .uncertainty = "about 2e-3 of the energy, (v/c)^(3/5): what waves keep; the layer's second order 1e-4",
       .tolerance = 0.01,
       .why = "The mesh errs by up to 5e-3 in the force, steps by 1e-4 of the duration."},
      off.cwiseAbs().maxCoeff<Eigen::PropagateNaN>());
  EXPECT_NEAR(touch.impulse.z(), 2 * mass * speed, 1e-3 * 2 * mass * speed);  // what stays behind as vibration
  RecordProperty("force", std::to_string(off[0]));
  RecordProperty("duration", std::to_string(off[1]));
  RecordProperty("approach", std::to_string(off[2]));
  RecordProperty("impulse", std::to_string(touch.impulse.z() / (2 * mass * speed) - 1));
}

}  // namespace
}  // namespace mb
