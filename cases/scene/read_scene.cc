#include "cases/scene/read_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "cases/contract/kept.h"
#include "cases/contract/touchdown.h"
#include "cases/scene/check_text.h"
#include "cases/scene/closed_form.h"
#include "cases/scene/contact_rules.h"
#include "cases/scene/names.h"
#include "cases/scene/number_text.h"
#include "cases/scene/read_load.h"
#include "cases/scene/read_mesh.h"
#include "cases/scene/read_profile.h"
#include "cases/scene/read_study.h"
#include "cases/scene/read_theory.h"
#include "cases/scene/read_time.h"
#include "cases/scene/read_truth.h"

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
  scene.purpose = root.prose("purpose", 4000).value_or("");
  scene.source = root.prose("source", 1000).value_or("");
  scene.exercises = root.text("exercises", 200, "");
  scene.hard = root.prose("hard", 1000, "");
  if (!root.has("runs_in")) return;
  if (const auto profiles = read_unlike(root, "runs_in", {profile_names(), "profile", "profiles"})) {
    scene.runs_in.clear();
    for (const auto& profile : *profiles) scene.runs_in.push_back(profile.value);
  }
}

// A file cut between two lines may be a shorter one: where it says how it ends, it is told from that.
void check_end(Section& root) {
  const bool says = root.has("closed_by"), ends = root.has("end");
  if (says && root.choice("closed_by", {{"end"}, "last table", "last tables"}) && !ends)
    root.error("closed_by", "the file is cut: its last table [end] is missing",
               "restore what is gone, or end the file with a line [end]");
  if (!ends) return;
  if (const int last = root.where_last().line; last > root.where("end").line)
    root.error("end", fmt::format("the file goes on after its last table, down to line {}", last),
               "move [end] below that");
  if (auto end = root.section("end", true)) end->finish();
}

void check_crossings(Section& section, const BodyDraft& body, const Times& times) {
  const auto longest = times.longest();
  if (!body.shape || !body.material || !longest) return;
  const double crossings = *longest * shear_wave_speed(*body.material) / extent(*body.shape);
  if (crossings <= most_crossings) return;
  section.findings().error(
      section.where(),
      fmt::format("a shear wave crosses the body {} times in {} s: at most {}",
                  number_beside(crossings, most_crossings), number_text(*longest), number_text(most_crossings)),
      "check the units of youngs_modulus, density, shape and duration");
}

std::vector<BodyDraft> read_bodies(Section& root, const Times& times, const HistoryContext& history) {
  std::vector<BodyDraft> bodies;
  Names names("body");
  for (Section& section : root.sections("body", {1, 64})) {
    bodies.push_back(read_body(section, history));
    names.add(section, bodies.back().name);
    check_crossings(section, bodies.back(), times);
  }
  return bodies;
}

// What moves a scene with contact is another matter (contact_rules.h).
void require_load(Section& root, const std::vector<BodyDraft>& bodies, const ContactDrafts& contacts) {
  if (contacts.any) return;
  const bool driven = std::any_of(bodies.begin(), bodies.end(), [](const auto& body) { return body.supports.driven; });
  if (!root.has("load") && !driven) {
    root.missing("load", "1 to 64 tables [[load]], or a driven support of a body: nothing would move");
  } else if (root.is_empty_array("load") && !driven) {
    root.error("load", "'load' in the case is empty, and no support of a body is driven: nothing would move");
  }
}

void read_loads(Section& root, const std::vector<BodyDraft>& bodies, const HistoryContext& context, Scene& scene) {
  Names names("load");
  for (Section& section : root.sections("load", {0, 64})) {
    if (auto load = read_load(section, bodies, context, names)) scene.loads.push_back(std::move(*load));
  }
}

void read_probes(Section& root, const std::vector<BodyDraft>& bodies, Scene& scene) {
  Names names("probe");
  for (Section& section : root.sections("probe", {0, 64})) {
    if (auto probe = read_probe(section, bodies, names)) scene.probes.push_back(std::move(*probe));
  }
}

std::string twin_key(const Check& check) {
  return fmt::format("{} {} {} {} {}\n{}\n{} {}", runs_of(check), check.metric, check.truth, check.status, check.table,
                     check.column, check.row, check.at_most.has_value());
}

void read_checks(Section& root, const CheckContext& context, const Vocabulary& vocabulary, Scene& scene) {
  std::set<std::string> asked;
  for (Section& section : root.sections("check", {0, 128})) {
    auto check = read_check(section, context, vocabulary);
    if (!check) continue;
    bool is_new = true, is_asked = false;
    for (const std::string& profile : check->profiles) {
      is_new = asked.insert(profile + "\n" + twin_key(*check)).second && is_new;
      is_asked = is_asked || profile == context.profile;
    }
    if (!is_new) section.findings().error(section.where(), "this check stands here twice");
    if (is_asked) scene.checks.push_back(std::move(*check));
  }
}

// What is read from outside the text.
struct Context {
  std::filesystem::path folder;
  const Vocabulary& vocabulary;
};

