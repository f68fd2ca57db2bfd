#include "cases/scene/read_body.h"

#include <fmt/format.h>

#include "cases/scene/read_patch.h"
#include "cases/scene/resolution.h"

namespace mb {

namespace {

// From a grain to a mountain: with moduli from the softest gel to beyond diamond and densities from thin gas to beyond
// osmium, M, K and their ratios stay far from overflow and underflow in double precision.
const Range length_range{1e-6, 1e4, "m"};
const Range modulus_range{1, 1e13, "Pa"};
const Range density_range{1e-3, 1e5, "kg/m^3"};
const Range poisson_range{-1, 0.5, "", true, true};  // where K is positive definite

std::optional<Shape> read_shape(Section section) {
  const Words words{{"box", "cylinder", "sphere", "superquadric"}, "shape kind", "shape kinds"};
  const auto kind = section.choice("kind", words);
  if (!kind) {
    section.finish(false);
    return std::nullopt;
  }
  if (*kind == "superquadric") {
    section.error("kind", "shape kind 'superquadric' is understood, but cannot be simulated yet");
    return std::nullopt;
  }
  std::optional<Shape> shape;
  if (*kind == "box") {
    if (const auto size = section.vector("size", length_range)) shape = Box{*size};
  } else if (*kind == "cylinder") {
    const auto radius = section.number("radius", length_range);
    const auto length = section.number("length", length_range);
    if (radius && length) shape = Cylinder{*radius, *length};
  } else if (const auto radius = section.number("radius", length_range)) {
    shape = Sphere{*radius};
  }
  section.finish();
  return shape;
}

std::optional<Material> read_material(Section section) {
  const auto modulus = section.number("youngs_modulus", modulus_range);
  const auto ratio = section.number("poissons_ratio", poisson_range);
  const auto density = section.number("density", density_range);
  section.not_yet("orthotropy");
  section.not_yet("plasticity");
  section.finish();
  if (!modulus || !ratio || !density) return std::nullopt;
  return Material{*modulus, *ratio, *density};
}

Rayleigh read_damping(Section section) {
  // Beyond, every mode is overdamped by more than double precision resolves.
  const double alpha = section.number("alpha", {0, 1e9, "1/s"}, 0);
  const double beta = section.number("beta", {0, 1e3, "s"}, 0);
  section.not_yet("ratios");
  section.finish();
  return {alpha, beta};
}

bool simulated(Section& section, const std::string& kind, const Patch& patch, const Shape& shape) {
  if (kind == "mean") return true;
  if (patch.disc) {
    section.error("disc", fmt::format("a {} support on a disc is understood, but cannot be simulated yet", kind));
    return false;
  }
  if (kind == "sliding" && !is_plane(shape, patch.face)) {
    section.error("face", "a sliding support on a curved face is understood, but cannot be simulated yet");
    return false;
  }
  return true;
}

std::optional<Support> read_support(Section section, const std::optional<Shape>& shape) {
  const Words words{{"fixed", "sliding", "mean", "driven"}, "support kind", "support kinds"};
  const auto kind = section.choice("kind", words);
  if (kind == "driven") {
    section.error("kind", "support kind 'driven' is understood, but cannot be simulated yet");
    return std::nullopt;
  }
  const auto patch = read_patch(section, shape);
  section.finish();
  if (!kind || !patch || !simulated(section, *kind, *patch, *shape)) return std::nullopt;
  using Kind = Support::Kind;
  return Support{*kind == "fixed" ? Kind::fixed : *kind == "sliding" ? Kind::sliding : Kind::mean, *patch};
}

std::vector<Support> read_supports(Section& body, const std::optional<Shape>& shape) {
  std::vector<Support> supports;
  for (Section& section : body.sections("support", {0, 64})) {
    const auto support = read_support(section, shape);
    if (!support) continue;
    const bool whole = !support->patch.disc;
    for (const Support& other : supports) {
      if (!whole || other.patch.disc || other.patch.face != support->patch.face) continue;
      section.error("face",
                    fmt::format("face '{}' is supported twice: one constraint would repeat or contradict the other",
                                support->patch.face));
      break;
    }
    supports.push_back(*support);
  }
  return supports;
}

void read_kinematics(Section& section) {
  if (!section.has("kinematics")) return;
  const auto kinematics = section.choice("kinematics", {{"linear", "finite"}, "kinematics", "kinematics"});
  if (kinematics == "finite") {
    section.error("kinematics", "kinematics 'finite' is understood, but cannot be simulated yet");
  }
}

}  // namespace

BodyDraft read_body(Section section) {
  BodyDraft body;
  body.name = section.name("name");
  if (auto shape = section.section("shape")) body.shape = read_shape(*shape);
  if (auto material = section.section("material")) body.material = read_material(*material);
  if (auto damping = section.section("damping", true)) body.damping = read_damping(*damping);
  if (auto resolution = section.section("resolution")) body.resolution = read_resolution(*resolution, body.shape);
  body.supports = read_supports(section, body.shape);
  read_kinematics(section);
  for (const char* key : {"pose", "velocity", "angular_velocity"}) section.not_yet(key);
  section.finish();
  return body;
}

}  // namespace mb
