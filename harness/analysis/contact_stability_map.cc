// Steps in contact over the stiffness of the layer: where energy grows, where the impact is off, and whether one
// linearised step says so before (contact_stability.h). The first body and what it meets in eigenmodes, with static
// shapes or without, thrown as in the scene; one at rest as fast as its weight alone would have it fall.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "harness/analysis/analyses.h"
#include "harness/analysis/contact_cells.h"
#include "harness/analysis/power_law.h"

namespace mb {

namespace {

constexpr int most_modes = 24;
constexpr int more_of_euler = 4;  // steps of explicit Euler in the scene's own layer: the first dozen are too coarse
constexpr const char* steppers[] = {"exact", "symplectic-euler", "central-difference", "explicit-euler", "newmark"};

// Both maps are of the same columns.
struct MappedMethod {
  const char *method, *table, *in;
  std::vector<double> factors;  // [-] on the layer's stiffness
};
const MappedMethod mapped_methods[] = {
    {"eigenmodes", "contact-stability", "in eigenmodes", {0.01, 0.1, 1, 10, 100}},
    {"static-correction", "corrected-stability", "in eigenmodes and static shapes", {1, 100}}};

Finding map_table(const MappedMethod& mapped) {
  return table(
      "contact-stability", mapped.table, "Steps in contact over the layer's stiffness, " + std::string(mapped.in),
      "The first body in modes as titled, thrown against what it meets as in the scene, with other layers and twelve "
      "steps, from two durations of the impact on the layer down, each half the one before, of explicit Euler in the "
      "scene's own layer sixteen; what rests, as fast as "
      "its weight alone would have it fall. Energy: 1, and what the motion gains by the impact, with what the layer "
      "took away from it, over the kinetic energy along the normal. Unstable: it is more than 1.1, or a step has no "
      "solution or throws bodies to where nothing is known of their contact. Inaccurate: bounded, and peak force or "
      "impulse more than 5 % off, bars included, those of kicks at a quarter of the least step. Spectral radius: of "
      "one step linearised about the height of the impact, the layer pressed at one point as hard as over the "
      "contact's whole area, static shapes in series with it; limit: the step where it passes 1, of average "
      "acceleration none. Growth over one contact, a step at least, that would not show is called too short to be "
      "seen; where steps leave neither force nor impulse, the touch is missed. Where the layer opens within a step "
      "energy is gained, too, of a rigid mass at most g/(1 - g), g = kappa h^2/(4 m), by each but explicit Euler: "
      "opening limit, the step where that is a tenth. What is beyond this limit alone may gain energy or not: may "
      "gain. Bars: of errors how far half of the least step moved what they are held against, and twice what a nudge "
      "of 1e-12 of the speed, in every way the body may move, moves: where many samples touch in turn rounding "
      "decides which. Unstable is what this run says, whatever the bar of its energy.",
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

Finding summary_table(const MappedMethod& mapped) {
  return table(
      "contact-stability", mapped.table + std::string("-summary"),
      "Whether steps in contact do what one of them says, " + std::string(mapped.in),
      "Cells of the map by what was found; share: of what is as predicted, which no other verdict is. Error at the "
      "least step: the larger of peak force's and impulse's, of "
      "whichever layer has the largest; order: exponent of the same of the scene's own layer over the steps, where "
      "it lies between 1e-9 and a tenth. Unstable within the limit: within both limits. Unstable from: the least "
      "unstable step, of its layer's opening limit. All of one impact: what rests opens its layer again and again, "
      "and small gains add up until damping takes them away.",
      {{"integrator", ""},
       {"cells", ""},
       {"stable", ""},
       {"inaccurate", ""},
       {"unstable", ""},
       {"unstable within the limit", ""},
       {"bounded beyond the limit", ""},
       {"too short to be seen", ""},
       {"touch missed", ""},
       {"may gain", ""},
       {"share as predicted", ""},
       {"unstable from", "-"},
       {"error at the least step", "-"},
       {"order", "-"},
       {"standard error", "-"}});
}

struct Summary {
  std::map<std::string, double> cells;  // by class, and by verdict
  double last_error = 0, last_bar = 0;  // at the least step, of the layer where they are largest together
  double unstable_from = std::numeric_limits<double>::infinity();
  std::vector<double> dt, own_error;  // of the scene's own layer

  void add(const ContactCell& one, double opening_limit) {
    if (one.found == StepClass::unstable) unstable_from = std::min(unstable_from, one.dt / opening_limit);
    ++cells[to_string(one.found)];
    ++cells[one.verdict];
  }
  double count(const std::string& name) const { return cells.contains(name) ? cells.at(name) : 0; }
  void keep_error(const ContactCell& one) {
    if (!(one.error() > 1e-9 && one.error() < 0.1)) return;
    dt.push_back(one.dt);
    own_error.push_back(one.error());
  }
  void keep_last(const ContactCell& one) {
    if (one.error() + one.bar() > last_error + last_bar) last_error = one.error(), last_bar = one.bar();
  }
  std::vector<FindingCell> row(const std::string& integrator) const {
    const auto n = static_cast<Index>(dt.size());
    const PowerLaw law =
        power_law(Eigen::Map<const VectorXd>(dt.data(), n), Eigen::Map<const VectorXd>(own_error.data(), n));
    const double all = count("stable") + count("inaccurate") + count("unstable");
    return {integrator,
            all,
            count("stable"),
            count("inaccurate"),
            count("unstable"),
            count("unstable within the limit"),
            count("bounded beyond the limit"),
            count("too short to be seen"),
            count("touch missed"),
            count("may gain"),
            count("as predicted") / all,
            unstable_from,
            last_error,
            law.exponent,
            law.standard_error};
  }
};

// Cells of one scheme in all layers.
void map_steps(const std::vector<VariedLayer>& layers, const Integrator& scheme, Finding& map, Finding& summary) {
  Summary sum;
  for (const VariedLayer& layer : layers) {
    const double T = layer.impact.duration, limit = pressed_limit(layer.pressed, scheme.name, 8 * T);
    const double opening = layer.opening_limit();
    const bool to_converge = layer.factor == 1 && scheme.name == "explicit-euler";
    for (int i = 0; i < contact_steps_tried + (to_converge ? more_of_euler : 0); ++i) {
      const ContactCell one = contact_cell(layer, scheme, contact_step(layer.impact, i));
      sum.add(one, opening);
      if (layer.factor == 1) sum.keep_error(one);
      if (i == contact_steps_tried - 1) sum.keep_last(one);
      map.rows.push_back({scheme.name, layer.factor, one.dt, one.dt / limit, one.radius, one.energy, one.of_peak,
                          one.of_impulse, to_string(one.found), limit, opening, one.verdict});
      bar_last_row(map, {{"energy", one.bar_of_energy},
                         {"peak force error", one.bar_of_peak},
                         {"impulse error", one.bar_of_impulse}});
    }
  }
  summary.rows.push_back(sum.row(scheme.name));
  bar_last_row(summary, {{"error at the least step", sum.last_bar}});
}

}  // namespace

std::vector<Finding> contact_stability(const AnalysisContext& context) {
  const ContactVariants variants(context);
  const int r = std::min(mode_counts(context).back(), most_modes);
  std::vector<Finding> all;
  for (const MappedMethod& mapped : mapped_methods) {
    Finding map = map_table(mapped), summary = summary_table(mapped);
    const auto layers = varied_layers(context, variants, mapped.method, r, mapped.factors);
    for (const char* scheme : steppers) map_steps(layers, context.catalogue.integrator(scheme), map, summary);
    all.push_back(std::move(map));
    all.push_back(std::move(summary));
  }
  return all;
}

}  // namespace mb
