#include "cases/scene/read_runs.h"

#include <fmt/format.h>

#include <algorithm>

#include "cases/scene/number_text.h"
#include "cases/scene/read_mesh.h"
#include "cases/scene/resolution.h"

namespace mb {

namespace {

constexpr double most_steps = 1e6;  // of one run: a day of stepping even for a small model
constexpr double most_runs = 1000;

bool is_among(const std::string& word, const std::vector<std::string>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

void check_ascending(const std::vector<Located<int>>& numbers, const std::string& key, Findings& findings) {
  for (std::size_t i = 1; i < numbers.size(); ++i) {
    if (numbers[i].value > numbers[i - 1].value) continue;
    findings.error(numbers[i].where,
                   fmt::format("'{}' must ascend: {} follows {}", key, numbers[i].value, numbers[i - 1].value));
  }
}

using CellLists = std::vector<Located<std::vector<int>>>;

void check_meshes(const Rival& rival, const CellLists& cells, const BodyDraft& body, Findings& findings) {
  const auto& shape = rival.graded > 0 ? body.shape : body.of_kind;
  if (!shape || !body.theory) return;
  const int degree = rival.degrees.empty() ? 1 : rival.degrees.back();
  for (const auto& entry : cells) {
    if (!check_mesh(*shape, {degree, entry.value, rival.graded}, entry.where, findings, *body.theory)) continue;
    for (const int each : rival.degrees) check_ratios(body, {each, entry.value, rival.graded}, entry.where, findings);
  }
}

// Those of the second body, one a mesh of the first. Without bodies these are not known, but not against it.
std::vector<std::vector<int>> read_second_cells(Section& section, const Rival& rival, const RunContext& context) {
  if (context.bodies.size() == 1 || !section.has("second_cells")) return {};
  const auto cells = section.integer_lists("second_cells", any_cells_range, {1, 64}, {1, 3});
  if (!cells) return {};
  if (!context.bodies.empty()) check_meshes(rival, *cells, context.bodies[1], section.findings());
  if (!rival.cells.empty() && cells->size() != rival.cells.size())
    section.error("second_cells", fmt::format("'second_cells' has {} entries, 'cells' {}: one a mesh", cells->size(),
                                              rival.cells.size()));
  return values_of(cells);
}

// Integrators that step in time: the closed form has neither a step nor a tolerance.
std::string read_integrator(Section& section, const Vocabulary& vocabulary) {
  Words words{vocabulary.integrators, "stepping integrator", "stepping integrators"};
  std::erase(words.known, "exact");
  return section.choice("integrator", words).value_or("");
}

struct Accuracy {
  std::vector<double> time_steps, relative_tolerances;
  std::size_t size() const { return time_steps.size() + relative_tolerances.size(); }
};

Range step_range(const std::optional<double>& duration) {
  if (!duration) return {0, 1e5, "s", true};  // as a duration
  return {nine_digits(*duration / most_steps), *duration, "s"};
}

// Time steps of an integrator with fixed ones, tolerances of one that chooses its own.
Accuracy read_accuracy(Section& section, const std::string& integrator, const RunContext& context) {
  const bool adaptive = is_among(integrator, context.vocabulary.adaptive_integrators);
  const char* const own = adaptive ? "relative_tolerances" : "time_steps";
  const char* const other = adaptive ? "time_steps" : "relative_tolerances";
  const bool is_known = !integrator.empty();
  if (section.has(other) && is_known) {
    section.findings().error(section.where_key(other),
                             fmt::format("integrator '{}' takes '{}', not '{}'", integrator, own, other));
    if (!section.has(own)) return {};  // once is enough
  }
  if (!section.has(own) && !is_known) return {};
  const auto values = section.numbers(own, adaptive ? Range{1e-12, 1e-2} : step_range(context.duration), {1, 64});
  Accuracy accuracy;
  (adaptive ? accuracy.relative_tolerances : accuracy.time_steps) = values.value_or(std::vector<double>{});
  return accuracy;
}

int read_graded(Section& section, const std::vector<BodyDraft>& bodies) {
  const int graded = section.integer("graded", graded_range, 0);
  if (graded > 0 && touch(bodies) == false) {
    section.error("graded", "'graded' is of no use: no [[contact]] names a body");
  }
  return graded;
}

// An integrator of one's own may have neither contact forces nor forces of finite strain.
void check_impact(const std::string& integrator, Section& section, const RunContext& context) {
  const auto& able = context.vocabulary.impact_integrators;
  const auto finite = [](const BodyDraft& body) { return body.kinematics == Kinematics::finite; };
  const bool impact = touch(context.bodies) == true || std::ranges::any_of(context.bodies, finite);
  if (!impact || integrator.empty() || is_among(integrator, able)) return;
  section.findings().error(section.where("integrator"),
                           fmt::format("'{}' steps no full order in contact or of finite kinematics", integrator),
                           fmt::format("there are: {}", fmt::join(able, ", ")));
}

void read_meshes(Rival& rival, Section& section, const RunContext& context) {
  const auto degrees = section.integers("degrees", degree_range, {1, 4});
  if (degrees) check_ascending(*degrees, "degrees", section.findings());
  rival.degrees = values_of(degrees);
  const auto cells = section.integer_lists("cells", any_cells_range, {1, 64}, {1, 3});
  rival.cells = values_of(cells);
  rival.graded = read_graded(section, context.bodies);
  if (cells && !context.bodies.empty()) check_meshes(rival, *cells, context.bodies.front(), section.findings());
  rival.second_cells = read_second_cells(section, rival, context);
}

// Of the bodies' own meshes, which are what they are.
void refuse_without_cells(Section& section) {
  for (const char* key : {"graded", "second_cells"}) {
    if (!section.has(key)) continue;
    section.findings().error(section.where_key(key),
                             fmt::format("'{}' needs 'degrees' and 'cells': without, the bodies' own meshes", key));
  }
}

Rival read_rival(Section section, const RunContext& context) {
  Rival rival;
  rival.integrator = read_integrator(section, context.vocabulary);
  check_impact(rival.integrator, section, context);
  if (section.has("degrees") || section.has("cells"))
    read_meshes(rival, section, context);
  else
    refuse_without_cells(section);
  Accuracy accuracy = read_accuracy(section, rival.integrator, context);
  rival.time_steps = std::move(accuracy.time_steps);
  rival.relative_tolerances = std::move(accuracy.relative_tolerances);
  section.finish();
  return rival;
}

Stepping read_stepping(Section section, const RunContext& context) {
  Stepping stepping;
  stepping.integrator = read_integrator(section, context.vocabulary);
  const auto methods = read_methods(section, context.vocabulary);
  if (methods) check_functions(*methods, context.bodies, context.vocabulary, section.findings());
  stepping.methods = values_of(methods);
  const bool has_modes = section.has("modes");
  if (methods && !take_modes(*methods, context.vocabulary)) {
    if (has_modes) {
      section.findings().error(section.where_key("modes"), "'modes' is of no use: no method here takes a mode count");
    }
  } else if (methods || has_modes) {
    const auto modes = read_modes(section);
    if (modes) check_mode_counts(*modes, context.bodies, section.findings());
    stepping.modes = values_of(modes);
  }
  Accuracy accuracy = read_accuracy(section, stepping.integrator, context);
  stepping.time_steps = std::move(accuracy.time_steps);
  stepping.relative_tolerances = std::move(accuracy.relative_tolerances);
  section.finish();
  return stepping;
}

double n_runs(const Rival& rival) {
  const size_t meshes = rival.cells.empty() ? 1 : rival.degrees.size() * rival.cells.size();
  return static_cast<double>(meshes * (rival.time_steps.size() + rival.relative_tolerances.size()));
}

double n_runs(const Stepping& stepping, const Vocabulary& vocabulary) {
  double n = 0;
  for (const std::string& method : stepping.methods) {
    n += takes_modes(method, vocabulary) ? static_cast<double>(stepping.modes.size()) : 1;
  }
  return n * static_cast<double>(stepping.time_steps.size() + stepping.relative_tolerances.size());
}

void check_runs(Section& section, const char* key, double n) {
  if (n <= most_runs) return;
  section.error(key, fmt::format("{:.0f} {} runs: at most {:.0f}", n, key, most_runs));
}

}  // namespace

std::optional<std::vector<Located<std::string>>> read_unlike(Section& section, const std::string& key,
                                                             const Words& words) {
  const auto found = section.choices(key, words, {1, 64});
  if (!found) return std::nullopt;
  for (auto here = found->begin(); here != found->end(); ++here) {
    if (std::any_of(found->begin(), here, [&](const auto& other) { return other.value == here->value; })) {
      section.findings().error(here->where, fmt::format("'{}' is listed twice", here->value));
    }
  }
  return found;
}

std::optional<Methods> read_methods(Section& section, const Vocabulary& vocabulary) {
  Words reduced{vocabulary.methods, "reduced method", "reduced methods"};
  std::erase(reduced.known, "full-order");  // a rival, not a method that is swept over mode counts
  return read_unlike(section, "methods", reduced);
}

bool takes_modes(const std::string& method, const Vocabulary& vocabulary) {
  return !is_among(method, vocabulary.methods_without_modes);
}

bool take_modes(const Methods& methods, const Vocabulary& vocabulary) {
  return std::any_of(methods.begin(), methods.end(),
                     [&](const auto& method) { return takes_modes(method.value, vocabulary); });
}

void check_functions(const Methods& methods, const std::vector<BodyDraft>& bodies, const Vocabulary& vocabulary,
                     Findings& findings) {
  for (const auto& method : methods) {
    if (method.value == "full" || takes_modes(method.value, vocabulary)) continue;
    for (const BodyDraft& body : bodies) {
      if (body.theory.value_or(Theory::solid) == Theory::solid) continue;
      findings.error(method.where, fmt::format("'{}' is of polynomials: body '{}' of theory '{}' moves in sine modes",
                                               method.value, body.name.value_or(""), to_string(*body.theory)));
    }
  }
}

std::optional<ModeCounts> read_modes(Section& section) {
  const auto modes = section.integers("modes", {0, 4096}, {1, 64});
  if (modes) check_ascending(*modes, "modes", section.findings());
  return modes;
}

void check_mode_counts(const ModeCounts& modes, const std::vector<BodyDraft>& bodies, Findings& findings) {
  for (const BodyDraft& body : bodies) {
    if (!body.shape || !body.resolution || !body.theory) continue;
    const double most = n_elastic(*body.shape, *body.resolution, *body.theory);
    for (const auto& entry : modes) {
      if (entry.value <= most) continue;
      findings.error(entry.where, fmt::format("{} elastic modes: {} of body '{}' has at most {:.0f}", entry.value,
                                              to_string(*body.resolution), body.name.value_or(""), most));
    }
  }
}

std::vector<Rival> read_rivals(Section& section, const RunContext& context) {
  std::vector<Rival> rivals;
  double n = 0;
  for (Section& entry : section.sections("rival", {0, 16})) {
    rivals.push_back(read_rival(entry, context));
    n += n_runs(rivals.back());
  }
  check_runs(section, "rival", n);
  return rivals;
}

std::vector<Stepping> read_steppings(Section& section, const RunContext& context) {
  std::vector<Stepping> steppings;
  double n = 0;
  for (Section& entry : section.sections("stepping", {0, 16})) {
    steppings.push_back(read_stepping(entry, context));
    n += n_runs(steppings.back(), context.vocabulary);
  }
  check_runs(section, "stepping", n);
  return steppings;
}

}  // namespace mb
