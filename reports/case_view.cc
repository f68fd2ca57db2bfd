// What a case is, in one line, and what is known of its truths.
#include <algorithm>
#include <tuple>

#include "reports/case_words.h"
#include "reports/number.h"
#include "reports/views.h"
#include "reports/warnings.h"
#include "reports/words.h"

namespace mb {
namespace {

std::string describe(const Material& material) {
  const std::string rho = ", rho = " + in(material.density, "kg/m^3");
  if (material.orthotropy) return "orthotropic, largest modulus " + in(material.youngs_modulus, "Pa") + rho;
  return "E = " + in(material.youngs_modulus, "Pa") + ", nu = " + format_setting(material.poissons_ratio) + rho;
}

std::string describe(const Patch& patch) {
  return patch.face + (patch.disc ? " (disc of radius " + in(patch.disc->radius, "m") + ")" : "");
}

std::string supports_of(const Body& body) {
  if (body.theory == Theory::euler_bernoulli) return "Euler-Bernoulli beam simply supported at both ends";
  if (body.theory == Theory::kirchhoff) return "Kirchhoff plate simply supported on four edges";
  static constexpr const char* names[] = {"fixed", "sliding", "held in the mean", "on a diaphragm", "driven"};
  std::map<Support::Kind, std::vector<std::string>> places;
  for (const Support& one : body.supports) places[one.kind].push_back(describe(one.patch));
  std::vector<std::string> parts;
  for (const auto& [kind, at] : places) {
    parts.push_back(names[static_cast<std::size_t>(kind)] + (" at " + joined(at, ", ")));
  }
  return parts.empty() ? "free" : joined(parts, "; ");
}

std::string damping_of(const Body& body) {
  std::vector<std::string> parts;
  if (body.damping.alpha > 0) parts.push_back("alpha = " + in(body.damping.alpha, "1/s"));
  if (body.damping.beta > 0) parts.push_back("beta = " + in(body.damping.beta, "s"));
  const std::vector<double>& zeta = body.damping_ratios;
  if (!zeta.empty()) {
    const auto [least, largest] = std::ranges::minmax(zeta);
    const std::string range = least == largest ? "" : " to " + format_setting(largest);
    parts.push_back("ratio " + format_setting(least) + range + " of the first " +
                    counted(zeta.size(), "elastic mode", "elastic modes"));
  }
  return parts.empty() ? "undamped" : "damping " + joined(parts, ", ");
}

// ", 1215 degrees of freedom" as a full-order run of that mesh stepped them; "" where no record says.
std::string size_of(const Evaluation& evaluation, const Scene& scene, const Body& body) {
  for (const Run& run : evaluation.runs) {
    const bool own = run.case_name == scene.name && run.profile == scene.profile && !is_reduced(run.contender) &&
                     run.contender.resolution == body.resolution;
    if (own && run.n_unknowns > 0) return ", " + std::to_string(run.n_unknowns) + " degrees of freedom";
  }
  return "";
}

struct Described {
  std::string operator()(const Step&) const { return "step"; }
  std::string operator()(const Pulse& s) const { return "pulse of " + in(s.duration, "s"); }
  std::string operator()(const Ramp& s) const { return "ramp over " + in(s.duration, "s"); }
  std::string operator()(const Harmonic& s) const { return "harmonic of " + in(s.omega, "rad/s"); }
  std::string operator()(const Chirp& s) const {
    return "chirp from " + format_setting(s.omega0) + " to " + in(s.omega1, "rad/s");
  }
  std::string operator()(const Table&) const { return "table"; }
  std::string operator()(const Expression&) const { return "formula"; }
};

std::string describe(const Load& load) {
  std::vector<std::string> parts;
  for (const Traction& one : load.tractions) {
    if (one.traction.norm() > 0) parts.push_back(in(one.traction.norm(), "Pa") + " on " + describe(one.patch));
    if (one.pressure != 0) parts.push_back("pressure " + in(one.pressure, "Pa") + " on " + describe(one.patch));
  }
  return load.name + " (" + std::visit(Described{}, load.history) + "): " + joined(parts, ", ");
}

// A metric of a truth in words; another keeps its name.
std::string spelled_out(const std::string& metric, const Scene& scene) {
  constexpr double bands = 20;  // of truth-above-band: samples_per_second over the frequency above which it counts
  if (metric == "truth-strain") return "largest strain:";
  if (metric == "truth-rotation") return "largest rotation:";
  if (metric != "truth-above-band") return metric;
  return "share of kinetic energy above " + in(scene.samples_per_second / bands, "Hz") + ":";
}

}  // namespace

std::string case_line(const Evaluation& evaluation, const Scene& scene) {
  std::vector<std::string> bodies, loads;
  for (const Body& body : scene.bodies) {
    // Unknowns are recorded of the scene as a whole.
    const std::string size = scene.bodies.size() == 1 ? size_of(evaluation, scene, body) : "";
    bodies.push_back(
        body.name + ": " +
        joined({describe(body.shape), describe(body.material), supports_of(body), damping_of(body),
                (body.theory == Theory::solid ? "mesh " : "") + describe_mesh(body.resolution, body.theory) + size},
               "; "));
  }
  for (const Load& load : scene.loads) loads.push_back(describe(load));
  const std::string contact = joined(contact_sentences(scene), ". ");
  const std::string loading = loads.empty() ? contact.empty() ? "No loads" : "" : "Loads: " + joined(loads, "; ");
  return joined({joined(bodies, ". "), loading, contact}, ". ") + ".";
}

std::vector<std::string> truth_sentences(const Evaluation& evaluation, const Scene& scene) {
  std::map<std::tuple<std::string, std::string, std::string>, std::string> said;  // by truth, metric and subject
  for (const Record& record : evaluation.input.records) {
    if (!is_of_truth(record) || record.case_name != scene.name || record.profile != scene.profile) continue;
    std::string text =
        "Of the truth " + record.truth + ": " + spelled_out(record.metric, scene) + " " + format_record(record);
    if (!record.unit.empty() && record.unit != "-") text += " " + record.unit;
    if (!record.subject.empty()) text += " (" + record.subject + ")";
    said[{record.truth, record.metric, record.subject}] = text + ".";
  }
  std::vector<std::string> sentences;
  for (const auto& [key, sentence] : said) sentences.push_back(sentence);
  for (const std::string& warning : warnings(evaluation.input.records, scene))
    sentences.push_back("Warning: " + warning + ".");
  return sentences;
}

}  // namespace mb
