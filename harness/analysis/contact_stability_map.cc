// Steps in contact over the stiffness of the layer: where energy grows, where the impact is off, and whether one
// linearised step says so before (contact_stability.h). The first body and what it meets in eigenmodes, thrown as in
// the scene; one at rest as fast as its weight alone would have it fall.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>

#include "harness/analysis/analyses.h"
#include "harness/analysis/contact_stability.h"
#include "harness/analysis/contact_tables.h"
#include "harness/analysis/contact_variants.h"
#include "harness/analysis/encounter.h"
#include "harness/analysis/first_impact.h"
#include "harness/analysis/power_law.h"
#include "harness/analysis/stability_grid.h"

namespace mb {

namespace {

constexpr double factors[] = {0.01, 0.1, 1, 10, 100};  // [-] on the layer's stiffness
constexpr int steps = 12;                              // from two durations of the contact down, by halves
constexpr int most_modes = 24;
constexpr double grown = 1.1;   // [-] of the energy of the approach
constexpr double samples = 64;  // [-] to the contact's duration
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr const char* steppers[] = {"exact", "symplectic-euler", "central-difference", "explicit-euler", "newmark"};

Finding map_table() {
  return table(
      "contact-stability", "contact-stability", "Steps in contact over the layer's stiffness",
      "The first body in eigenmodes, thrown against what it meets as in the scene, with other layers and steps; what "
      "rests, as fast as its weight alone would have it fall. Energy: 1, and what is gained by the impact over the "
      "kinetic energy along the normal. Unstable: it is more than 1.1, or a step has no solution or throws bodies to "
      "where nothing is known of their contact. Inaccurate: bounded, and peak "
      "force or impulse more than 5 % off those of kicks at a quarter of the least step. Spectral radius: of one "
      "step linearised about the height of the impact, the layer pressed at one point as hard as over the "
      "contact's whole area; limit: the step where it passes 1, of average acceleration none. Growth over one contact, "
      "a step at least, that would not show is called too short to be seen; where steps leave neither force nor "
      "impulse, the touch is "
      "missed. Where the layer opens within a step energy is gained, too, of a rigid mass at most g/(1 - g), g = kappa "
      "h^2/(4 m), by each but explicit Euler: opening limit, the step where that is a tenth. What is beyond this limit "
      "alone may gain energy or not: may gain. Bars of errors: how far half of the least step moved what they are held "
      "against.",
      {{"integrator", ""},
       {"stiffness factor", "-"},
       {"dt", "s"},
       {"dt / limit", "-"},
       {"spectral radius", "-"},
       {"energy", "-"},
       {"peak force error", "-"},
       {"impulse error", "-"},
       {"found", ""},
       {"limit", "s"},
       {"opening limit", "s"},
       {"verdict", ""}});
}

Finding summary_table() {
  return table(
      "contact-stability", "contact-stability-summary", "Whether steps in contact do what one of them says",
      "Cells of the map by what was found. Error at the least step: the larger of peak force's and impulse's, of "
      "whichever layer has the largest; order: exponent of the same of the scene's own layer over the steps, "
      "where it lies between 1e-9 and a tenth. Unstable within the limit: within both limits. Unstable from: the least "
      "unstable step, of its layer's opening limit.",
      {{"integrator", ""},
       {"cells", ""},
       {"stable", ""},
       {"inaccurate", ""},
       {"unstable", ""},
       {"unstable within the limit", ""},
       {"bounded beyond the limit", ""},
       {"too short to be seen", ""},
       {"touch missed", ""},
       {"unstable from", "-"},
       {"error at the least step", "-"},
       {"order", "-"},
       {"standard error", "-"}});
}

struct VariedLayer {
  Encounter encounter;
  double factor;
  PressedModes pressed;
  Scene scene;
  std::shared_ptr<const FloatingBases> bases;
  FirstImpact reference;
  // [-] How far that may be off in peak and impulse: by halving the least step once more, of order one or more.
  double bar_of_peak = 0, bar_of_impulse = 0;
};

struct Cell {
  double dt, radius;
  double energy = std::numeric_limits<double>::infinity();
  double of_peak = nan, of_impulse = nan;
  StepClass found = StepClass::unstable;
  std::string verdict = {};
};

// Infinite where there is none.
double error(const Cell& one) {
  const double largest = std::max(one.of_peak, one.of_impulse);
  return std::isfinite(one.of_peak + one.of_impulse) ? largest : std::numeric_limits<double>::infinity();
}

// 1 and what is gained from the first sample to the last, over the kinetic energy of the approach.
double gained_energy(const Trajectory& run, const VariedLayer& layer) {
  double gain = 0;
  for (const BodyTrajectory& body : run.bodies) gain += body.energy(body.energy.size() - 1) - body.energy(0);
  const double speed = layer.scene.bodies.front().twist.velocity.dot(layer.encounter.normal);
  return 1 + gain / (layer.encounter.mass * speed * speed / 2);
}

// Nothing where it failed: a body that is thrown about may come to where nothing is known of the contact.
std::optional<Trajectory> finite_run(const VariedLayer& layer, const Integrator& scheme, double dt) try {
  Settings settings;
  settings.time_step = dt;
  Trajectory run = prepare_floating(layer.bases, scheme, settings)
                       ->simulate({.t = sample_times(layer.scene)});  // energies come with strains
  return run.status == Status::ok ? std::optional(std::move(run)) : std::nullopt;
} catch (const std::runtime_error&) {
  return {};
}

double opening_limit_of(const VariedLayer& layer) {
  return opening_limit(layer.pressed.kappa, layer.encounter.mass, grown - 1);
}

// [s] Of the contact in this layer: as seen, or where its reference lost it as the scene's own layer has it.
double duration_of(const VariedLayer& layer) {
  const double seen = layer.reference.duration;
  return std::isfinite(seen) && seen > 0 ? seen : layer.encounter.meeting.size.duration;
}

// What is seen against what the radius of one step says, which one contact takes to so many powers, one at least: what
// is pressed is for a whole step. And what opening may gain, of which nothing is known for explicit Euler.
const char* verdict_of(const Cell& one, const VariedLayer& layer, const std::string& scheme) {
  const double powers = std::max(1.0, duration_of(layer) / one.dt);
  const double growth = 2 * powers * std::log(one.radius);  // of energy
  const bool grows = growth > std::log(grown),
             may_gain = scheme != "explicit-euler" && one.dt > opening_limit_of(layer);
  if (one.found == StepClass::unstable) return grows || may_gain ? "as predicted" : "unstable within the limit";
  if (!std::isfinite(error(one))) return "touch missed";
  if (grows) return "bounded beyond the limit";
  if (one.radius > 1 + 1e-6) return "too short to be seen";
  return may_gain ? "may gain" : "as predicted";
}

Cell cell(const VariedLayer& layer, const Integrator& scheme, double dt) {
  Cell one{dt, pressed_radius(layer.pressed, scheme.name, dt)};
  if (const auto run = finite_run(layer, scheme, dt)) {
    one.energy = gained_energy(*run, layer);
    const FirstImpact now = first_impact(*run, *run);
    one.of_peak = std::abs(now.peak / layer.reference.peak - 1);
    one.of_impulse = std::abs(now.impulse / layer.reference.impulse - 1);
    if (one.energy <= grown) one.found = error(one) <= inaccurate_from ? StepClass::stable : StepClass::inaccurate;
  }
  one.verdict = verdict_of(one, layer, scheme.name);
  return one;
}

struct Summary {
  std::map<std::string, double> cells;  // by class, and by verdict
  double last_error = 0, last_bar = 0;  // at the least step, of the layer where they are largest together
  double unstable_from = std::numeric_limits<double>::infinity();
  std::vector<double> dt, own_error;  // of the scene's own layer

