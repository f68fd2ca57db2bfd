#include "cases/scene/read_study.h"

#include <fmt/format.h>

#include <algorithm>

#include "cases/scene/resolution.h"

namespace mb {

namespace {

constexpr double most_steps = 1e6;  // of one run: a day of stepping even for a small model
constexpr double most_rivals = 1000;

template <class T>
std::vector<T> values_of(const std::optional<std::vector<Located<T>>>& found) {
  std::vector<T> out;
  if (found) {
    for (const auto& entry : *found) out.push_back(entry.value);
  }
  return out;
}

void check_unlike(const std::vector<Located<std::string>>& words, Findings& findings) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto twin = [&](const auto& other) { return other.value == words[i].value; };
    if (std::find_if(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(i), twin) !=
        words.begin() + static_cast<std::ptrdiff_t>(i)) {
      findings.error(words[i].where, fmt::format("'{}' is listed twice", words[i].value));
    }
  }
}

void check_ascending(const std::vector<Located<int>>& numbers, const std::string& key, Findings& findings) {
  for (std::size_t i = 1; i < numbers.size(); ++i) {
    if (numbers[i].value > numbers[i - 1].value) continue;
    findings.error(numbers[i].where,
                   fmt::format("'{}' must ascend: {} follows {}", key, numbers[i].value, numbers[i - 1].value));
  }
}

// No mode count may exceed the number of unknowns of the mesh whose modes they are.
void check_mode_counts(const std::vector<Located<int>>& modes, const std::vector<BodyDraft>& bodies,
                       Findings& findings) {
  for (const BodyDraft& body : bodies) {
    if (!body.shape || !body.resolution) continue;
    const double most = n_dofs(*body.shape, *body.resolution) - 6;
    for (const auto& entry : modes) {
      if (entry.value <= most) continue;
      findings.error(entry.where, fmt::format("{} elastic modes: {} of body '{}' has at most {:.0f}", entry.value,
                                              to_string(*body.resolution), body.name.value_or(""), most));
    }
  }
}

void check_meshes(const Rival& rival, const std::vector<Located<std::vector<int>>>& cells,
                  const std::vector<BodyDraft>& bodies, Findings& findings) {
  const int degree = rival.degrees.empty() ? 1 : rival.degrees.back();
  for (const BodyDraft& body : bodies) {
    if (!body.shape) continue;
    for (const auto& entry : cells) check_mesh(*body.shape, {degree, entry.value}, entry.where, findings);
  }
}

Rival read_rival(Section section, const std::vector<BodyDraft>& bodies, const Vocabulary& vocabulary,
                 double shortest_duration) {
  Rival rival;
  const Words integrators{vocabulary.integrators, "integrator", "integrators"};
  rival.integrator = section.choice("integrator", integrators).value_or("");
  const auto degrees = section.integers("degrees", degree_range, {1, 4});
  if (degrees) check_ascending(*degrees, "degrees", section.findings());
  rival.degrees = values_of(degrees);
  const auto cells = section.integer_lists("cells", cells_range, {1, 64}, {1, 3});
  rival.cells = values_of(cells);
  if (cells) check_meshes(rival, *cells, bodies, section.findings());
  const Range step_range{shortest_duration / most_steps, shortest_duration, "s"};
  rival.time_steps = section.numbers("time_steps", step_range, {1, 64}).value_or(std::vector<double>{});
  section.finish();
  return rival;
}

}  // namespace

std::optional<TruthSettings> read_truth(Section section, const std::vector<BodyDraft>& bodies) {
  const std::optional<Shape> shape = bodies.empty() ? std::nullopt : bodies.front().shape;
  const auto tolerance = section.number("relative_tolerance", {1e-12, 1e-2});
  const auto finer_section = section.section("finer");
  const auto coarser_section = section.section("coarser");
  const auto finer = finer_section ? read_resolution(*finer_section, shape) : std::nullopt;
  const auto coarser = coarser_section ? read_resolution(*coarser_section, shape) : std::nullopt;
  section.finish();
  if (finer && coarser && *finer == *coarser) {
    section.error("coarser", "'coarser' equals 'finer': their distance is the error bar, and would be 0");
  }
  if (finer && !bodies.empty() && bodies.front().resolution && *finer == *bodies.front().resolution) {
    section.error("finer", fmt::format("'finer' is the mesh of body '{}' itself: truth same_mesh has that one",
                                       bodies.front().name.value_or("")));
  }
  if (!tolerance || !finer || !coarser) return std::nullopt;
  return TruthSettings{*tolerance, *finer, *coarser};
}

Study read_study(Section section, const std::vector<BodyDraft>& bodies, const Vocabulary& vocabulary,
                 double shortest_duration) {
  Study study;
  Words reduced{vocabulary.methods, "reduced method", "reduced methods"};
  std::erase(reduced.known, "full-order");  // a rival, not a method that is swept over mode counts
  const auto methods = section.choices("methods", reduced, {1, 64});
  if (methods) check_unlike(*methods, section.findings());
  study.methods = values_of(methods);
  const auto modes = section.integers("modes", {0, 4096}, {1, 64});
  if (modes) {
    check_ascending(*modes, "modes", section.findings());
    check_mode_counts(*modes, bodies, section.findings());
  }
  study.modes = values_of(modes);
  study.load_tolerance = section.number("load_tolerance", {1e-9, 0.1}, study.load_tolerance);
  double n_rivals = 0;
  for (Section& entry : section.sections("rival", {0, 16})) {
    study.rivals.push_back(read_rival(entry, bodies, vocabulary, shortest_duration));
    const Rival& rival = study.rivals.back();
    n_rivals += static_cast<double>(rival.degrees.size() * rival.cells.size() * rival.time_steps.size());
  }
  if (n_rivals > most_rivals) {
    section.error("rival", fmt::format("{} rival runs: at most {}", n_rivals, most_rivals));
  }
  section.finish();
  return study;
}

}  // namespace mb
