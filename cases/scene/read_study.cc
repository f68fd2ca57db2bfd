#include "cases/scene/read_study.h"

#include <fmt/ranges.h>

#include <algorithm>

#include "cases/scene/number_text.h"
#include "cases/scene/resolution.h"

namespace mb {

namespace {

// The closed form of a body's own matrices needs all their modes: dense ones, n^3 operations and 8 n^2 bytes each.
constexpr double most_dense = 6000;
// Where a dashpot couples them, complex ones of twice as many unknowns (mechanics/system/complex_modes.h).
constexpr int most_coupled = 1000;
constexpr double most_contact_steps = 2e7;  // in a run: modal/contact/impact_motion.cc

void check_dense(const Methods& methods, const std::vector<BodyDraft>& bodies, Findings& findings) {
  for (const auto& method : methods) {
    if (method.value != "full") continue;
    for (const BodyDraft& body : bodies) {
      if (!body.shape || !body.resolution || !body.theory) continue;
      const double n = n_dofs(*body.shape, *body.resolution, *body.theory);
      const bool coupled = !body.dashpots.dashpots.empty();
      if (n <= (coupled ? most_coupled : most_dense)) continue;
      findings.error(method.where,
                     fmt::format("'full' in closed form takes at most {:.0f} degrees of freedom{}: {} of body '{}' has "
                                 "{:.0f}",
                                 coupled ? most_coupled : most_dense, coupled ? ", coupled by a dashpot" : "",
                                 to_string(*body.resolution), body.name.value_or(""), n),
                     "as a method of [[study.stepping]] it takes any mesh");
    }
  }
}

void check_coupled(Section& section, const std::vector<int>& modes, const std::vector<BodyDraft>& bodies) {
  const auto most = std::ranges::max_element(modes);
  if (most == modes.end() || *most <= most_coupled) return;
  for (const BodyDraft& body : bodies)
    if (!body.dashpots.dashpots.empty())
      section.error("modes", fmt::format("the dashpot of body '{}' couples modes: at most {} in closed form, not {}",
                                         body.name.value_or(""), most_coupled, *most));
}

// Ratios of single modes couple polynomial functions, which are not modes of the body: no equation stands alone.
void check_uncoupled(const Methods& methods, const std::vector<BodyDraft>& bodies, const Vocabulary& vocabulary,
                     Findings& findings) {
  for (const auto& method : methods) {
    if (method.value == "full" || takes_modes(method.value, vocabulary)) continue;
    for (const BodyDraft& body : bodies) {
      if (body.damping.ratios.empty()) continue;
      findings.error(
          method.where,
          fmt::format("'{}' has no closed form for body '{}', whose damping ratios of single modes couple it",
                      method.value, body.name.value_or("")),
          "as a method of [[study.stepping]] it takes them");
    }
  }
}

// The mode counts of the study or, in their place, the profile's. Required where a method takes a mode count.
std::vector<int> effective_modes(Section& section, std::optional<Section>& profile, bool required,
                                 const std::vector<BodyDraft>& bodies) {
  const bool stated = section.has("modes");
  auto modes = required || stated ? read_modes(section) : std::nullopt;
  if (profile && profile->has("modes")) modes = read_modes(*profile);
  if (modes) check_mode_counts(*modes, bodies, section.findings());
  return values_of(modes);
}

// A scene may touch all the time, and what has begun is not interrupted.
bool are_few(Section& table, const char* key, const std::vector<double>& steps, double duration) {
  const double least = nine_digits(duration / most_contact_steps);
  for (const double step : steps) {
    if (step >= least) continue;
    table.error(key, fmt::format("steps of {} s could be more than {} within {} s: at least {} s", number_text(step),
                                 number_text(most_contact_steps), number_text(duration), number_text(least)));
    return false;
  }
  return true;
}

// Likewise the steps while bodies touch. contact: whether there is any; nothing: not known.
std::vector<double> effective_contact_steps(Section& section, std::optional<Section>& profile, bool required,
                                            const std::optional<bool>& contact, const std::optional<double>& duration) {
  const char* const key = "contact_steps";
  const auto read = [&](Section& table) -> std::optional<std::vector<double>> {
    if (contact != false) {
      auto steps = table.numbers(key, {0, 1, "s", true}, {1, 64});
      return steps && (!duration || are_few(table, key, *steps, *duration)) ? steps : std::nullopt;
    }
    table.findings().error(table.where_key(key),
                           fmt::format("'{}' in {}: only scenes with contact take it", key, table.title()));
    return std::nullopt;
  };
  const bool stated = section.has(key);
  auto steps = required || stated ? read(section) : std::nullopt;
  if (profile && profile->has(key)) steps = read(*profile);
  return steps.value_or(std::vector<double>{});
}

bool turns_freely(const BodyDraft& body) {
  return body.kinematics != Kinematics::linear && body.supports.supports.empty();
}

std::vector<RotationCoupling> read_rotations(Section& section, const std::vector<BodyDraft>& bodies) {
  const char* const key = "rotation";
  if (!section.has(key)) return Study{}.rotations;
  if (touch(bodies) == false && !std::ranges::all_of(bodies, turns_freely))
    section.findings().error(
        section.where_key(key),
        fmt::format("'{}' in {}: only scenes with contact, or of free bodies of finite kinematics, take it", key,
                    section.title()));
  std::vector<RotationCoupling> all;
  const auto names = read_unlike(section, key, {{"rigid", "coupled", "unstiffened"}, "rotation", "rotations"});
  for (const std::string& name : values_of(names))
    for (const RotationCoupling rotation :
         {RotationCoupling::rigid, RotationCoupling::coupled, RotationCoupling::unstiffened})
      if (name == to_string(rotation)) all.push_back(rotation);
  return all;
}

void check_theories(const std::vector<Located<std::string>>& names, const std::vector<BodyDraft>& bodies,
                    const Vocabulary& vocabulary, Findings& findings) {
  const auto plain = std::ranges::find_if(
      bodies, [](const BodyDraft& body) { return body.theory.value_or(Theory::solid) != Theory::solid; });
  if (plain == bodies.end()) return;
  for (const auto& name : names) {
    if (std::ranges::count(vocabulary.analyses_of_theories, name.value) > 0) continue;
    findings.error(name.where,
                   fmt::format("analysis '{}' is of solids: body '{}' is of theory '{}'", name.value,
                               plain->name.value_or(""), to_string(*plain->theory)),
                   fmt::format("of beams and plates there are: {}", fmt::join(vocabulary.analyses_of_theories, ", ")));
  }
}

// Analyses look at the first body.
void check_single_modes(const std::vector<Located<std::string>>& names, const std::vector<BodyDraft>& bodies,
                        const Vocabulary& vocabulary, Findings& findings) {
  if (bodies.empty() || bodies.front().dashpots.dashpots.empty()) return;
  for (const auto& name : names)
    if (std::ranges::count(vocabulary.analyses_of_single_modes, name.value) > 0)
      findings.error(name.where,
                     fmt::format("analysis '{}' is of modes one by one: the dashpot of body '{}' couples them",
                                 name.value, bodies.front().name.value_or("")),
                     "'stability-map' tells of all of them together");
}

std::vector<std::string> read_analyses(Section& section, const Vocabulary& vocabulary,
                                       const std::vector<BodyDraft>& bodies) {
  if (!section.has("analyses")) return {};
  const auto names = read_unlike(section, "analyses", {vocabulary.analyses, "analysis", "analyses"});
  const std::optional<bool> contact = touch(bodies);
  if (names && contact) {
    const auto& wrong = *contact ? vocabulary.analyses_of_loads : vocabulary.analyses_of_contact;
    for (const auto& name : *names)
      if (std::ranges::count(wrong, name.value) > 0)
        section.findings().error(name.where, fmt::format("analysis '{}' is of scenes {} contact", name.value,
                                                         *contact ? "without" : "with"));
  }
  if (names) check_theories(*names, bodies, vocabulary, section.findings());
  if (names) check_single_modes(*names, bodies, vocabulary, section.findings());
  return values_of(names);
}

// What a profile replaces is read all the same, for its types and ranges, but not against the profile's meshes.
template <class Read>
auto effective(Section& section, std::optional<Section>& profile, const std::string& key, const RunContext& shared,
               const std::optional<double>& duration, Read read) {
  const bool replaced = profile && profile->has(key);
  auto base = read(section, replaced ? RunContext{{}, shared.vocabulary, shared.duration} : shared);
  return replaced ? read(*profile, RunContext{shared.bodies, shared.vocabulary, duration}) : base;
}

}  // namespace

Study read_study(Section section, std::optional<Section>& profile, const std::vector<BodyDraft>& bodies,
                 const Vocabulary& vocabulary, const StudyTimes& times) {
  Study study;
  const auto methods = read_methods(section, vocabulary);
  if (methods) {
    check_dense(*methods, bodies, section.findings());
    check_uncoupled(*methods, bodies, vocabulary, section.findings());
    check_functions(*methods, bodies, vocabulary, section.findings());
  }
  study.methods = values_of(methods);
  study.modes = effective_modes(section, profile, methods && take_modes(*methods, vocabulary), bodies);
  check_coupled(section, study.modes, bodies);
  study.contact_steps =
      effective_contact_steps(section, profile, methods && touch(bodies) == true, touch(bodies), times.own);
  study.rotations = read_rotations(section, bodies);
  study.analyses = read_analyses(section, vocabulary, bodies);
  study.load_tolerance = section.number("load_tolerance", {1e-9, 0.1}, study.load_tolerance);
  const RunContext shared{bodies, vocabulary, times.shortest};
  study.rivals = effective(section, profile, "rival", shared, times.own, read_rivals);
  study.steppings = effective(section, profile, "stepping", shared, times.own, read_steppings);
  section.finish();
  return study;
}

}  // namespace mb
