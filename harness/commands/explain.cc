#include <fmt/ostream.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cases/contract/status.h"
#include "cases/exact/exact.h"
#include "cases/scene/keys.h"
#include "cases/scene/nearest.h"
#include "harness/analysis/analysis.h"
#include "harness/commands/commands.h"
#include "harness/commands/find_cases.h"
#include "harness/commands/formulas.h"
#include "harness/commands/paragraph.h"
#include "harness/metrics/definitions.h"
#include "harness/study/overrides.h"
#include "harness/study/plan.h"
#include "reports/claims.h"
#include "reports/definitions.h"

namespace mb {

namespace {

// What a word means; a word may mean several things.
struct Meaning {
  std::string kind, name;
  std::vector<std::pair<std::string, std::string>> parts;  // label and text; without text: left out
};

Meaning of_catalogue(const std::string& kind, const std::string& name, const std::string& doc) {
  const FormulaAndSource formula = formula_of(name);
  return {kind, name, {{"", doc}, {"formula", formula.formula}, {"source", formula.source}}};
}

// Claims as they stand where nothing is measured.
std::vector<Meaning> words_of_reports() {
  std::vector<Meaning> all;
  for (const Explanation& one : own_words()) all.push_back({"word of reports", one.term, {{"", one.text}}});
  for (const Claim& claim : claims(evaluate({})))
    all.push_back({"claim of the paper", claim.id, {{"", claim.statement + "."}, {"judged by", claim.criterion}}});
  return all;
}

// How runs end, as records and `check.status` say it.
std::vector<Meaning> words_of_status() {
  return {
      {"status of a run",
       unstable,
       {{"",
         "A result without a value: the answer grows past all bounds, as that of steps past the limit of their "
         "integrator. `unstable: by theory alone` where theory foretells the growth and the run does not show it: "
         "no check takes that for unstable."}}},
      {"status of a run", to_string(Status::not_finite), {{"", "A result without a value: the answer overflows."}}}};
}

// What --set replaces: for the contenders of all tables at once, what the key of a case file is for one.
std::vector<Meaning> words_of_set() {
  std::vector<Meaning> all;
  for (const std::string& key : set_keys()) {
    const std::string name = key.substr(key.find('.') + 1);
    const bool reduced = key.starts_with("modal."), full_order = key.starts_with("rival.");
    const std::string of = reduced      ? "of all reduced contenders"
                           : full_order ? "of all full-order contenders"
                                        : "of the study";
    std::string values = key == "rival.cells" ? "1x4,2x4" : "VALUE[,VALUE...]";
    Meaning meaning{"key of run --set", key, {{"", fmt::format("`{}` {}, in place of the case's.", name, of)}}};
    meaning.parts.push_back({"for example", fmt::format("run CASE --set {}={}", key, values)});
    if (key == "modal.integrators") meaning.parts.push_back({"", "`exact` is the closed form."});
    if (key == "rival.integrators" || key == "study.analyses") meaning.parts.push_back({"", "`none`: without any."});
    all.push_back(std::move(meaning));
  }
  return all;
}

std::vector<Meaning> vocabulary(const Catalogue& catalogue) {
  std::vector<Meaning> all;
  for (const MeasureDoc& d : measure_docs())
    all.push_back({"metric [" + d.unit + "]", d.name, {{"", d.meaning}, {"formula", d.formula}, {"source", d.source}}});
  for (const auto& method : catalogue.methods) all.push_back(of_catalogue("method", method->name(), method->doc()));
  for (const Integrator& i : catalogue.integrators) all.push_back(of_catalogue("integrator", i.name, i.doc));
  for (const Analysis& a : analysis_catalogue()) all.push_back(of_catalogue("analysis", a.name, a.doc));
  for (const ExactSolution& e : exact_solutions())
    all.push_back({"closed form", e.name, {{"", e.doc}, {"source", e.source}}});
  for (const KeyGroup& group : key_groups())
    for (const KeyDoc& key : group.keys)
      all.push_back({"key of case files",
                     key.path,
                     {{"", key.meaning},
                      {"takes", takes(key)},
                      {key.fallback.starts_with("required") ? "needed" : "default", key.fallback},
                      {"for example",
                       key.example.empty() ? "" : key.path.substr(key.path.rfind('.') + 1) + " = " + key.example}}});
  for (auto& words : {words_of_set(), words_of_status(), words_of_reports()})
    all.insert(all.end(), words.begin(), words.end());
  return all;
}

std::string limit(const Check& check) {
  const std::string what =
      check.table.empty()
          ? runs_of(check) + " " + (check.status.empty() ? check.metric + " against " + check.truth : "ends")
          : fmt::format("table {}, column {}{}", check.table, check.column, check.row.empty() ? "" : ", " + check.row);
  if (!check.status.empty()) return what + " " + check.status;
  return fmt::format("{} {} {}", what, check.at_most ? "at most" : "at least",
                     check.at_most ? *check.at_most : *check.at_least);
}

Meaning of_case(const Scene& scene, const Catalogue& catalogue) {
  Meaning meaning{
      "case",
      scene.name,
      {{"", scene.title + "."},
       {"exercises", scene.exercises},
       {"hard", scene.hard},
       {"purpose", scene.purpose},
       {"truth", fmt::format("{} at rtol {:g}, its bar the distance to {}{}", to_string(scene.truth.finer),
                             scene.truth.relative_tolerance, to_string(scene.truth.coarser),
                             scene.truth.exact.empty() ? "" : "; closed form " + scene.truth.exact)},
       {"runs", fmt::format("{}: {}", contenders(scene, catalogue).size(), fmt::join(scene.study.methods, ", "))}}};
  for (const Check& check : scene.checks) meaning.parts.push_back({"check", limit(check) + ": " + check.why});
  meaning.parts.push_back({"source", scene.source});
  return meaning;
}

void print(const Meaning& meaning, std::ostream& out) {
  fmt::print(out, "{} ({})\n", meaning.name, meaning.kind);
  for (const auto& [label, text] : meaning.parts)
    if (!text.empty()) out << paragraph(text, "  " + (label.empty() ? "" : label + ": "), "    ");
}

// Keys by their whole path or its last parts: "density", "material.density"; words of reports by their first,
// "speed-up", truths by their own: "same_mesh".
bool is_named(const Meaning& meaning, const std::string& word) {
  return meaning.name == word || meaning.name.ends_with("." + word) || meaning.name.starts_with(word + " ") ||
         meaning.name.starts_with(word + ",") || meaning.name == "truth " + word;
}

// By which it is listed: "closed form" of "closed form, steps in contact", which would be two of a list.
std::string listed_name(const Meaning& meaning) { return meaning.name.substr(0, meaning.name.find(',')); }

std::vector<std::string> known_words(const std::vector<Meaning>& meanings) {
  std::vector<std::string> words;
  for (const Meaning& meaning : meanings) {
    words.push_back(listed_name(meaning));
    if (meaning.name.starts_with("truth ")) words.push_back(meaning.name.substr(6));
    words.push_back(words.back().substr(words.back().rfind('.') + 1));
  }
  for (const auto& file : all_cases()) words.push_back(file.stem());
  std::sort(words.begin(), words.end());
  words.erase(std::unique(words.begin(), words.end()), words.end());
  return words;
}

bool is_case(const std::string& word) {
  if (word.ends_with(".toml")) return true;
  const auto files = all_cases();
  return std::any_of(files.begin(), files.end(), [&](const auto& file) { return file.stem() == word; });
}

}  // namespace

int explain_command(const ExplainOptions& options, const Catalogue& catalogue, const Console& console) {
  const std::vector<Meaning> all = vocabulary(catalogue);
  std::vector<Meaning> found;
  std::copy_if(all.begin(), all.end(), std::back_inserter(found),
               [&](const Meaning& meaning) { return is_named(meaning, options.word); });
  if (is_case(options.word))
    found.push_back(of_case(read_toml(find_case(options.word), catalogue.vocabulary()), catalogue));
  if (const KeyDoc* key = find_key(options.word); found.empty() && key != nullptr)
    std::copy_if(all.begin(), all.end(), std::back_inserter(found),
                 [&](const Meaning& meaning) { return meaning.name == key->path; });
  if (found.empty())
    throw UsageError("unknown word '" + options.word + "'; " + suggestion(options.word, known_words(all), "known"));
  for (size_t i = 0; i < found.size(); ++i) {
    if (i > 0) console.out << "\n";
    print(found[i], console.out);
  }
  return 0;
}

}  // namespace mb
