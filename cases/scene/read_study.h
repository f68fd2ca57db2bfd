// [study] and [[check]]: who answers the case, and what must hold.
#pragma once

#include "cases/scene/read_body.h"
#include "cases/scene/read_runs.h"
#include "cases/scene/section.h"

namespace mb {

// The profile may give other mode counts, contact steps, rivals and steppings. shortest [s]: of all profiles, duration
// [s]: of this.
Study read_study(Section section, std::optional<Section>& profile, const std::vector<BodyDraft>& bodies,
                 const Vocabulary& vocabulary, const StudyTimes& times);

// What a check may refer to, as far as it could be read.
struct CheckContext {
  std::optional<Study> study;  // nothing: it was wrong, any method and mode count will do
  std::string profile;         // that is asked for
  std::string runs;            // who does not run what a check asks for: "the study", "profile quick"
  bool has_exact;              // whether a closed form is named
};
// Of another profile than the one asked for it is read, but not against the study.
std::optional<Check> read_check(Section section, const CheckContext& context, const Vocabulary& vocabulary);

}  // namespace mb
