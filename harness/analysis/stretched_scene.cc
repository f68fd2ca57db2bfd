#include "harness/analysis/stretched_scene.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace mb {

namespace {

struct Length {
  Index axis;
  double along, across; /* [m] */
};

Length length(const Shape& shape) {
  if (const auto* cylinder = std::get_if<Cylinder>(&shape)) return {2, cylinder->length, 2 * cylinder->radius};
  const auto* box = std::get_if<Box>(&shape);
  if (!box) throw std::invalid_argument("slenderness: of boxes and cylinders alone");
  Index axis = 0;
  const double along = box->size.maxCoeff(&axis);
  Vector3d section = box->size;
  section[axis] = 0;
  return {axis, along, section.maxCoeff()};
}

Shape with_length(Shape shape, Index axis, double along) {
  if (auto* cylinder = std::get_if<Cylinder>(&shape)) cylinder->length = along;
  if (auto* box = std::get_if<Box>(&shape)) box->size[axis] = along;
  return shape;
}

// Of a cylinder cells are splits and layers.
Resolution with_cells(Resolution mesh, const Shape& shape, Index axis, double factor) {
  const auto along = static_cast<size_t>(std::holds_alternative<Box>(shape) ? axis : 1);
  int across = 1;
  for (size_t i = 0; i < mesh.cells.size(); ++i)
    if (i != along) across = std::max(across, mesh.cells[i]);
  constexpr double rounding = 1e-9;
  mesh.cells[along] = std::max(across, static_cast<int>(std::ceil(mesh.cells[along] * factor - rounding)));
  return mesh;
}

void require_one_solid(const Scene& scene) {
  if (scene.bodies.size() != 1 || !scene.contacts.empty() || scene.bodies.front().theory != Theory::solid)
    throw std::invalid_argument("slenderness: of one solid body that nothing touches");
}

}  // namespace

double slenderness(const Shape& shape) {
  const Length l = length(shape);
  return l.along / l.across;
}

Scene proportioned(const Scene& scene, double aspect) {
  require_one_solid(scene);
  const auto* box = std::get_if<Box>(&scene.bodies.front().shape);
  if (!box || !(aspect >= 1)) throw std::invalid_argument("aspect: of boxes, from 1 on");
  const double least = box->size.minCoeff(), most = box->size.maxCoeff(), factor = aspect * least / most;
  const auto is_long = (box->size.array() > least * (1 + 1e-9)).eval();
  if (!is_long.any()) throw std::invalid_argument("aspect: a cube has no longer extent to change");
  const Vector3d by = is_long.select(Eigen::Array3d::Constant(factor), 1.0);
  const auto move = [&](std::optional<Disc>& disc) {
    if (!disc) return;
    disc->centre = disc->centre.cwiseProduct(by);
    if (is_long.count() == 2) disc->radius *= factor;
  };
  Scene changed = scene;
  Body& body = changed.bodies.front();
  body.shape = Box{box->size.cwiseProduct(by)};
  for (Support& support : body.supports) move(support.patch.disc);
  for (Load& load : changed.loads)
    for (Traction& traction : load.tractions) move(traction.patch.disc);
  for (Probe& probe : changed.probes) probe.point = probe.point.cwiseProduct(by);
  return changed;
}

Scene stretched(const Scene& scene, double ratio) {
  require_one_solid(scene);
  if (!(ratio > 0)) throw std::invalid_argument("slenderness: must be above 0");
  Scene changed = scene;
  Body& body = changed.bodies.front();
  const Length l = length(body.shape);
  const double factor = ratio * l.across / l.along;
  const auto move = [&](std::optional<Disc>& disc) {
    if (disc) disc->centre[l.axis] *= factor;
  };
  body.resolution = with_cells(body.resolution, body.shape, l.axis, factor);
  body.shape = with_length(body.shape, l.axis, ratio * l.across);
  for (Support& support : body.supports) move(support.patch.disc);
  for (Load& load : changed.loads)
    for (Traction& traction : load.tractions) move(traction.patch.disc);
  for (Probe& probe : changed.probes) probe.point[l.axis] *= factor;
  return changed;
}

namespace {

struct Slow {
  double by;
  History operator()(Step s) const { return s.start *= by, s; }
  History operator()(Pulse s) const { return s.start *= by, s.duration *= by, s; }
  History operator()(Ramp s) const { return s.start *= by, s.duration *= by, s; }
  History operator()(Harmonic s) const { return s.start *= by, s.omega /= by, s; }
  History operator()(Chirp s) const { return s.start *= by, s.duration *= by, s.omega0 /= by, s.omega1 /= by, s; }
  History operator()(Table s) const {
    for (double& t : s.t) t *= by;
    return s;
  }
  History operator()(const Expression&) const {
    throw std::invalid_argument("slenderness: a history that is a formula has no time scale known");
  }
};

}  // namespace

History slowed(const History& history, double factor) { return std::visit(Slow{factor}, history); }

Scene slowed(Scene scene, double factor) {
  for (Load& load : scene.loads) load.history = slowed(load.history, factor);
  for (Body& body : scene.bodies)
    for (Support& support : body.supports)
      if (support.drive) support.drive->acceleration = slowed(support.drive->acceleration, factor);
  scene.duration *= factor;
  scene.samples_per_second /= factor;
  return scene;
}

}  // namespace mb
