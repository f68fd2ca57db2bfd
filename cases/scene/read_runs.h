// [[study.rival]] and [[study.stepping]]: contenders that step in time, full order and reduced, and the lists that both
// share with [study].
#pragma once

#include "cases/scene/read_body.h"
#include "cases/scene/read_toml.h"
#include "cases/scene/section.h"

namespace mb {

// Nothing: not known, since it is wrong.
struct StudyTimes {
  std::optional<double> shortest, own;  // [s] shortest duration of all profiles; duration of the profile that is read
};

struct RunContext {
  // Those whose meshes the runs must suit; none where a profile replaces the runs.
  std::vector<BodyDraft> bodies;
  const Vocabulary& vocabulary;
  // [s] shortest of the profiles that share the runs: no time step may exceed it. Nothing: not known.
  std::optional<double> duration;
};

std::vector<Rival> read_rivals(Section& section, const RunContext& context);
std::vector<Stepping> read_steppings(Section& section, const RunContext& context);

using Methods = std::vector<Located<std::string>>;
using ModeCounts = std::vector<Located<int>>;

// Words of a closed list, none twice.
std::optional<std::vector<Located<std::string>>> read_unlike(Section& section, const std::string& key,
                                                             const Words& words);
// `methods`: reduced ones, none twice.
std::optional<Methods> read_methods(Section& section, const Vocabulary& vocabulary);
bool take_modes(const Methods& methods, const Vocabulary& vocabulary);  // whether any of them does
bool takes_modes(const std::string& method, const Vocabulary& vocabulary);

// Records methods whose functions are polynomials, which bodies of beam and plate theory do not have.
void check_functions(const Methods& methods, const std::vector<BodyDraft>& bodies, const Vocabulary& vocabulary,
                     Findings& findings);

// `modes`: ascending, required.
std::optional<ModeCounts> read_modes(Section& section);
// No mode count may exceed the number of unknowns of the meshes whose modes they are.
void check_mode_counts(const ModeCounts& modes, const std::vector<BodyDraft>& bodies, Findings& findings);

template <class T>
std::vector<T> values_of(const std::optional<std::vector<Located<T>>>& found) {
  std::vector<T> out;
  if (found) {
    for (const auto& entry : *found) out.push_back(entry.value);
  }
  return out;
}

}  // namespace mb
