#include "harness/study/overrides.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <cmath>

#include "cases/scene/nearest.h"
#include "cases/scene/resolution.h"
#include "harness/commands/usage_error.h"

namespace mb {

namespace {

enum class Kind { word, count, number, cells };
struct Key {
  const char* name;
  Kind kind;
  double least, most;
  std::vector<std::string> words;
};

std::vector<Key> keys(const Vocabulary& v) {
  auto with_none = [](std::vector<std::string> words) { return words.push_back("none"), words; };
  auto reduced = v.methods;
  std::erase(reduced, "full-order");
  return {{"modal.methods", Kind::word, 0, 0, reduced},
          {"modal.modes", Kind::count, 0, 4096, {}},
          {"modal.integrators", Kind::word, 0, 0, v.integrators},
          {"modal.time_steps", Kind::number, 1e-12, 1e5, {}},
          {"modal.relative_tolerances", Kind::number, 1e-12, 1e-2, {}},
          {"rival.integrators", Kind::word, 0, 0, with_none(v.integrators)},
          {"rival.degrees", Kind::count, 1, 4, {}},
          {"rival.cells", Kind::cells, 0, 256, {}},
          {"rival.time_steps", Kind::number, 1e-12, 1e5, {}},
          {"rival.relative_tolerances", Kind::number, 1e-12, 1e-2, {}},
          {"study.analyses", Kind::word, 0, 0, with_none(v.analyses)}};
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  size_t start = 0;
  for (size_t end; (end = text.find(separator, start)) != std::string::npos; start = end + 1)
    parts.push_back(text.substr(start, end - start));
  parts.push_back(text.substr(start));
  return parts;
}

template <class T>
std::optional<T> parsed(const std::string& text) {
  T value{};
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && rest == end ? std::optional(value) : std::nullopt;
}

std::vector<int> cells_of(const std::string& text) {
  std::vector<int> cells;
  for (const std::string& entry : split(text, 'x')) cells.push_back(parsed<int>(entry).value_or(-1));
  return cells;
}

// Why a value does not fit its key; empty: it does.
std::string problem(const Key& key, const std::string& value) {
  const auto range = [&] { return fmt::format("must be in [{:g}, {:g}]", key.least, key.most); };
  const auto inside = [&](double x) { return x >= key.least && x <= key.most; };
  switch (key.kind) {
    case Kind::word:
      if (std::ranges::find(key.words, value) != key.words.end()) return "";
      return fmt::format("'{}' is unknown; {}", value, suggestion(value, key.words, "words"));
    case Kind::count: {
      const auto count = parsed<int>(value);
      return count && inside(*count) ? "" : fmt::format("'{}' is no whole number or out of range: {}", value, range());
    }
    case Kind::number: {
      const auto number = parsed<double>(value);
      return number && inside(*number) ? "" : fmt::format("'{}' is no number or out of range: {}", value, range());
    }
    case Kind::cells: {
      const auto cells = cells_of(value);
      const bool good = cells.size() <= 3 && std::ranges::all_of(cells, inside);
      return good ? "" : fmt::format("'{}' is no mesh like 1x4 with entries in [0, 256]", value);
    }
  }
  return "";
}

}  // namespace

Overrides::Overrides(const std::vector<std::string>& assignments, const Vocabulary& vocabulary)
    : adaptive_(vocabulary.adaptive_integrators) {
  std::vector<std::string> problems;
  const std::vector<Key> known = keys(vocabulary);
  std::vector<std::string> names;
  for (const Key& key : known) names.push_back(key.name);
  for (const std::string& assignment : assignments) {
    const size_t equals = assignment.find('=');
    const std::string name = assignment.substr(0, equals);
    const auto key = std::ranges::find(known, name, &Key::name);
    if (equals == std::string::npos || key == known.end()) {
      problems.push_back(
          fmt::format("--set {}: unknown key '{}'; {}", assignment, name, suggestion(name, names, "keys")));
      continue;
    }
    const auto values = split(assignment.substr(equals + 1), ',');
    for (const std::string& value : values)
      if (const auto why = problem(*key, value); !why.empty())
        problems.push_back(fmt::format("--set {}: {}", name, why));
    if (!values_.emplace(name, values).second) problems.push_back(fmt::format("--set {}: given twice", name));
  }
  if (!problems.empty()) throw UsageError(fmt::format("{}", fmt::join(problems, "\nmodalbench: ")));
}

const std::vector<std::string>* Overrides::find(const std::string& key) const {
  const auto found = values_.find(key);
  return found == values_.end() ? nullptr : &found->second;
}
std::vector<double> Overrides::numbers(const std::string& key) const {
  std::vector<double> all;
  if (const auto* values = find(key))
    for (const auto& value : *values) all.push_back(parsed<double>(value).value());
  return all;
}
std::vector<int> Overrides::integers(const std::string& key) const {
  std::vector<int> all;
  for (const double x : numbers(key)) all.push_back(static_cast<int>(x));
  return all;
}

void Overrides::apply_modal(Study& study) const {
  if (const auto* methods = find("modal.methods")) {
    study.methods = *methods;
    for (Stepping& stepping : study.steppings) stepping.methods = *methods;
  }
  if (find("modal.modes")) {
    study.modes = integers("modal.modes");
    for (Stepping& stepping : study.steppings) stepping.modes = study.modes;
  }
  const auto* integrators = find("modal.integrators");
  if (!integrators) {
    if (find("modal.time_steps") || find("modal.relative_tolerances"))
      throw UsageError("--set: modal.time_steps and modal.relative_tolerances need modal.integrators");
    return;
  }
  study.steppings.clear();
  const auto methods = study.methods;
  if (std::ranges::find(*integrators, "exact") == integrators->end()) study.methods.clear();
  for (const std::string& integrator : *integrators) {
    if (integrator == "exact") continue;
    const bool adaptive = std::ranges::find(adaptive_, integrator) != adaptive_.end();
    const char* const key = adaptive ? "modal.relative_tolerances" : "modal.time_steps";
    const auto values = numbers(key);
    if (values.empty()) throw UsageError(fmt::format("--set: {} needs {}", integrator, key));
    Stepping stepping{integrator, methods, study.modes, {}, {}};
    (adaptive ? stepping.relative_tolerances : stepping.time_steps) = values;
    study.steppings.push_back(std::move(stepping));
  }
}

void Overrides::apply_rivals(Study& study, const Shape& shape) const {
  const auto* integrators = find("rival.integrators");
  if (integrators) {
    std::erase_if(study.rivals, [&](const Rival& rival) {
      return std::ranges::find(*integrators, rival.integrator) == integrators->end();
    });
    for (const std::string& name : *integrators) {
      if (name == "none" || std::ranges::find(study.rivals, name, &Rival::integrator) != study.rivals.end()) continue;
      study.rivals.push_back({name, {1, 2}, {}, {}, {}});
    }
  }
  for (Rival& rival : study.rivals) {
    const bool adaptive = std::ranges::find(adaptive_, rival.integrator) != adaptive_.end();
    if (find("rival.degrees")) rival.degrees = integers("rival.degrees");
    if (const auto* cells = find("rival.cells")) {
      rival.cells.clear();
      for (const auto& text : *cells) rival.cells.push_back(cells_of(text));
    }
    if (adaptive && find("rival.relative_tolerances")) rival.relative_tolerances = numbers("rival.relative_tolerances");
    if (!adaptive && find("rival.time_steps")) rival.time_steps = numbers("rival.time_steps");
    if (rival.cells.empty() || (rival.time_steps.empty() && rival.relative_tolerances.empty()))
      throw UsageError(fmt::format("--set: rival {} needs rival.cells and rival.{}", rival.integrator,
                                   adaptive ? "relative_tolerances" : "time_steps"));
    for (const auto& cells : rival.cells)
      if (cells.size() != n_cell_entries(shape))
        throw UsageError(fmt::format("--set rival.cells: a mesh of this body has {} entries", n_cell_entries(shape)));
  }
}

Scene Overrides::applied(Scene scene) const {
  apply_modal(scene.study);
  apply_rivals(scene.study, scene.bodies.front().shape);
  if (const auto* analyses = find("study.analyses")) {
    scene.study.analyses = *analyses;
    std::erase(scene.study.analyses, "none");
  }
  return scene;
}

}  // namespace mb