TruthDraft read_truth_of(Section& root, std::optional<Section>& profile, const std::vector<BodyDraft>& bodies) {
  const auto section = root.section("truth");
  return section ? read_truth(*section, profile, bodies) : TruthDraft{std::nullopt, true, {}};
}

// The bodies, without a profile's meshes, and what they meet.
std::vector<BodyDraft> read_mechanics(Section& root, const Times& times, const HistoryContext& history, Scene& scene) {
  const auto gravity = root.vector_or_zero("gravity", {-1e4, 1e4, "m/s^2"});
  std::vector<BodyDraft> bodies = read_bodies(root, times, history);
  const ContactDrafts contacts = read_contacts(root, bodies);
  bodies = with_touches(std::move(bodies), contacts);
  require_load(root, bodies, contacts);
  read_loads(root, bodies, history, scene);
  check_contact_rules(root, bodies, contacts, gravity);
  scene.gravity = gravity.value_or(Vector3d::Zero());
  check_strikes(root, bodies, contacts);
  scene.obstacles = placed(contacts.obstacles, contacts.pairs, bodies);
  scene.contacts = contacts.pairs;
  return bodies;
}

// What only a scene that is complete can be asked.
void check_whole(Section& root, const Scene& scene, const TruthDraft& truth, const Times& times) {
  Findings& findings = root.findings();
  const std::string problem = closed_form_problem(scene);
  if (!problem.empty()) findings.error(truth.exact_at, printable(problem, 300));
  for (const Body& body : scene.bodies)
    if (const std::string overlap = overlap_at_start(scene, body); !overlap.empty())
      findings.error(root.where_key("contact"), printable(overlap, 300));
  if (const std::string kept = kept_problem(scene); !kept.empty()) findings.error(times.samples_per_second_at, kept);
}

// As much of the scene as can be read; complete where nothing was recorded.
Scene read_parts(Section root, const Context& context, const std::string& name) {
  Scene scene{};
  require_schema(root);
  check_end(root);
  read_prose(root, scene);
  const Times times = read_times(root);
  auto profile = read_profile(root, name);
  const HistoryContext history{context.folder, times.longest(), times.looked_at()};
  const std::vector<BodyDraft> bodies = bodies_in(profile, read_mechanics(root, times, history, scene));
  for (const BodyDraft& body : bodies)
    if (body.resolution) check_ratios(body, *body.resolution, body.damping.ratios_at, root.findings());
  read_probes(root, bodies, scene);
  const TruthDraft truth = read_truth_of(root, profile, bodies);
  std::optional<Study> study;
  if (auto section = root.section("study")) {
    study = read_study(*section, profile, bodies, context.vocabulary, {times.shortest(), times.duration.at(name)});
  }
  if (auto section = root.section("reference_frequencies", true)) {
    scene.reference_frequencies = read_reference_frequencies(*section);
  }
  const bool has_runs = profile && (profile->has("modes") || profile->has("rival") || profile->has("stepping"));
  const std::string runs = has_runs ? fmt::format("profile {}", name) : "the study";
  read_checks(root, {study, name, runs, truth.has_exact}, context.vocabulary, scene);
  if (profile) profile->finish();
  root.finish();
  if (!root.findings().empty()) return scene;
  for (const BodyDraft& body : bodies) scene.bodies.push_back(completed(body));
  scene.truth = truth.settings.value();
  scene.study = study.value();
  scene.duration = times.duration.at(name).value();
  scene.frame_rate = times.frame_rate;
  scene.samples_per_second = times.samples_per_second;
  scene.samples_from = times.samples_from;
  scene.profile = name;
  check_whole(root, scene, truth, times);
  return scene;
}

std::optional<TomlTable> document_of(std::string_view text, Findings& findings) {
  return check_text(text, findings) ? parse_toml(text, findings) : std::nullopt;
}

std::string_view without_mark(std::string_view text) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);  // a byte order mark is no content
  return text;
}

constexpr Position beginning{1, 1, 1};  // the header of what stands under none

}  // namespace

Scene read_scene(std::string_view text, const std::string& file, const std::filesystem::path& folder,
                 const Vocabulary& vocabulary, const std::string& profile) {
  text = without_mark(text);
  Findings findings(file, text);
  const auto document = document_of(text, findings);
  if (!document) throw CaseErrors(findings.found());
  const Section root(*document, beginning, "", false, findings);
  std::map<std::string, Scene> scenes;
  for (const std::string& name : profile_names()) scenes[name] = read_parts(root, {folder, vocabulary}, name);
  if (!findings.empty()) throw CaseErrors(findings.found());
  return scenes.at(profile);
}

std::map<std::string, std::string> keys_asked(std::string_view text, const std::filesystem::path& folder,
                                              const Vocabulary& vocabulary) {
  text = without_mark(text);
  Findings findings("case", text);
  const auto document = document_of(text, findings);
  if (!document) return {};
  const Section root(*document, beginning, "", false, findings);
  try {
    for (const std::string& name : profile_names()) read_parts(root, {folder, vocabulary}, name);
  } catch (const CaseErrors&) {  // of another schema: nothing else was asked for
  }
  return findings.asked();
}

}  // namespace mb
