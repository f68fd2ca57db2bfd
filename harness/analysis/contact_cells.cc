#include "harness/analysis/contact_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace mb {

namespace {

constexpr double grown = 1.1;   // [-] of the energy of the approach
constexpr double samples = 64;  // [-] to the contact's duration

double gained(const VectorXd& x) { return x.size() > 0 ? x(x.size() - 1) - x(0) : 0; }

// 1 and what is gained from the first sample to the last, over the kinetic energy of the approach. What the layer takes
// away is added back: steps fed it.
double gained_energy(const Trajectory& run, const VariedLayer& layer) {
  double gain = 0;
  for (const BodyTrajectory& body : run.bodies) gain += gained(body.energy) + gained(body.contact.dissipated);
  const double speed = layer.scene.bodies.front().twist.velocity.dot(layer.encounter.normal);
  return 1 + gain / (layer.encounter.mass * speed * speed / 2);
}

// Every way of moving at once by 1e-12 of the speed, above the rounding of modes and far below what anybody asks for:
// a symmetric impact would hide what turns a body over.
FloatingBases nudged(FloatingBases bases) {
  const double nudge = 1e-12 * bases.front().start.v.norm();  // [m/s]
  for (FloatingBasis& one : bases) {
    one.start.p.array() += nudge * std::sqrt(one.body.mass);
    if (!one.body.free) continue;
    one.start.v.array() += nudge;
    one.start.L.array() += nudge * std::sqrt(one.body.mass * one.body.inertia.trace());
  }
  return bases;
}

// Nothing where it failed: a body that is thrown about may come to where nothing is known of the contact.
std::optional<Trajectory> finite_run(const VariedLayer& layer, const std::shared_ptr<const FloatingBases>& bases,
                                     const Integrator& scheme, double dt) try {
  Settings settings;
  settings.time_step = dt;
  Trajectory run = prepare_floating(bases, scheme, settings)
                       ->simulate({.t = sample_times(layer.scene)});  // energies come with strains
  return run.status == Status::ok ? std::optional(std::move(run)) : std::nullopt;
} catch (const std::runtime_error&) {
  return {};
}

// [s] Of the contact in this layer: as seen, or where its reference lost it as expected.
double duration_of(const VariedLayer& layer) {
  const double seen = layer.reference.duration;
  return std::isfinite(seen) && seen > 0 ? seen : layer.impact.duration;
}

// What is seen against what the radius of one step says, which one contact takes to so many powers, one at least: what
// is pressed is for a whole step. And what opening may gain, of which nothing is known for explicit Euler.
const char* verdict_of(const ContactCell& one, const VariedLayer& layer, const std::string& scheme) {
  const double powers = std::max(1.0, duration_of(layer) / one.dt);
  const double growth = 2 * powers * std::log(one.radius);  // of energy
  const bool grows = growth > std::log(grown), may_gain = scheme != "explicit-euler" && one.dt > layer.opening_limit();
  if (one.found == StepClass::unstable) return grows || may_gain ? "as predicted" : "unstable within the limit";
  if (!std::isfinite(one.error())) return "touch missed";
  if (grows) return "bounded beyond the limit";
  if (one.radius > 1 + 1e-6) return "too short to be seen";
  return may_gain ? "may gain" : "as predicted";
}

struct Apart {
  double peak, impulse;  // [-]
};
Apart apart(const FirstImpact& one, const FirstImpact& reference) {
  return {std::abs(one.peak / reference.peak - 1), std::abs(one.impulse / reference.impulse - 1)};
}

// Infinity where either is none.
double larger(double a, double b) {
  return std::isfinite(a + b) ? std::max(a, b) : std::numeric_limits<double>::infinity();
}

// Of one run.
struct Seen {
  double energy = std::numeric_limits<double>::infinity();
  Apart off{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
};
Seen seen_of(const VariedLayer& layer, const std::shared_ptr<const FloatingBases>& bases, const Integrator& scheme,
             double dt) {
  const auto run = finite_run(layer, bases, scheme, dt);
  if (!run) return {};
  return {gained_energy(*run, layer), apart(first_impact(*run, *run), layer.reference)};
}

}  // namespace

double VariedLayer::opening_limit() const { return mb::opening_limit(pressed, encounter.mass, grown - 1); }

double ContactCell::error() const { return larger(of_peak, of_impulse); }

double contact_step(const ImpactOnLayer& impact, int i) { return 2 * impact.duration * std::pow(0.5, i); }

double ContactCell::bar() const { return larger(bar_of_peak, bar_of_impulse); }

ContactCell contact_cell(const VariedLayer& layer, const Integrator& scheme, double dt) {
  ContactCell one{dt, pressed_radius(layer.pressed, scheme.name, dt)};
  const Seen seen = seen_of(layer, layer.bases, scheme, dt), nudged = seen_of(layer, layer.nudged, scheme, dt);
  one.energy = seen.energy, one.of_peak = seen.off.peak, one.of_impulse = seen.off.impulse;
  one.bar_of_energy = 2 * std::abs(seen.energy - nudged.energy);
  one.bar_of_peak = layer.bar_of_peak + 2 * std::abs(seen.off.peak - nudged.off.peak);
  one.bar_of_impulse = layer.bar_of_impulse + 2 * std::abs(seen.off.impulse - nudged.off.impulse);
  if (one.energy <= grown)
    one.found = one.error() + one.bar() <= inaccurate_from ? StepClass::stable : StepClass::inaccurate;
  one.verdict = verdict_of(one, layer, scheme.name);
  return one;
}

std::vector<VariedLayer> varied_layers(const AnalysisContext& context, const ContactVariants& variants,
                                       const std::string& method, int r, const std::vector<double>& factors) {
  const Encounter encounter = first_encounter(*context.scene);
  std::vector<VariedLayer> all;
  for (const double factor : factors) {
    const ImpactOnLayer impact = impact_on_layer(encounter, factor);
    const double T = impact.duration;
    Scene scene = thrown(*context.scene, 1, T, 8 * T);
    throw_at_least(scene, encounter, T);
    scene.samples_per_second = samples / T;
    scene.contacts.at(encounter.meeting.contact).stiffness = impact.stiffness;
    VariedLayer layer{encounter, factor, impact, pressed(variants, encounter, r, impact), scene, nullptr, nullptr, {}};
    const ContactContender finest{
        .method = method, .modes = r, .time_step = contact_step(impact, contact_steps_tried + 1)};
    layer.bases = variants.bases(layer.scene, finest);
    layer.nudged = std::make_shared<const FloatingBases>(nudged(*layer.bases));
    layer.pressed.yields = static_yields(*layer.bases, encounter, impact.radius);
    const Trajectory reference = variants.simulate(layer.scene, finest);
    if (reference.status != Status::ok)
      throw std::runtime_error(
          fmt::format("the steps of {:.3g} s to which those of a layer {:.3g} times as stiff are held "
                      "ended: {}",
                      finest.time_step, factor, to_string(reference.status)));
    layer.reference = first_impact(reference, reference);
    ContactContender coarser = finest;
    coarser.time_step *= 2;
    const Apart bar = apart(first_impact(variants.simulate(layer.scene, coarser), reference), layer.reference);
    layer.bar_of_peak = bar.peak, layer.bar_of_impulse = bar.impulse;
    all.push_back(std::move(layer));
  }
  return all;
}

}  // namespace mb
