// [truth]: how precise the truth is, on which meshes, and the closed form that there may be. [reference_frequencies]:
// what others found.
#pragma once

#include "cases/scene/read_body.h"
#include "cases/scene/section.h"

namespace mb {

struct TruthDraft {
  std::optional<TruthSettings> settings;
  bool has_exact = false;  // whether a closed form is named, right or wrong
  Position exact_at;       // where
};

// The profile may give other meshes. bodies: with the meshes that they have in the profile.
TruthDraft read_truth(Section section, std::optional<Section>& profile, const std::vector<BodyDraft>& bodies);

// [reference_frequencies]
ReferenceFrequencies read_reference_frequencies(Section section);

}  // namespace mb
