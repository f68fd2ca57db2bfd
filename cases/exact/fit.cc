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
    misfit.require(!body.material.orthotropy, "the material is not isotropic");
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

}  // namespace mb
