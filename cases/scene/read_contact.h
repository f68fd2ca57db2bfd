// [[obstacle]] and [[contact]]: what bodies may meet, and what they feel there.
#pragma once

#include <set>
#include <string>

#include "cases/scene/read_body.h"

namespace mb {

// As far as they could be read.
struct ContactDrafts {
  std::vector<Obstacle> obstacles;
  std::vector<ContactPair> pairs;
  std::set<std::string> bodies;  // that a contact names, right or wrong in the rest
  bool any = false;              // whether the case states a contact, right or wrong
  bool all_bodies_known = true;  // whether each names a body
};
ContactDrafts read_contacts(Section& root, const std::vector<BodyDraft>& bodies);

// The bodies, of which it is known from now on whether they touch (BodyDraft::touches).
std::vector<BodyDraft> with_touches(std::vector<BodyDraft> bodies, const ContactDrafts& contacts);

}  // namespace mb
