// [[body]]: shape, material, damping, resolution and supports.
#pragma once

#include "cases/scene/scene.h"
#include "cases/scene/section.h"

namespace mb {

// A body as far as it could be read: what refers to it is still checked where something else in it is wrong.
struct BodyDraft {
  std::optional<std::string> name;
  std::optional<Shape> shape;
  std::optional<Material> material;
  std::optional<Resolution> resolution;
  Rayleigh damping;
  std::vector<Support> supports;
};

BodyDraft read_body(Section section);

}  // namespace mb