  void add(const Cell& one, double opening_limit) {
    if (one.found == StepClass::unstable) unstable_from = std::min(unstable_from, one.dt / opening_limit);
    ++cells[to_string(one.found)];
    ++cells[one.verdict];
  }
  double count(const std::string& name) const { return cells.contains(name) ? cells.at(name) : 0; }
  void keep_error(const Cell& one) {
    if (!(error(one) > 1e-9 && error(one) < 0.1)) return;
    dt.push_back(one.dt);
    own_error.push_back(error(one));
  }
  void keep_last(const Cell& one, const VariedLayer& layer) {
    const double both = layer.bar_of_peak + layer.bar_of_impulse;  // NaN where a reference lost the touch
    const double bar =
        std::isnan(both) ? std::numeric_limits<double>::infinity() : std::max(layer.bar_of_peak, layer.bar_of_impulse);
    if (error(one) + bar > last_error + last_bar) last_error = error(one), last_bar = bar;
  }
  std::vector<FindingCell> row(const std::string& integrator) const {
    const auto n = static_cast<Index>(dt.size());
    const PowerLaw law =
        power_law(Eigen::Map<const VectorXd>(dt.data(), n), Eigen::Map<const VectorXd>(own_error.data(), n));
    return {integrator,
            count("stable") + count("inaccurate") + count("unstable"),
            count("stable"),
            count("inaccurate"),
            count("unstable"),
            count("unstable within the limit"),
            count("bounded beyond the limit"),
            count("too short to be seen"),
            count("touch missed"),
            unstable_from,
            last_error,
            law.exponent,
            law.standard_error};
  }
};

std::vector<VariedLayer> varied_layers(const AnalysisContext& context, const ContactVariants& variants, int r) {
  const Encounter encounter = first_encounter(*context.scene);
  const auto& [contact, t, X, size, Y] = encounter.meeting;
  const double T = size.duration;
  Scene scene = thrown(*context.scene, 1, T, 8 * T);
  throw_at_least(scene, encounter, T);
  scene.samples_per_second = samples / T;
  std::vector<VariedLayer> all;
  for (const double factor : factors) {
    VariedLayer layer{encounter, factor, pressed(variants, encounter, r, factor), scene, nullptr, {}};
    layer.scene.contacts.at(contact).stiffness = factor * size.stiffness;
    const ContactContender finest{.method = "eigenmodes", .modes = r, .time_step = 2 * T * std::pow(0.5, steps + 1)};
    layer.bases = variants.bases(layer.scene, finest);
    const Trajectory reference = variants.simulate(layer.scene, finest);
    layer.reference = first_impact(reference, reference);
    ContactContender coarser = finest;
    coarser.time_step *= 2;
    const FirstImpact beside = first_impact(variants.simulate(layer.scene, coarser), reference);
    layer.bar_of_peak = std::abs(beside.peak / layer.reference.peak - 1);
    layer.bar_of_impulse = std::abs(beside.impulse / layer.reference.impulse - 1);
    all.push_back(std::move(layer));
  }
  return all;
}

}  // namespace

std::vector<Finding> contact_stability(const AnalysisContext& context) {
  const ContactVariants variants(context);
  const int r = std::min(mode_counts(context).back(), most_modes);
  Finding map = map_table(), summary = summary_table();
  const std::vector<VariedLayer> all = varied_layers(context, variants, r);
  for (const char* scheme : steppers) {
    const Integrator& integrator = context.catalogue.integrator(scheme);
    Summary sum;
    for (const VariedLayer& layer : all) {
      const double T = layer.encounter.meeting.size.duration, limit = pressed_limit(layer.pressed, scheme, 8 * T);
      const double opening = opening_limit_of(layer);
      for (int i = 0; i < steps; ++i) {
        const double dt = 2 * T * std::pow(0.5, i);
        const Cell one = cell(layer, integrator, dt);
        sum.add(one, opening);
        if (layer.factor == 1) sum.keep_error(one);
        if (i == steps - 1) sum.keep_last(one, layer);
        map.rows.push_back({scheme, layer.factor, dt, dt / limit, one.radius, one.energy, one.of_peak, one.of_impulse,
                            to_string(one.found), limit, opening, one.verdict});
        bar_last_row(map, {{"peak force error", layer.bar_of_peak}, {"impulse error", layer.bar_of_impulse}});
      }
    }
    summary.rows.push_back(sum.row(scheme));
    bar_last_row(summary, {{"error at the least step", sum.last_bar}});
  }
  return {map, summary};
}

}  // namespace mb
