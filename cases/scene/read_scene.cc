#include "cases/scene/read_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "cases/scene/check_text.h"
#include "cases/scene/read_load.h"
#include "cases/scene/read_study.h"
#include "cases/scene/read_time.h"

namespace mb {

namespace {

// A truth of more wave crossings than that takes days, and its phase errors exceed any wave.
constexpr double most_crossings = 1e6;

// Another schema would make nonsense of every other message: it is the only one then.
void require_schema(Section& root) {
  if (!root.has("schema")) return root.missing("schema", "the number 1");
  const auto schema = root.integer("schema", {0, 1e9});
  if (schema == 1) return;
  if (schema) root.error("schema", fmt::format("schema {} is not known: this reader knows schema 1", *schema));
  throw CaseErrors(root.findings().found());
}

void read_prose(Section& root, Scene& scene) {
  scene.name = root.name("name").value_or("");
  scene.title = root.text("title", 200).value_or("");
  scene.purpose = root.text("purpose", 4000).value_or("");
  scene.source = root.text("source", 1000).value_or("");
}

class Names {  // of one kind, each once
 public:
  void add(Section& section, const std::string& name, const std::string& kind) {
    if (name.empty() || names_.insert(name).second) return;
    section.error("name", fmt::format("there is another {} named '{}'", kind, name));
  }

 private:
  std::set<std::string> names_;
};

void check_crossings(Section& section, const BodyDraft& body, const Times& times) {
  if (!body.shape || !body.material) return;
  const double crossings = times.longest() * shear_wave_speed(*body.material) / extent(*body.shape);
  if (crossings <= most_crossings) return;
  section.findings().error(section.where(),
                           fmt::format("a shear wave crosses the body {:.3g} times in {} s: at most {:.0g}", crossings,
                                       times.longest(), most_crossings),
                           "check the units of youngs_modulus, density, shape and duration");
}

std::vector<BodyDraft> read_bodies(Section& root, const Times& times) {
  std::vector<BodyDraft> bodies;
  Names names;
  for (Section& section : root.sections("body", {1, 64})) {
    bodies.push_back(read_body(section));
    names.add(section, bodies.back().name.value_or(""), "body");
    check_crossings(section, bodies.back(), times);
    if (bodies.size() == 2) {
      section.findings().error(section.where(), "more than one body is understood, but cannot be simulated yet");
    }
  }
  return bodies;
}

void read_loads(Section& root, const std::vector<BodyDraft>& bodies, const HistoryContext& context, Scene& scene) {
  Names names;
  for (Section& section : root.sections("load", {1, 64})) {
    auto load = read_load(section, bodies, context);
    if (!load) continue;
    names.add(section, load->name, "load");
    scene.loads.push_back(std::move(*load));
  }
}

void read_probes(Section& root, const std::vector<BodyDraft>& bodies, Scene& scene) {
  Names names;
  for (Section& section : root.sections("probe", {0, 64})) {
    auto probe = read_probe(section, bodies);
    if (!probe) continue;
    names.add(section, probe->name, "probe");
    scene.probes.push_back(std::move(*probe));
  }
}

void read_checks(Section& root, const std::optional<Study>& study, const Vocabulary& vocabulary, Scene& scene) {
  std::set<std::string> asked;
  for (Section& section : root.sections("check", {0, 64})) {
    auto check = read_check(section, study, vocabulary);
    if (!check) continue;
    if (!asked
             .insert(fmt::format("{} {} {} {} {}", check->method, check->metric, check->truth, check->modes,
                                 check->at_most.has_value()))
             .second) {
      section.findings().error(section.where(), "this check stands here twice");
    }
    scene.checks.push_back(std::move(*check));
  }
}

Body completed(const BodyDraft& draft) {
  return {draft.name.value(), draft.shape.value(),      draft.material.value(),
          draft.damping,      draft.resolution.value(), draft.supports};
}

// As much of the scene as can be read; complete where nothing was recorded.
Scene read_parts(Section& root, const std::filesystem::path& folder, const Vocabulary& vocabulary,
                 const std::string& profile) {
  Scene scene{};
  require_schema(root);
  read_prose(root, scene);
  const Times times = read_times(root);
  const std::vector<BodyDraft> bodies = read_bodies(root, times);
  read_loads(root, bodies, {folder, times.longest()}, scene);
  read_probes(root, bodies, scene);
  if (auto section = root.section("truth")) scene.truth = read_truth(*section, bodies).value_or(TruthSettings{});
  std::optional<Study> study;
  if (auto section = root.section("study")) study = read_study(*section, bodies, vocabulary, times.shortest());
  read_checks(root, study, vocabulary, scene);
  for (const char* key : {"gravity", "contact"}) root.not_yet(key);
  root.finish();
  if (!root.findings().empty()) return scene;
  for (const BodyDraft& body : bodies) scene.bodies.push_back(completed(body));
  scene.study = study.value();
  scene.duration = times.duration.at(profile);
  scene.frame_rate = times.frame_rate;
  scene.samples_per_second = times.samples_per_second;
  scene.profile = profile;
  return scene;
}

}  // namespace

Scene read_scene(std::string_view text, const std::string& file, const std::filesystem::path& folder,
                 const Vocabulary& vocabulary, const std::string& profile) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);  // a byte order mark is no content
  Findings findings(file, text);
  const auto document = check_text(text, findings) ? parse_toml(text, findings) : std::nullopt;
  if (!document) throw CaseErrors(findings.found());
  Section root(*document, {}, "", false, findings);
  Scene scene = read_parts(root, folder, vocabulary, profile);
  if (!findings.empty()) throw CaseErrors(findings.found());
  return scene;
}

}  // namespace mb
