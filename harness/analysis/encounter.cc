#include "harness/analysis/encounter.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "harness/analysis/layer_impact.h"
#include "mechanics/geometry/shape.h"
#include "mechanics/geometry/signed_distance.h"

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

constexpr double facing = 0.5;  // [-] cosine of a surface that meets what is touched: not of faces around an edge

// Of the mean of Psi^T n over these samples, areas w.
StaticYield yield(const FloatingBody& body, const MatrixXd& Psi, const Vector3d& n, const std::vector<Index>& near,
                  const VectorXd& w) {
  VectorXd psi = VectorXd::Zero(body.n_static());
  double area = 0;
  for (const Index i : near) psi += w[i] * Psi.middleRows<3>(3 * i).transpose() * n, area += w[i];
  return {psi.dot(body.static_stiffness.ldlt().solve(psi)) / (area * area), body.static_damping};
}

// Within a of the touch, or the one that is next to it.
std::vector<Index> samples_within(const Shape& shape, const SurfaceSamples& samples, const Vector3d& X, double a) {
  const VectorXd away = (samples.X.colwise() - X).colwise().norm();
  const Vector3d outward = signed_distance(shape, X).gradient;
  std::vector<Index> near;
  for (Index i = 0; i < away.size(); ++i)
    if (away[i] < a && signed_distance(shape, samples.X.col(i)).gradient.dot(outward) > facing) near.push_back(i);
  if (near.empty()) near.resize(1), away.minCoeff(&near.front());
  return near;
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

ImpactOnLayer impact_on_layer(const Encounter& encounter, double factor) {
  const ContactSize& size = encounter.meeting.size;
  const double k = factor * size.stiffness, m = encounter.mass, v = size.speed;
  if (size.curvature == 0) {
    const double area = pi * size.radius * size.radius;
    return {k, size.radius, std::max(size.duration, pi * std::sqrt(m / (k * area)))};
  }
  const double g = std::cbrt(1.5 * size.curvature * m * v * v / (pi * k));
  const double a = std::min(std::sqrt(2 * g / size.curvature), 1 / size.curvature);
  const double per_time = std::sqrt(k / m);
  const double T = impact_on_square_law(pi / size.curvature, v / per_time, 0).duration / per_time;
  return {k, std::max(size.radius, a), std::max(size.duration, T)};
}

PressedModes pressed(const ContactVariants& variants, const Encounter& encounter, int r, const ImpactOnLayer& impact) {
  const Scene& scene = *variants.body().scene_model.scene;
  const auto& [meeting, normal, mass] = encounter;
  PressedModes all = modes_at(variants, 0, meeting.X, normal, r);
  if (const Body* partner = partner_of(scene, scene.contacts.at(meeting.contact))) {
    const auto place = static_cast<size_t>(partner - scene.bodies.data());
    const PressedModes other = modes_at(variants, place, meeting.Y, -normal, r);
    all = {joined(all.lambda, other.lambda), joined(all.c, other.c), joined(all.g, other.g), 0};
  }
  all.kappa = impact.stiffness * pi * impact.radius * impact.radius;
  return all;
}

std::vector<StaticYield> static_yields(const FloatingBases& bases, const Encounter& encounter, double a) {
  const FloatingBasis& first = bases.front();
  const Body& body = first.scene->bodies.front();
  const auto meetings = touchdown(*first.scene, body).meetings;
  const auto at = std::ranges::find(meetings, encounter.meeting.contact, &Meeting::contact) - meetings.begin();
  const SampledContact& contact = first.body.contacts.at(static_cast<size_t>(at));
  const auto near = samples_within(body.shape, contact.samples, encounter.meeting.X, a);
  std::vector<StaticYield> all;
  const auto add = [&](const FloatingBasis& basis, const MatrixXd& Psi) {
    const Vector3d n = basis.scene->bodies[basis.place].pose.orientation.conjugate() * encounter.normal;
    if (basis.body.n_static() > 0) all.push_back(yield(basis.body, Psi, n, near, contact.samples.w));
  };
  add(first, contact.samples.Psi);
  if (contact.partner) add(bases.at(contact.partner->body), contact.partner->Psi.transpose());
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
