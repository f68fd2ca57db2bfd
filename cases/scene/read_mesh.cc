#include "cases/scene/read_mesh.h"

#include <fmt/format.h>

#include "cases/scene/resolution.h"

namespace mb {

std::optional<Resolution> read_mesh(Section section, const BodyDraft& body) {
  for (const char* key : {"degree", "cells"}) section.has(key);  // as messages list them
  const int graded = section.integer("graded", graded_range, 0);
  auto resolution = read_resolution(section, body.shape);
  if (graded > 0 && body.touches == false) {
    section.error("graded",
                  fmt::format("'graded' is of no use: no [[contact]] names body '{}'", body.name.value_or("")));
  }
  if (!resolution || graded == 0) return resolution;
  resolution->graded = graded;
  if (body.shape && !check_mesh(*body.shape, *resolution, section.where("graded"), section.findings())) return {};
  return resolution;
}

}  // namespace mb
