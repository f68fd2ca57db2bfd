// What goes together with contact, and what without.
#pragma once

#include "cases/scene/read_contact.h"

namespace mb {

// Records what a scene without contact states in vain, what cannot be simulated together with contact yet, and where
// nothing would move. gravity: nothing where it was wrong.
void check_contact_rules(Section& root, const std::vector<BodyDraft>& bodies, const ContactDrafts& contacts,
                         const std::optional<Vector3d>& gravity);

}  // namespace mb
