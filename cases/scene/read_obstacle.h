// [[obstacle]]: a rigid thing that stands still, or a ball that strikes.
#pragma once

#include "cases/scene/scene.h"
#include "cases/scene/section.h"

namespace mb {

// As far as it could be read: contacts that refer to it are still checked where something else in it is wrong.
struct ObstacleDraft {
  std::optional<std::string> name;
  std::optional<RigidSurface> surface;
  Position where;        // of its name
  bool strikes = false;  // whether it states what moves it, right or wrong
  std::optional<Striker> striker = std::nullopt;
};

ObstacleDraft read_obstacle(Section section);

}  // namespace mb
