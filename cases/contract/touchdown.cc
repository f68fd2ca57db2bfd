#include "cases/contract/touchdown.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "mechanics/contact/first_touch.h"
#include "mechanics/contact/first_touch_support.h"
#include "mechanics/geometry/graded_rule.h"
#include "mechanics/geometry/signed_distance.h"
#include "mechanics/rigid/flight.h"
#include "mechanics/rigid/inertia.h"

namespace mb {

namespace {

constexpr double allowed_overlap = 1e-9;  // [-] of the extent: what rounding of poses may leave
constexpr double touching = 1e-3;         // [-] of the extent: about what a touch flattens
constexpr double apart = 0.05;            // [-] of the extent: the middle of a touch is another point than that found
constexpr int n_looks = 64;               // in time, for the nearest approach of what never touches

// The undeformed body on its way; one that is held stands still.
class RigidMotion final : public BodyMotion {
 public:
  RigidMotion(const Scene& scene, const Body& body)
      : moves_(!is_held(body)),
        pose_(body.pose),
        gravity_(scene.gravity),
        flight_(mass_properties(body.shape, body.material.density), body.pose, body.twist, scene.gravity),
        circumradius_(circumradius(body.shape)) {
    const PrincipalAxes axes = principal_axes(mass_properties(body.shape, body.material.density).inertia);
    spin_up_ = axes.moments.maxCoeff() / axes.moments.minCoeff();
  }
  Pose pose(double t) const { return moves_ ? flight_.at(t) : pose_; }
  Vector3d velocity(double t, const Vector3d& X) const {
    if (!moves_) return Vector3d::Zero();
    const Twist twist = flight_.twist_at(t);
    return twist.velocity + twist.angular_velocity.cross(pose(t).orientation * X);
  }

  void at(double t, std::span<const Vector3d> X, std::span<PointMotion> out) const override {
    const Pose now = pose(t);
    const Eigen::Matrix3d Q = now.orientation.toRotationMatrix();
    const Twist twist = moves_ ? flight_.twist_at(t) : Twist{};
    const Vector3d& w = twist.angular_velocity;
    Eigen::Matrix3d W;
    W << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0;
    for (size_t i = 0; i < X.size(); ++i) {
      const Vector3d arm = Q * X[i];
      out[i] = {now.position + arm, twist.velocity + w.cross(arm), Q, W * Q};
    }
  }
  // |w x (w x r) + w' x r|, with |w'| <= (I_max/I_min) |w|^2 by Euler's equations.
  MotionBounds bounds(double, double) const override {
    if (!moves_) return {};
    const double w = flight_.max_angular_speed();
    return {gravity_, (1 + spin_up_) * w * w * circumradius_, 0, 0};
  }

