#include "cases/scene/read_patch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cases/scene/number_text.h"
#include "cases/scene/resolution.h"

namespace mb {

namespace {

std::optional<Disc> read_disc(Section section, const Shape& shape, const std::optional<std::string>& face) {
  const double size = extent(shape);
  const auto centre = section.vector("centre", {-nine_digits(size), nine_digits(size), "m"});
  // Below a hundredth of the body the weight falls between the quadrature points of any mesh that may be asked for.
  // On a cylinder's side chords end at its diameter.
  const auto* const cylinder = face == "side" ? std::get_if<Cylinder>(&shape) : nullptr;
  const double most = cylinder ? std::min(size, 2 * cylinder->radius) : size;
  const auto radius = section.number("radius", {nine_digits(0.01 * size), nine_digits(most), "m"});
  section.finish();
  if (!centre || !radius) return std::nullopt;
  const double tolerance = placement_tolerance(shape);
  if (face && !(std::abs(face_distance(shape, *face, *centre)) <= tolerance && contains(shape, *centre, tolerance))) {
    section.error("centre", fmt::format("the disc's centre does not lie on face '{}'", *face));
    return std::nullopt;
  }
  return Disc{*centre, *radius};
}

}  // namespace

double placement_tolerance(const Shape& shape) { return 1e-9 * extent(shape); }

Words face_words(const Shape& shape) {
  return {face_names(shape), fmt::format("face of a {}", kind_name(shape)),
          fmt::format("faces of a {}", kind_name(shape))};
}

std::optional<Patch> read_patch(Section& section, const ShapeDraft& draft) {
  if (!draft.of_kind) {  // its faces are not known
    section.has("face");
    section.has("disc");
    return std::nullopt;
  }
  const auto face = section.choice("face", face_words(*draft.of_kind));
  const bool has_disc = section.has("disc");
  const auto table = section.section("disc", true);
  const auto disc = table && draft.shape ? read_disc(*table, *draft.shape, face) : std::nullopt;
  if (!face || (has_disc && !disc)) return std::nullopt;
  return Patch{*face, disc};
}

}  // namespace mb
