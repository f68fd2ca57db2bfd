#include "cases/scene/read_mesh.h"

#include <fmt/format.h>

#include "cases/scene/resolution.h"

namespace mb {

namespace {

struct Uneven {
  std::vector<double> bias;
  double distorted;
};

Uneven read_uneven(Section& section, const std::optional<Shape>& shape, Theory theory) {
  Uneven uneven{{}, section.number("distorted", {0, 0.4}, 0)};
  if (section.has("bias"))
    if (const auto bias = section.numbers("bias", {1e-3, 1e3}, {3, 3})) uneven.bias = *bias;
  const bool is_box = theory == Theory::solid && (!shape || std::holds_alternative<Box>(*shape));
  for (const char* key : {"bias", "distorted"})
    if (!is_box && section.has(key)) section.error(key, fmt::format("'{}' is of boxes that are solids", key));
  return uneven;
}

}  // namespace

std::optional<Resolution> read_mesh(Section section, const BodyDraft& body) {
  for (const char* key : {"degree", "cells"}) section.has(key);  // as messages list them
  const int graded = section.integer("graded", graded_range, 0);
  // Of which theory is not known where that is wrong: then nor is what cells stand for.
  const std::optional<Shape> shape = body.theory ? body.of_kind : std::nullopt;
  const Theory theory = body.theory.value_or(Theory::solid);
  const Uneven uneven = read_uneven(section, shape, theory);
  auto resolution = read_resolution(section, shape, theory);
  if (resolution) {
    resolution->bias = uneven.bias;
    resolution->distorted = uneven.distorted;
  }
  if (graded > 0 && body.touches == false) {
    section.error("graded",
                  fmt::format("'graded' is of no use: no [[contact]] names body '{}'", body.name.value_or("")));
  }
  if (!resolution || graded == 0) return resolution;
  resolution->graded = graded;
  const bool sized = body.theory && body.shape;
  if (sized && !check_mesh(*body.shape, *resolution, section.where("graded"), section.findings(), theory)) return {};
  return resolution;
}

void check_ratios(const BodyDraft& body, const Resolution& mesh, const Position& where, Findings& findings) {
  if (!body.shape || !body.theory) return;
  const double most = n_elastic(*body.shape, mesh, *body.theory);
  const std::size_t n = body.damping.ratios.size();
  if (static_cast<double>(n) <= most) return;
  findings.error(where, fmt::format("{} damping ratios: {} of body '{}' has at most {:.0f} elastic modes", n,
                                    to_string(mesh), body.name.value_or(""), most));
}

}  // namespace mb