 private:
  bool moves_;
  Pose pose_;
  Vector3d gravity_;
  Flight flight_;
  double circumradius_, spin_up_;
};

struct Near {
  double t;
  Vector3d X;
  double gap;
};

// Of samples in space and time: where to look at when nothing touches.
Near nearest_approach(const Scene& scene, const Body& body, const RigidMotion& motion, const RigidSurface& surface) {
  const double l = extent(body.shape);
  const GradedRule rule = graded_rule(body.shape, {}, {l / 16, l / 16, 0, 2});
  Near best{0, rule.points.col(0), std::numeric_limits<double>::infinity()};
  for (int k = 0; k <= n_looks; ++k) {
    const double t = scene.duration * k / n_looks;
    const Pose pose = motion.pose(t);
    for (Index i = 0; i < rule.points.cols(); ++i)
      if (const double gap = gap_value(surface, pose.to_world(rule.points.col(i))); gap < best.gap)
        best = {t, rule.points.col(i), gap};
  }
  return best;
}

// Edges and faces touch with all their points at once, of which `X` is one: their middle, on the surface.
Vector3d middle_of_touch(const Body& body, const Pose& pose, const RigidSurface& surface, const Vector3d& X) {
  const double l = extent(body.shape);
  const GradedRule rule = graded_rule(body.shape, {X}, {l / 64, l / 16, 0.2, 2});
  const double least = gap_value(surface, pose.to_world(X));
  Vector3d sum = Vector3d::Zero();
  double area = 0;
  for (Index i = 0; i < rule.points.cols(); ++i) {
    if (gap_value(surface, pose.to_world(rule.points.col(i))) > least + touching * l) continue;
    sum += rule.weights[i] * rule.points.col(i);
    area += rule.weights[i];
  }
  if (area == 0) return X;
  const Vector3d mean = sum / area;
  const Distance d = signed_distance(body.shape, mean);
  const Vector3d middle = mean - d.value * d.gradient;
  return (middle - X).norm() < apart * l ? X : middle;
}

std::string overlap_message(const Body& body, const ContactPair& pair, const std::optional<FirstTouch>& found) {
  if (!found || found->kind != FirstTouch::overlap || found->gap >= -allowed_overlap * extent(body.shape)) return {};
  return fmt::format("body '{}' starts {:.3g} m within obstacle '{}': move it out", body.name, -found->gap,
                     pair.obstacle);
}

Meeting meeting_of(const Scene& scene, const Body& body, const RigidMotion& motion, size_t contact) {
  const ContactPair& pair = scene.contacts[contact];
  const RigidSurface& surface = obstacle_of(scene, pair).surface;
  const double l = extent(body.shape);
  const auto found = first_touch(body.shape, motion, surface,
                                 {.t0 = 0, .t1 = scene.duration, .tolerance = 1e-12 * l, .leaving = false});
  if (const std::string overlap = overlap_message(body, pair, found); !overlap.empty())
    throw std::invalid_argument(overlap);
  Meeting meeting{contact, found ? found->t : std::numeric_limits<double>::infinity(), Vector3d::Zero(), {}};
  const Near near = found ? Near{found->t, found->X, found->gap} : nearest_approach(scene, body, motion, surface);
  const Pose pose = motion.pose(near.t);
  meeting.X = middle_of_touch(body, pose, surface, near.X);
  const Gap at = gap(surface, pose.to_world(meeting.X));
  const double speed = std::max(0.0, -at.normal.dot(motion.velocity(near.t, meeting.X)));
  meeting.size = contact_size(body, pair, meeting.X, pose, at, speed, scene.gravity);
  return meeting;
}

// Whatever strikes a body does so in the middle of its top face.
Meeting strike_of(const Scene& scene, const Body& body, size_t contact, const Obstacle& obstacle) {
  const auto* box = std::get_if<Box>(&body.shape);
  if (!box) throw std::invalid_argument("body '" + body.name + "' is no box: it has no top face to be struck");
  return {contact, 0, box->size.z() / 2 * Vector3d::UnitZ(), strike_size(body, scene.contacts[contact], obstacle)};
}

}  // namespace

Touchdown touchdown(const Scene& scene, const Body& body) {
  Touchdown down;
  const RigidMotion motion(scene, body);
  for (size_t i = 0; i < scene.contacts.size(); ++i) {
    if (scene.contacts[i].body != body.name) continue;
    const Obstacle& obstacle = obstacle_of(scene, scene.contacts[i]);
    down.meetings.push_back(obstacle.striker ? strike_of(scene, body, i, obstacle)
                                             : meeting_of(scene, body, motion, i));
    down.t = std::min(down.t, down.meetings.back().t);
  }
  return down;
}

std::string overlap_at_start(const Scene& scene, const Body& body) {
  const RigidMotion motion(scene, body);
  for (const ContactPair& pair : scene.contacts) {
    const Obstacle& obstacle = obstacle_of(scene, pair);
    if (pair.body != body.name || obstacle.striker) continue;
    const TouchSearch now{.t0 = 0, .t1 = 0, .tolerance = 1e-12 * extent(body.shape), .leaving = false};
    const std::string overlap = overlap_message(body, pair, first_touch(body.shape, motion, obstacle.surface, now));
    if (!overlap.empty()) return overlap;
  }
  return {};
}

PenaltyLaw law_of(const ContactPair& pair, const ContactSize& size) {
  PenaltyLaw law{size.stiffness, pair.damping, {}};
  if (pair.law == ContactLaw::hertz) law.exponent = 1.5;
  if (pair.friction > 0) law.friction = {pair.friction, pair.slip_speed};
  return law;
}

const Obstacle& obstacle_of(const Scene& scene, const ContactPair& pair) {
  for (const Obstacle& obstacle : scene.obstacles)
    if (obstacle.name == pair.obstacle) return obstacle;
  throw std::out_of_range("no obstacle is called " + pair.obstacle);
}

RigidSurface surface_met(const Scene& scene, const Body& body, const Meeting& meeting) {
  const Obstacle& obstacle = obstacle_of(scene, scene.contacts.at(meeting.contact));
  if (!obstacle.striker) return obstacle.surface;
  const Eigen::Quaterniond upside_down(0, 1, 0, 0);
  return {HalfSpace{}, 0, {body.pose.to_world(meeting.X), body.pose.orientation * upside_down}};
}

RigidSurface seen_from(const Pose& frame, const RigidSurface& surface) {
  RigidSurface seen = surface;
  seen.pose.position = frame.to_frame(surface.pose.position);
  seen.pose.orientation = (frame.orientation.conjugate() * surface.pose.orientation).normalized();
  return seen;
}

}  // namespace mb
