#include "cases/contract/touchdown.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "cases/contract/approach.h"
#include "cases/scene/number_text.h"
#include "mechanics/geometry/graded_rule.h"
#include "mechanics/geometry/signed_distance.h"

namespace mb {

namespace {

constexpr double allowed_overlap = 1e-9;  // [-] of the extent: what rounding of poses may leave
constexpr double touching = 1e-3;         // [-] of the extent: about what a touch flattens
constexpr double apart = 0.05;            // [-] of the extent: the middle of a touch is another point than that found
constexpr int n_looks = 64;               // in time, for the nearest approach of what never touches

// What the body meets, in the frame that its approach is seen from.
RigidSurface surface_seen(const Scene& scene, const ContactPair& pair) {
  const Body* partner = partner_of(scene, pair);
  return partner ? RigidSurface{partner->shape, 0, {}} : obstacle_of(scene, pair).surface;
}

struct Near {
  double t;
  Vector3d X;
  double gap;
};

// Of samples in space and time: where to look at when nothing touches.
Near nearest_approach(const Scene& scene, const Body& body, const Approach& motion, const RigidSurface& surface) {
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

std::string overlap_message(const Scene& scene, const Body& body, const ContactPair& pair,
                            const std::optional<FirstTouch>& found) {
  const double allowed = allowed_overlap * extent(body.shape);
  if (!found || found->kind != FirstTouch::overlap || found->gap >= -allowed) return {};
  return fmt::format("body '{}' starts {} m within {} '{}': move it out", body.name,
                     number_beside(-found->gap, allowed), partner_of(scene, pair) ? "body" : "obstacle", pair.obstacle);
}

Meeting meeting_of(const Scene& scene, const Body& body, size_t contact) {
  const ContactPair& pair = scene.contacts[contact];
  const Body* partner = partner_of(scene, pair);
  const Approach motion(scene, body, partner);
  const RigidSurface surface = surface_seen(scene, pair);
  const double l = extent(body.shape);
  const auto found = first_touch(body.shape, motion, surface,
                                 {.t0 = 0, .t1 = scene.duration, .tolerance = 1e-12 * l, .leaving = false});
  if (const std::string overlap = overlap_message(scene, body, pair, found); !overlap.empty())
    throw std::invalid_argument(overlap);
  Meeting meeting{contact, found ? found->t : std::numeric_limits<double>::infinity(), Vector3d::Zero(), {}};
  const Near near = found ? Near{found->t, found->X, found->gap} : nearest_approach(scene, body, motion, surface);
  const Pose pose = motion.pose(near.t);
  meeting.X = middle_of_touch(body, pose, surface, near.X);
  const Gap at = gap(surface, pose.to_world(meeting.X));
  const double speed = std::max(0.0, -at.normal.dot(motion.velocity(near.t, meeting.X)));
  meeting.size = contact_size(body, pair, meeting.X, pose, at, speed, motion.weight(), partner);
  if (partner) meeting.Y = pose.to_world(meeting.X) - at.value * at.normal;
  return meeting;
}

// Whatever strikes a body does so in the middle of its top face.
Meeting strike_of(const Scene& scene, const Body& body, size_t contact, const Obstacle& obstacle) {
  const auto* box = std::get_if<Box>(&body.shape);
  if (!box) throw std::invalid_argument("body '" + body.name + "' is no box: it has no top face to be struck");
  return {contact, 0, box->size.z() / 2 * Vector3d::UnitZ(), strike_size(body, scene.contacts[contact], obstacle)};
}

bool is_partner(const Scene& scene, const Meeting& meeting, const Body& body) {
  const Body* partner = partner_of(scene, scene.contacts[meeting.contact]);
  return partner && partner->name == body.name;
}

}  // namespace

Touchdown touchdown(const Scene& scene, const Body& body) {
  Touchdown down;
  for (size_t i = 0; i < scene.contacts.size(); ++i) {
    if (scene.contacts[i].body != body.name) continue;
    const Obstacle* striker = striker_of(scene, body);
    down.meetings.push_back(striker ? strike_of(scene, body, i, *striker) : meeting_of(scene, body, i));
    down.t = std::min(down.t, down.meetings.back().t);
  }
  return down;
}

std::string overlap_at_start(const Scene& scene, const Body& body) {
  for (const ContactPair& pair : scene.contacts) {
    if (pair.body != body.name || striker_of(scene, body)) continue;
    const Approach motion(scene, body, partner_of(scene, pair));
    const TouchSearch now{.t0 = 0, .t1 = 0, .tolerance = 1e-12 * extent(body.shape), .leaving = false};
    const std::string overlap =
        overlap_message(scene, body, pair, first_touch(body.shape, motion, surface_seen(scene, pair), now));
    if (!overlap.empty()) return overlap;
  }
  return {};
}

std::vector<TouchedAt> touched_at(const Scene& scene, const Body& body) {
  std::vector<TouchedAt> all;
  for (const Body& other : scene.bodies)
    for (const Meeting& meeting : touchdown(scene, other).meetings) {
      const bool met = is_partner(scene, meeting, body);
      if (other.name == body.name || met) all.push_back({meeting, met ? meeting.Y : meeting.X});
    }
  std::ranges::sort(all, {}, [](const TouchedAt& at) { return at.meeting.contact; });
  return all;
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
  if (const Body* partner = partner_of(scene, scene.contacts.at(meeting.contact)))
    return {partner->shape, 0, partner->pose};
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
