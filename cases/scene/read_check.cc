#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cases/scene/nearest.h"
#include "cases/scene/read_profile.h"
#include "cases/scene/read_runs.h"
#include "cases/scene/read_study.h"

namespace mb {

namespace {

constexpr std::size_t most_label = 200;  // [bytes] of a column's name or a row's first cell

// Marks are relative errors or times: beyond a million, or below what double precision resolves, a limit checks
// nothing.
const Range mark_range{0, 1e6};
const Range cell_range{-1e15, 1e15};  // of tables: any unit

void read_limit(Section& section, const Range& range, Check& check) {
  const bool has_most = section.has("at_most");
  const bool has_least = section.has("at_least");
  if (has_most && has_least) {
    section.error("at_least",
                  fmt::format("{} has both 'at_most' and 'at_least': exactly one of them", section.title()));
  } else if (has_most) {
    check.at_most = section.number("at_most", range);
  } else if (has_least) {
    check.at_least = section.number("at_least", range);
  } else {
    section.missing("at_most", "or 'at_least', a number in " + to_string(range));
  }
}

constexpr const char* full_order = "full-order";

template <class All, class One>
bool has(const All& all, const One& one) {
  return std::ranges::find(all, one) != all.end();
}

// Whether a rival or a stepping of the study answers a check that names its steps.
bool is_stepped(const Study& study, const Check& check, bool has_modes) {
  const auto steps = [&](const auto& runs) {
    return (check.integrator.empty() || runs.integrator == check.integrator) &&
           (!check.time_step || has(runs.time_steps, *check.time_step));
  };
  if (check.method == full_order) return std::ranges::any_of(study.rivals, steps);
  return std::ranges::any_of(study.steppings, [&](const Stepping& runs) {
    return steps(runs) && has(runs.methods, check.method) && (!has_modes || has(runs.modes, check.modes));
  });
}

// What it asks for must be among what the study runs in every profile, else the check would never be answered.
void check_is_run(Section& section, const Check& check, const CheckContext& context, bool has_modes) {
  const Study& study = *context.study;
  const auto is_asked = [&](RotationCoupling rotation) { return to_string(rotation) == check.rotation; };
  if (!check.rotation.empty() && std::ranges::none_of(study.rotations, is_asked))
    section.error("rotation", fmt::format("the study does not run rotation '{}'", check.rotation),
                  "'rotation' of a check is one of those in [study]");
  if (check.method == full_order || (!check.integrator.empty() && check.integrator != "exact")) {
    if (!is_stepped(study, check, has_modes))
      section.error(check.integrator.empty() ? "method" : "integrator",
                    fmt::format("{} does not run {}", context.runs, runs_of(check)),
                    "the study's rivals and steppings, and those of every profile that states others, step with it");
    return;
  }
  if (check.time_step && !has(study.contact_steps, *check.time_step))
    section.error("time_step", fmt::format("{} does not run {}", context.runs, runs_of(check)),
                  "the closed form takes steps while bodies touch, 'contact_steps' in [study]");
  if (has_modes && !study.modes.empty() && !has(study.modes, check.modes)) {
    section.error("modes", fmt::format("{} does not run {} modes", context.runs, check.modes),
                  "'modes' of a check is one of the mode counts in [study], and in every profile that states others");
  }
  if (!study.methods.empty() && !has(study.methods, check.method)) {
    section.error("method", fmt::format("the study does not run method '{}'", check.method),
                  "'method' of a check is one of the methods in [study]");
  }
}

// All where none is named.
std::vector<std::string> read_profiles(Section& section) {
  if (!section.has("profiles")) return profile_names();
  return values_of(read_unlike(section, "profiles", {profile_names(), "profile", "profiles"}));
}

std::optional<int> no_modes(Section& section, const std::optional<std::string>& method) {
  if (section.has("modes") && method) {
    section.findings().error(section.where_key("modes"), fmt::format("method '{}' takes no mode count", *method),
                             "leave 'modes' out");
  }
  return 0;
}

// Whose runs: method, where it takes one the mode count, coupling, integrator and step. Returns whether it has modes.
std::optional<bool> read_contender(Section& section, const Vocabulary& vocabulary, Check& check) {
  std::vector<std::string> methods = vocabulary.methods;
  if (!has(methods, full_order)) methods.emplace_back(full_order);
  const auto method = section.choice("method", {methods, "method", "methods"});
  const bool has_modes = method ? *method != full_order && takes_modes(*method, vocabulary) : section.has("modes");
  const auto modes = has_modes ? section.integer("modes", {0, 4096}) : no_modes(section, method);
  if (section.has("rotation"))
    check.rotation =
        section.choice("rotation", {{"rigid", "coupled", "unstiffened"}, "rotation", "rotations"}).value_or("");
  if (section.has("integrator"))
    check.integrator = section.choice("integrator", {vocabulary.integrators, "integrator", "integrators"}).value_or("");
  if (section.has("time_step")) check.time_step = section.number("time_step", {1e-15, 1e5, "s"});
  if (section.has("time_step") && !section.has("integrator"))
    section.error("time_step", "'time_step' of a check needs 'integrator', whose step it is");
  if (!method || !modes) return std::nullopt;
  check.method = *method;
  check.modes = *modes;
  return has_modes;
}

// How runs end, or what stands in a column, in place of the keys named.
bool read_status(Section& section, std::initializer_list<const char*> keys, Check& check) {
  for (const char* key : keys) {
    if (!section.has(key)) continue;
    section.findings().error(
        section.where_key(key),
        fmt::format("{} has both 'status' and '{}': a check is of a number or of how runs end", section.title(), key),
        "of a number: at_most or at_least, of runs with metric and truth; of how runs end: status");
  }
  check.status = section.choice("status", {{"unstable", "not_finite"}, "status", "statuses"}).value_or("");
  return !check.status.empty();
}

// Truth same_modes, which is of steps alone.
void check_steps(Section& section, const std::string& metric, const Vocabulary& vocabulary, const Check& check) {
  const bool is_reduced = !check.method.empty() && check.method != full_order && check.method != "full";
  if (!is_reduced || check.integrator.empty() || check.integrator == "exact")
    section.error("truth", "truth same_modes is the closed form of modes that are stepped otherwise",
                  "'method' takes modes of the mesh, 'integrator' steps them and is not exact");
  if (has(vocabulary.metrics, metric) && !has(vocabulary.metrics_of_steps, metric))
    section.error("metric", fmt::format("truth same_modes knows nothing of '{}'", metric),
                  fmt::format("of steps there are: {}", fmt::join(vocabulary.metrics_of_steps, ", ")));
}

// What of them: a metric against a truth, or how they end.
bool read_mark(Section& section, const CheckContext& context, const Vocabulary& vocabulary, Check& check) {
  if (section.has("status")) return read_status(section, {"metric", "truth", "at_most", "at_least"}, check);
  const auto metric = section.choice("metric", {vocabulary.metrics, "metric", "metrics"});
  const auto truth = section.choice("truth", {{"finer", "same_mesh", "exact", "same_modes"}, "truth", "truths"});
  if (truth == "exact" && !context.has_exact) {
    section.error("truth", "there is no exact truth: [truth] has no key 'exact', which names a closed form");
  }
  if (truth == "same_modes") check_steps(section, metric.value_or(""), vocabulary, check);
  if (!metric || !truth) return false;
  check.metric = *metric;
  check.truth = *truth;
  return true;
}

bool read_run(Section& section, const CheckContext& context, const Vocabulary& vocabulary, Check& check) {
  for (const char* key : {"reference", "kind"})
    if (section.has(key))
      section.findings().error(section.where_key(key), fmt::format("'{}' in {} of a run", key, section.title()),
                               "a run is held to 'truth'; of a table's numbers 'reference' and 'kind' say to what");
  const auto has_modes = read_contender(section, vocabulary, check);
  const bool is_marked = read_mark(section, context, vocabulary, check);
  if (has_modes && context.study) check_is_run(section, check, context, *has_modes);
  return has_modes && is_marked;
}

// The table must be one that an analysis makes, and the study must ask for that analysis.
void check_is_made(Section& section, const std::string& table, const CheckContext& context,
                   const Vocabulary& vocabulary) {
  const auto made = vocabulary.tables.find(table);
  if (made == vocabulary.tables.end()) {
    std::vector<std::string> names;
    for (const auto& [name, analysis] : vocabulary.tables) names.push_back(name);
    section.error("table", fmt::format("no analysis makes a table '{}'", table), suggestion(table, names, "tables"));
  } else if (context.study && std::ranges::count(context.study->analyses, made->second) == 0) {
    section.error("table",
                  fmt::format("table '{}' is of analysis '{}', which the study does not ask for", table, made->second),
                  "'analyses' in [study] lists what is made");
  }
}

// What the number is held to, where its table cannot know: both or none.
void read_footing(Section& section, Check& check) {
  const bool has_kind = section.has("kind");
  if (section.has("reference") != has_kind)
    section.error(has_kind ? "kind" : "reference",
                  fmt::format("{} has '{}' alone", section.title(), has_kind ? "kind" : "reference"),
                  "'reference' says what the number is held to, 'kind' what sort of a thing that is");
  check.reference = section.text("reference", most_label, "");
  if (!has_kind) return;
  const std::vector<std::string> kinds{"closed form", "published", "second route", "converged numbers", "property"};
  check.kind = section.choice("kind", {kinds, "kind", "kinds"}).value_or("");
}

// Of a table that an analysis makes: every row of a column, or those that begin with `row`.
bool read_table_check(Section& section, const CheckContext& context, const Vocabulary& vocabulary, Check& check) {
  for (const char* key : {"method", "metric", "truth", "modes", "rotation", "integrator", "time_step"}) {
    if (!section.has(key)) continue;
    section.findings().error(
        section.where_key(key),
        fmt::format("{} has both 'table' and '{}': a check is of a table or of a run", section.title(), key),
        "of a table: table, column, row; of a run: method, modes, rotation, integrator, time_step, metric, truth");
  }
  const auto table = section.name("table");
  const auto column = section.text("column", most_label);
  check.row = section.text("row", most_label, "");
  read_footing(section, check);
  if (table && context.study && context.study->analyses.empty()) {
    section.error("table", "no analysis makes tables: [study] has no key 'analyses'");
  } else if (table) {
    check_is_made(section, *table, context, vocabulary);
  }
  const bool is_whole = !section.has("status") || read_status(section, {"at_most", "at_least"}, check);
  if (!table || !column || !is_whole) return false;
  check.table = *table;
  check.column = *column;
  return true;
}

}  // namespace

std::optional<Check> read_check(Section section, const CheckContext& scene, const Vocabulary& vocabulary) {
  Check check{};
  check.profiles = read_profiles(section);
  CheckContext context = scene;
  if (!has(check.profiles, scene.profile)) context.study.reset();
  bool of_table = false;
  for (const char* key : {"table", "column", "row"}) of_table = section.has(key) || of_table;
  bool whole =
      of_table ? read_table_check(section, context, vocabulary, check) : read_run(section, context, vocabulary, check);
  const auto why = section.prose("why", 1000);
  if (!section.has("status")) read_limit(section, of_table ? cell_range : mark_range, check);
  section.finish();
  if (!whole || !why) return std::nullopt;
  check.why = *why;
  return check;
}

}  // namespace mb
