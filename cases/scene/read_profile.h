// [profile.quick], [profile.standard], [profile.full]: what a profile changes of the case. A case is read once for
// every profile, so that each is checked whichever is asked for; what the profiles share is reported once.
#pragma once

#include "cases/scene/read_body.h"
#include "cases/scene/section.h"

namespace mb {

const std::vector<std::string>& profile_names();  // quick, standard, full

// The table of one profile, or nothing where the case does not state it. Its keys are read where what they replace is
// read; the caller finishes it.
std::optional<Section> read_profile(Section& root, const std::string& name);

// The bodies with the meshes that the profile gives them.
std::vector<BodyDraft> bodies_in(std::optional<Section>& profile, std::vector<BodyDraft> bodies);

}  // namespace mb
