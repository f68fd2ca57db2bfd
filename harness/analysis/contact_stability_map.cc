// Steps in contact over the stiffness of the layer: where energy grows, where the impact is off, and whether one
// linearised step says so before (contact_stability.h). The first body in eigenmodes, thrown as in the scene.
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "cases/contract/touchdown.h"
#include "harness/analysis/analyses.h"
#include "harness/analysis/contact_stability.h"
#include "harness/analysis/contact_tables.h"
#include "harness/analysis/contact_variants.h"
#include "harness/analysis/first_impact.h"
#include "harness/analysis/stability_grid.h"

namespace mb {

namespace {

constexpr double factors[] = {0.01, 0.1, 1, 10, 100};  // [-] on the layer's stiffness
constexpr int steps = 12;                              // from four durations of the contact down, by halves
constexpr int most_modes = 24;
constexpr double grown = 1.1;   // [-] of the energy at the start
constexpr double samples = 64;  // [-] to the contact's duration
constexpr const char* steppers[] = {"exact", "symplectic-euler", "newmark"};

Finding map_table() {
  return table(
      "contact-stability", "contact-stability", "Steps in contact over the layer's stiffness",
      "The first body in eigenmodes, thrown against what it meets as in the scene, with other layers and steps. "
      "Unstable: after the impact its energy is more than 1.1 of what it was, or a step has no solution. Inaccurate: "
      "bounded, and peak "
      "force or impulse more than 5 % off those of the closed form with the least step. Spectral radius: of one "
      "step linearised about the height of the impact, the layer pressed at one point as hard as over the "
      "contact's whole area; limit: the step where it passes 1. Growth over one contact that would not show is "
      "called too short to be seen. Average acceleration is stable at any step while the layer stays pressed; that "
      "contact begins and ends within a step no linear theory knows.",
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
       {"verdict", ""}});
}

Finding summary_table() {
  return table("contact-stability", "contact-stability-summary", "Whether steps in contact do what one of them says",
               "Cells of the map by what was found.",
               {{"integrator", ""},
                {"cells", ""},
                {"stable", ""},
                {"inaccurate", ""},
                {"unstable", ""},
                {"unstable within the limit", ""},
                {"bounded beyond the limit", ""},
                {"too short to be seen", ""}});
}

struct VariedLayer {
  Meeting meeting;
  double factor;
  PressedModes pressed;
  Scene scene;
  FirstImpact reference;
};

// Without rigid modes at zero distance: g of all modes kept.
PressedModes pressed(const ModalBody& body, const Modes& kept, const Scene& scene, const Meeting& meeting,
                     double factor) {
  const Body& of = scene.bodies.front();
  const Vector3d n = gap(surface_met(scene, of, meeting), meeting.X).normal;
  const Index n_modes = kept.size(), n_rigid = kept.n_rigid;
  VectorXd c(n_modes);
  for (Index i = 0; i < n_modes; ++i)
    c[i] = i < n_rigid ? 0 : kept.Phi.col(i).dot(apply_damping(body.system, VectorXd(kept.Phi.col(i))));
  const MatrixXd at = body.model.full->displacement_at(Matrix3Xd(meeting.X)) * kept.Phi;
  const double a = meeting.size.radius;
  return {kept.omega.cwiseAbs2(), c, at.transpose() * n, factor * meeting.size.stiffness * pi * a * a};
}

struct Cell {
  double dt, radius, energy, of_peak, of_impulse;
  StepClass found;
  std::string verdict;
};

Cell cell(const ContactVariants& variants, const VariedLayer& layer, const std::string& scheme, int r, double dt) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Trajectory run =
      variants.prepare(layer.scene, {.method = "eigenmodes", .modes = r, .time_step = dt, .integrator = scheme})
          ->simulate({.t = sample_times(layer.scene)});  // energies come with strains
  Cell one{dt,
           pressed_radius(layer.pressed, scheme, dt),
           std::numeric_limits<double>::infinity(),
           nan,
           nan,
           StepClass::unstable,
           ""};
  if (run.status == Status::ok) {
    const VectorXd& E = run.bodies.front().energy;
    one.energy = E(E.size() - 1) / E(0);
    const FirstImpact now = first_impact(run, run);
    one.of_peak = std::abs(now.peak / layer.reference.peak - 1);
    one.of_impulse = std::abs(now.impulse / layer.reference.impulse - 1);
    if (one.energy <= grown)
      one.found = std::max(one.of_peak, one.of_impulse) <= inaccurate_from ? StepClass::stable : StepClass::inaccurate;
  }
  // What one contact multiplies amplitudes by, squared: energy.
  const double growth = 2 * layer.meeting.size.duration / dt * std::log(one.radius);
  const bool grows = growth > std::log(grown), seen = one.found == StepClass::unstable;
  one.verdict = !grows && one.radius > 1 + 1e-6 ? "too short to be seen"
                : grows == seen                 ? "as predicted"
                : seen                          ? "unstable within the limit"
                                                : "bounded beyond the limit";
  return one;
}

