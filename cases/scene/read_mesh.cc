#include "cases/scene/read_mesh.h"

#include <fmt/format.h>

#include "cases/scene/resolution.h"

namespace mb {

std::optional<Resolution> read_mesh(Section section, const BodyDraft& body) {
  for (const char* key : {"degree", "cells"}) section.has(key);  // as messages list them
  const int graded = section.integer("graded", graded_range, 0);
  // Of which theory is not known where that is wrong: then nor is what cells stand for.
  const std::optional<Shape> shape = body.theory ? body.shape : std::nullopt;
  const Theory theory = body.theory.value_or(Theory::solid);
  auto resolution = read_resolution(section, shape, theory);
  if (graded > 0 && body.touches == false) {
    section.error("graded",
                  fmt::format("'graded' is of no use: no [[contact]] names body '{}'", body.name.value_or("")));
  }
  if (!resolution || graded == 0) return resolution;
  resolution->graded = graded;
  if (shape && !check_mesh(*shape, *resolution, section.where("graded"), section.findings(), theory)) return {};
  return resolution;
}

}  // namespace mb
