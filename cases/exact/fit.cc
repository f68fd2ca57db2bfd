#include "cases/exact/fit.h"

#include <fmt/format.h>

#include <algorithm>

namespace mb {
namespace {

bool is_undamped(const Body& body) {
  const auto vanishes = [](double ratio) { return ratio == 0; };
  return body.damping.alpha == 0 && body.damping.beta == 0 &&
         std::all_of(body.damping_ratios.begin(), body.damping_ratios.end(), vanishes);
}

}  // namespace

std::string Misfit::text() const { return fmt::format("{}", fmt::join(reasons_, "; ")); }

Misfit one_loaded_undamped_body(const Scene& scene) {
  Misfit misfit;
  misfit.require(scene.bodies.size() == 1, fmt::format("needs one body, there are {}", scene.bodies.size()));
  for (const Body& body : scene.bodies) {
    misfit.require(is_uniform(body.material), "the material is not isotropic and the same throughout");
    misfit.require(is_undamped(body), "the body is damped");
  }
  misfit.require(scene.loads.size() == 1, fmt::format("needs one load, there are {}", scene.loads.size()));
  for (const Load& load : scene.loads) {
    misfit.require(load.tractions.size() == 1,
                   fmt::format("needs one traction, the load has {}", load.tractions.size()));
    for (const Traction& traction : load.tractions)
      misfit.require(!traction.patch.disc, "the load covers a disc, not the whole face");
  }
  return misfit;
}

Misfit one_struck_undamped_body(const Scene& scene, Theory theory) {
  Misfit misfit;
  misfit.require(scene.bodies.size() == 1, fmt::format("needs one body, there are {}", scene.bodies.size()));
  for (const Body& body : scene.bodies) {
    misfit.require(body.theory == theory,
                   fmt::format("the body's theory is {}, not {}", to_string(body.theory), to_string(theory)));
    misfit.require(std::holds_alternative<Box>(body.shape), "the body is not a box");
    misfit.require(is_uniform(body.material), "the material is not isotropic and the same throughout");
    misfit.require(is_undamped(body), "the body is damped");
    misfit.require(striker_of(scene, body), "nothing strikes the body");
  }
  misfit.require(scene.contacts.size() == 1, fmt::format("needs one contact, there are {}", scene.contacts.size()));
  for (const ContactPair& pair : scene.contacts) {
    misfit.require(pair.law == ContactLaw::hertz, "the contact is not by Hertz's law");
    misfit.require(pair.damping == 0 && pair.friction == 0, "the contact is damped or has friction");
  }
  misfit.require(scene.loads.empty(), "the body is loaded");
  return misfit;
}

Misfit one_thrown_undamped_body(const Scene& scene) {
  Misfit misfit;
  misfit.require(scene.bodies.size() == 1, fmt::format("needs one body, there are {}", scene.bodies.size()));
  for (const Body& body : scene.bodies) {
    misfit.require(body.theory == Theory::solid, fmt::format("the body's theory is {}", to_string(body.theory)));
    misfit.require(is_uniform(body.material), "the material is not isotropic and the same throughout");
    misfit.require(is_undamped(body), "the body is damped");
    misfit.require(body.supports.empty(), "the body is not free");
    misfit.require(body.twist.angular_velocity.isZero(0), "the body spins");
  }
  misfit.require(scene.contacts.size() == 1, fmt::format("needs one contact, there are {}", scene.contacts.size()));
  for (const ContactPair& pair : scene.contacts) {
    misfit.require(pair.law == ContactLaw::penalty, "the contact is not by the penalty law");
    misfit.require(pair.damping == 0 && pair.friction == 0, "the contact is damped or has friction");
    const auto met = std::ranges::find(scene.obstacles, pair.obstacle, &Obstacle::name);
    misfit.require(met != scene.obstacles.end() && std::holds_alternative<HalfSpace>(met->surface.shape),
                   "the obstacle is not a half-space");
  }
  misfit.require(scene.loads.empty(), "the body is loaded");
  return misfit;
}

}  // namespace mb
