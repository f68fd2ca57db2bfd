// Canonical text: one line a value, doubles with 17 digits (which name each double uniquely), text with its length.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cases/scene/read_support.h"
#include "cases/scene/read_toml.h"
#include "cases/scene/resolution.h"
#include "mechanics/geometry/overloaded.h"

namespace mb {

namespace {

std::string number(double x) { return fmt::format("{:.17g}", x + 0.0); }  // -0 is 0

std::string vector(const Vector3d& x) { return fmt::format("{} {} {}", number(x[0]), number(x[1]), number(x[2])); }

std::string list(const std::vector<double>& values) {
  std::string out = fmt::format("{}", values.size());
  for (double x : values) out += fmt::format(" {}", number(x));
  return out;
}

std::string canonical(const Shape& shape) {
  const std::string numbers =
      std::visit(overloaded{[](const Box& box) { return vector(box.size); },
                            [](const Cylinder& cylinder) {
                              return fmt::format("{} {}", number(cylinder.radius), number(cylinder.length));
                            },
                            [](const Sphere& sphere) { return number(sphere.radius); },
                            [](const Superquadric& body) {
                              return fmt::format("{} {} {}", vector(body.semi_axes), number(body.e1), number(body.e2));
                            },
                            [](const TaperedSuperquadric& body) {
                              const Superquadric& straight = body.straight;
                              return fmt::format("{} {} {} {}", vector(straight.semi_axes), number(straight.e1),
                                                 number(straight.e2), number(body.taper));
                            }},
                 shape);
  return fmt::format("shape {} {}\n", kind_name(shape), numbers);
}

std::string canonical(const Patch& patch) {
  if (!patch.disc) return "face " + patch.face;
  return fmt::format("face {} disc {} {}", patch.face, vector(patch.disc->centre), number(patch.disc->radius));
}

std::string shaped(const char* kind, double amplitude, double start, const std::vector<double>& others) {
  std::string out = fmt::format("{} amplitude {} start {}", kind, number(amplitude), number(start));
  for (double x : others) out += fmt::format(" {}", number(x));
  return out;
}

std::string canonical(const History& history) {
  return std::visit(
      overloaded{[](const Step& h) { return shaped("step", h.amplitude, h.start, {}); },
                 [](const Pulse& h) { return shaped("pulse", h.amplitude, h.start, {h.duration}); },
                 [](const Ramp& h) { return shaped("ramp", h.amplitude, h.start, {h.duration}); },
                 [](const Harmonic& h) {
                   return shaped("harmonic", h.amplitude, h.start, {h.omega, h.phase});
                 },
                 [](const Chirp& h) {
                   return shaped("chirp", h.amplitude, h.start, {h.omega0, h.omega1, h.duration});
                 },
                 [](const Table& h) { return fmt::format("table t {} s {}", list(h.t), list(h.s)); },
                 [](const Expression& h) { return fmt::format("expression {}:{}", h.formula.size(), h.formula); }},
      history);
}

std::string canonical(const Material& material) {
  std::string out = fmt::format("material {} {} {}\n", number(material.youngs_modulus), number(material.poissons_ratio),
                                number(material.density));
  if (material.orthotropy) {
    out += fmt::format("orthotropy {} {} {}\n", vector(material.orthotropy->youngs_moduli),
                       vector(material.orthotropy->poissons_ratios), vector(material.orthotropy->shear_moduli));
  }
  for (const Inclusion& inclusion : material.inclusions) {
    out += fmt::format("inclusion {} {} {}\n", vector(inclusion.centre), vector(inclusion.size),
                       number(inclusion.stiffness_factor));
  }
  return out;
}

// What a scene may leave out stands here only where it is not the default: no text of a scene without it changes.
std::string stated(const char* key, const Vector3d& x) {
  return x.isZero(0) ? "" : fmt::format("{} {}\n", key, vector(x));
}

std::string canonical(const Pose& pose) {
  const Vector3d turn = pose.orientation.vec();
  std::string out = stated("position", pose.position);
  if (!turn.isZero(0)) out += fmt::format("orientation {} {}\n", number(pose.orientation.w()), vector(turn));
  return out;
}

std::string canonical(const Body& body) {
  std::string out = fmt::format("body {}\n{}", body.name, canonical(body.shape));
  if (body.theory != Theory::solid) out += fmt::format("theory {}\n", to_string(body.theory));
  if (body.kinematics != Kinematics::linear) out += fmt::format("kinematics {}\n", to_string(body.kinematics));
  out += canonical(body.material);
  out += fmt::format("damping {} {}\n", number(body.damping.alpha), number(body.damping.beta));
  if (!body.damping_ratios.empty()) out += fmt::format("ratios {}\n", list(body.damping_ratios));
  out += fmt::format("resolution {}\n", to_string(body.resolution));
  for (const Support& support : body.supports) {
    out += fmt::format("support {} {}\n", to_string(support.kind), canonical(support.patch));
    if (!support.drive) continue;
    out += fmt::format("drive {} {}\n", vector(support.drive->direction), canonical(support.drive->acceleration));
  }
  for (const Dashpot& dashpot : body.dashpots) {
    out +=
        fmt::format("dashpot {} {} {}\n", canonical(dashpot.patch), vector(dashpot.direction), number(dashpot.damping));
  }
  out += canonical(body.pose);
  if (body.settled) out += "starts settled\n";
  return out + stated("velocity", body.twist.velocity) + stated("angular_velocity", body.twist.angular_velocity);
}

std::string canonical(const Obstacle& obstacle) {
  const RigidSurface& surface = obstacle.surface;
  std::string out = fmt::format("obstacle {}\n", obstacle.name);
  out += std::visit(overloaded{[](const HalfSpace&) { return std::string("shape half-space\n"); },
                               [](const Shape& shape) { return canonical(shape); }},
                    surface.shape);
  if (surface.rounding != 0) out += fmt::format("rounding {}\n", number(surface.rounding));
  if (obstacle.striker) {
    const auto& [mass, speed, modulus, ratio] = *obstacle.striker;
    out += fmt::format("strikes {} {} {} {}\n", number(mass), number(speed), number(modulus), number(ratio));
  }
  return out + canonical(surface.pose);
}

std::string canonical(const ContactPair& pair) {
  return fmt::format("contact {} {} stiffness {} damping {} friction {} {}{}\n", pair.body, pair.obstacle,
                     pair.stiffness == 0 ? "auto" : number(pair.stiffness), number(pair.damping), number(pair.friction),
                     number(pair.slip_speed), pair.law == ContactLaw::hertz ? " law hertz" : "");
}

std::string canonical(const Load& load) {
  std::string out = fmt::format("load {}\nhistory {}\n", load.name, canonical(load.history));
  if (load.follows) out += "follows\n";
  for (const Traction& traction : load.tractions) {
    out += fmt::format("traction {} {} {} {}\n", traction.body, canonical(traction.patch), vector(traction.traction),
                       number(traction.pressure));
  }
  return out;
}

}  // namespace

std::string canonical(const Scene& scene) {
  std::string out = "scene 1\n";
  for (const Body& body : scene.bodies) out += canonical(body);
  for (const Load& load : scene.loads) out += canonical(load);
  out += stated("gravity", scene.gravity);
  for (const Obstacle& obstacle : scene.obstacles) out += canonical(obstacle);
  for (const ContactPair& pair : scene.contacts) out += canonical(pair);
  for (const Probe& probe : scene.probes) {
    out += fmt::format("probe {} {} {} {}\n", probe.name, probe.body, vector(probe.point), vector(probe.direction));
  }
  out += fmt::format("duration {}\nframe_rate {}\nsamples_per_second {}\n", number(scene.duration),
                     number(scene.frame_rate), number(scene.samples_per_second));
  if (scene.samples_from > 0) out += fmt::format("samples_from {}\n", number(scene.samples_from));
  out += fmt::format("truth {} finer {} coarser {}\n", number(scene.truth.relative_tolerance),
                     to_string(scene.truth.finer), to_string(scene.truth.coarser));
  if (!scene.truth.exact.empty()) out += fmt::format("exact {}\n", scene.truth.exact);
  if (!scene.reference_frequencies.hertz.empty()) {
    out += fmt::format("reference_frequencies {} {}\n", list(scene.reference_frequencies.hertz),
                       number(scene.reference_frequencies.uncertainty));
  }
  return out;
}

}  // namespace mb
