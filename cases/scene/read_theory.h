// Bodies of beam and plate theory, and what strikes them: what goes together with them, and what does not.
#pragma once

#include "cases/scene/read_contact.h"

namespace mb {

std::optional<Theory> read_theory(Section& body);  // solid where absent; nothing where it is no theory

// Records what a body of a theory states that the theory does not know, or states itself. All keys but `theory` were
// read.
void check_theory(Section& section, const BodyDraft& body);

// Whether bodies, obstacles and laws of contact fit each other, once all of them were read.
void check_strikes(Section& root, const std::vector<BodyDraft>& bodies, const ContactDrafts& contacts);

// The obstacles, each one that strikes placed on the middle of its body's top face.
std::vector<Obstacle> placed(std::vector<Obstacle> obstacles, const std::vector<ContactPair>& pairs,
                             const std::vector<BodyDraft>& bodies);

}  // namespace mb
