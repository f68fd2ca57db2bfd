#include "harness/analysis/encounter.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "mechanics/geometry/shape.h"

namespace mb {
namespace {

double mass_of(const Body& body) { return body.material.density * volume(body.shape); }

// What a touch at X of a body sees of its modes: the first r elastic ones and the rigid ones, all of them in g.
PressedModes modes_at(const ContactVariants& variants, size_t place, const Vector3d& X, const Vector3d& normal, int r) {
  const Model& model = variants.body().scene_model;
  const FullModel& full = *model.bodies[place].full;
  const Modes kept = leading(variants.modes(place), r);
  VectorXd c(kept.size());
  for (Index i = 0; i < c.size(); ++i)
    c[i] = i < kept.n_rigid ? 0 : kept.Phi.col(i).dot(apply_damping(full.system(), VectorXd(kept.Phi.col(i))));
  const Vector3d n = model.scene->bodies[place].pose.orientation.conjugate() * normal;
  const MatrixXd at = full.displacement_at(Matrix3Xd(X)) * kept.Phi;
  return {kept.omega.cwiseAbs2(), c, at.transpose() * n, 0};
}

VectorXd joined(const VectorXd& a, const VectorXd& b) { return (VectorXd(a.size() + b.size()) << a, b).finished(); }

}  // namespace

Encounter first_encounter(const Scene& scene) {
  const Body& body = scene.bodies.front();
  const Touchdown down = touchdown(scene, body);
  const auto met = std::ranges::min_element(down.meetings, {}, &Meeting::t);
  if (met == down.meetings.end() || !std::isfinite(met->t))
    throw std::invalid_argument("contact-stability: the first body meets nothing");
  const Vector3d flown = met->t * body.twist.velocity + met->t * met->t / 2 * scene.gravity;
  const Body* partner = partner_of(scene, scene.contacts.at(met->contact));
  const bool yields = partner && !is_held(*partner);
  const double share = yields ? mass_of(*partner) / (mass_of(body) + mass_of(*partner)) : 1;
  return {*met, gap(surface_met(scene, body, *met), body.pose.to_world(met->X) + flown).normal, share * mass_of(body)};
}

PressedModes pressed(const ContactVariants& variants, const Encounter& encounter, int r, double factor) {
  const Scene& scene = *variants.body().scene_model.scene;
  const auto& [meeting, normal, mass] = encounter;
  PressedModes all = modes_at(variants, 0, meeting.X, normal, r);
  if (const Body* partner = partner_of(scene, scene.contacts.at(meeting.contact))) {
    const auto place = static_cast<size_t>(partner - scene.bodies.data());
    const PressedModes other = modes_at(variants, place, meeting.Y, -normal, r);
    all = {joined(all.lambda, other.lambda), joined(all.c, other.c), joined(all.g, other.g), 0};
  }
  const double a = meeting.size.radius;
  all.kappa = factor * meeting.size.stiffness * pi * a * a;
  return all;
}

void throw_at_least(Scene& scene, const Encounter& encounter, double flight) {
  Body& body = scene.bodies.front();
  const double missing = encounter.meeting.size.speed + body.twist.velocity.dot(encounter.normal);
  if (!(missing > 1e-6 * encounter.meeting.size.speed)) return;
  body.twist.velocity -= missing * encounter.normal;
  body.pose.position += flight * missing * encounter.normal;
}

}  // namespace mb
