// For tests: scenes told in other systems of units, lengths by L, masses by M, times by T.
#pragma once

#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <variant>

#include "cases/scene/read_toml.h"
#include "harness/catalogue.h"
#include "mechanics/geometry/overloaded.h"

namespace mb::testing {

struct Units {
  const char* name;
  double L, M, T;  // of one metre, kilogram, second in the new units
  double pressure() const { return M / (L * T * T); }
};
inline const Units si{"m, kg, s", 1, 1, 1}, mm_tonne{"mm, t, s", 1e3, 1e-3, 1}, cgs{"cm, g, s", 1e2, 1e3, 1},
    mm_mg_ms{"mm, mg, ms", 1e3, 1e6, 1e3};

inline Shape in(const Units& u, Shape shape) {
  std::visit(overloaded{[&](Box& b) { b.size *= u.L; }, [&](Cylinder& c) { c.radius *= u.L, c.length *= u.L; },
                        [&](Sphere& s) { s.radius *= u.L; }, [&](Superquadric& s) { s.semi_axes *= u.L; },
                        [&](TaperedSuperquadric& s) { s.straight.semi_axes *= u.L; }},
             shape);
  return shape;
}

inline History in(const Units& u, History history) {
  std::visit(overloaded{[&](Step& h) { h.start *= u.T; }, [&](Harmonic& h) { h.omega /= u.T, h.start *= u.T; },
                        [&](Pulse& h) { h.duration *= u.T, h.start *= u.T; },
                        [&](Ramp& h) { h.duration *= u.T, h.start *= u.T; },
                        [](auto&) { throw std::logic_error("a history that these tests do not tell in other units"); }},
             history);
  return history;
}

inline void tell(const Units& u, Patch& patch) {
  if (!patch.disc) return;
  patch.disc->centre *= u.L;
  patch.disc->radius *= u.L;
}

inline void tell(const Units& u, Body& body) {
  body.shape = in(u, body.shape);
  body.material.youngs_modulus *= u.pressure();
  body.material.density *= u.M / std::pow(u.L, 3);
  body.damping.alpha /= u.T;
  body.damping.beta *= u.T;
  for (Dashpot& dashpot : body.dashpots) dashpot.damping *= u.M / u.T, tell(u, dashpot.patch);
  for (Inclusion& inclusion : body.material.inclusions) inclusion.centre *= u.L, inclusion.size *= u.L;
  for (Support& support : body.supports) {
    tell(u, support.patch);
    if (!support.drive) continue;
    support.drive->acceleration = in(u, support.drive->acceleration);
    const auto amplitude = [&](auto& h) {
      if constexpr (requires { h.amplitude; }) h.amplitude *= u.L / (u.T * u.T);
    };
    std::visit(amplitude, support.drive->acceleration);
  }
  body.pose.position *= u.L;
  body.twist.velocity *= u.L / u.T;
  body.twist.angular_velocity /= u.T;
}

inline Scene in(const Units& u, Scene scene) {
  for (Body& body : scene.bodies) tell(u, body);
  for (Load& load : scene.loads) {
    load.history = in(u, load.history);
    for (Traction& t : load.tractions) t.traction *= u.pressure(), t.pressure *= u.pressure(), tell(u, t.patch);
  }
  scene.gravity *= u.L / (u.T * u.T);
  for (Obstacle& obstacle : scene.obstacles) {
    obstacle.surface.pose.position *= u.L;
    obstacle.surface.rounding *= u.L;
    if (auto* shape = std::get_if<Shape>(&obstacle.surface.shape)) *shape = in(u, *shape);
  }
  for (ContactPair& pair : scene.contacts) {
    pair.stiffness *= u.pressure() / u.L;
    pair.damping *= u.T / u.L;
    pair.slip_speed *= u.L / u.T;
  }
  for (Probe& probe : scene.probes) probe.point *= u.L;
  for (double* time : {&scene.duration, &scene.samples_from}) *time *= u.T;
  for (double* rate : {&scene.frame_rate, &scene.samples_per_second}) *rate /= u.T;
  return scene;
}

inline std::shared_ptr<const Scene> told(const std::string& file, const Units& u) {
  const Scene scene = read_toml(std::string(MB_SOURCE_DIR) + "/cases/" + file, default_catalogue().vocabulary());
  return std::make_shared<const Scene>(in(u, scene));
}

}  // namespace mb::testing