struct Summary {
  double stable = 0, inaccurate = 0, unstable = 0, within = 0, beyond = 0, brief = 0;
  void add(const Cell& one) {
    (one.found == StepClass::stable ? stable : one.found == StepClass::inaccurate ? inaccurate : unstable) += 1;
    if (one.verdict == "unstable within the limit") within += 1;
    if (one.verdict == "bounded beyond the limit") beyond += 1;
    if (one.verdict == "too short to be seen") brief += 1;
  }
};

std::vector<VariedLayer> varied_layers(const AnalysisContext& context, const ContactVariants& variants,
                                       const Modes& kept, int r) {
  const Touchdown down = touchdown(*context.scene, context.scene->bodies.front());
  const auto met = std::ranges::min_element(down.meetings, {}, &Meeting::t);
  if (met == down.meetings.end() || !std::isfinite(met->t))
    throw std::invalid_argument("contact-stability: the first body meets nothing");
  const double T = met->size.duration;
  const Scene thrown = variants.with_flight(T, 8 * T);
  std::vector<VariedLayer> all;
  for (const double factor : factors) {
    VariedLayer layer{*met, factor, pressed(variants.body(), kept, *context.scene, *met, factor), thrown, {}};
    layer.scene.contacts.at(met->contact).stiffness = factor * met->size.stiffness;
    layer.scene.samples_per_second = samples / T;
    const Trajectory finest = variants.simulate(
        layer.scene, {.method = "eigenmodes", .modes = r, .time_step = 4 * T * std::pow(0.5, steps + 1)});
    layer.reference = first_impact(finest, finest);
    all.push_back(std::move(layer));
  }
  return all;
}

}  // namespace

std::vector<Finding> contact_stability(const AnalysisContext& context) {
  const ContactVariants variants(context);
  const int r = std::min(mode_counts(context).back(), most_modes);
  const Modes kept = leading(variants.body().modes, r);
  Finding map = map_table(), summary = summary_table();
  const std::vector<VariedLayer> all = varied_layers(context, variants, kept, r);
  for (const char* scheme : steppers) {
    Summary sum;
    for (const VariedLayer& layer : all) {
      const double T = layer.meeting.size.duration, limit = pressed_limit(layer.pressed, scheme, 8 * T);
      for (int i = 0; i < steps; ++i) {
        const double dt = 4 * T * std::pow(0.5, i);
        const Cell one = cell(variants, layer, scheme, r, dt);
        sum.add(one);
        map.rows.push_back({scheme, layer.factor, dt, dt / limit, one.radius, one.energy, one.of_peak, one.of_impulse,
                            to_string(one.found), limit, one.verdict});
      }
    }
    summary.rows.push_back({scheme, sum.stable + sum.inaccurate + sum.unstable, sum.stable, sum.inaccurate,
                            sum.unstable, sum.within, sum.beyond, sum.brief});
  }
  return {map, summary};
}

}  // namespace mb
