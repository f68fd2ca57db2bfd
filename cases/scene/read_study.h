// [truth], [study] and [[check]]: how precise the truth is, who answers the case, and what must hold.
#pragma once

#include "cases/scene/read_body.h"
#include "cases/scene/section.h"

namespace mb {

std::optional<TruthSettings> read_truth(Section section, const std::vector<BodyDraft>& bodies);

// shortest_duration [s] of all profiles: no time step may exceed it.
Study read_study(Section section, const std::vector<BodyDraft>& bodies, const Vocabulary& vocabulary,
                 double shortest_duration);

// The study's methods and modes are those that a check may name. Nothing in the study: it was wrong, any will do.
std::optional<Check> read_check(Section section, const std::optional<Study>& study, const Vocabulary& vocabulary);

}  // namespace mb
