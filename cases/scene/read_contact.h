// [[obstacle]] and [[contact]]: what bodies may meet, and what they feel there.
#pragma once

#include <set>
#include <string>

#include "cases/scene/read_body.h"

namespace mb {

// Of one contact, what it brings together: names, where they name something.
struct MeetingDraft {
  std::optional<std::string> body, obstacle;
  std::optional<ContactLaw> law;
  bool strikes;               // whether the obstacle states what moves it, right or wrong
  Position where, law_where;  // of the table; of its law, or of the table where it states none
};

// As far as they could be read.
struct ContactDrafts {
  std::vector<Obstacle> obstacles;
  std::vector<ContactPair> pairs;
  std::set<std::string> bodies;  // that a contact names, right or wrong in the rest
  std::vector<MeetingDraft> meetings;
  bool strikes = false;          // whether an obstacle states what moves it, right or wrong
  bool any = false;              // whether the case states a contact, right or wrong
  bool all_bodies_known = true;  // whether each names a body
};
ContactDrafts read_contacts(Section& root, const std::vector<BodyDraft>& bodies);

// The bodies, of which it is known from now on whether they touch (BodyDraft::touches).
std::vector<BodyDraft> with_touches(std::vector<BodyDraft> bodies, const ContactDrafts& contacts);

}  // namespace mb
