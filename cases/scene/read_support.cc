#include "cases/scene/read_support.h"

#include <fmt/format.h>

#include <algorithm>

#include "cases/scene/read_direction.h"
#include "cases/scene/read_patch.h"

namespace mb {

namespace {

using Kind = Support::Kind;
constexpr Kind kinds[] = {Kind::fixed, Kind::sliding, Kind::mean, Kind::diaphragm, Kind::driven};

std::optional<Kind> read_kind(Section& section) {
  Words words{{}, "support kind", "support kinds"};
  for (const Kind kind : kinds) words.known.push_back(to_string(kind));
  const auto word = section.choice("kind", words);
  if (!word) return std::nullopt;
  return *std::find_if(std::begin(kinds), std::end(kinds), [&](Kind kind) { return *word == to_string(kind); });
}

// Whether such a patch can be held in such a way.
bool simulated(Section& section, Kind kind, const Patch& patch, const Shape& shape) {
  if (kind == Kind::mean) return true;
  if (patch.disc) {
    section.error("disc",
                  fmt::format("a {} support on a disc is understood, but cannot be simulated yet", to_string(kind)));
    return false;
  }
  if ((kind == Kind::sliding || kind == Kind::diaphragm) && !is_plane(shape, patch.face)) {
    section.error("face", fmt::format("a {} support on a curved face is understood, but cannot be simulated yet",
                                      to_string(kind)));
    return false;
  }
  return true;
}

std::optional<Drive> read_drive(Section& section, const HistoryContext& context) {
  const auto direction = read_direction(section, "direction");
  const auto table = section.section("acceleration");
  const auto acceleration =
      table ? read_history(*table, {context.folder, context.longest_duration, context.looked_at, "m/s^2"})
            : std::nullopt;
  if (!direction || !acceleration) return std::nullopt;
  return Drive{*direction, *acceleration};
}

std::optional<Support> read_support(Section& section, const std::optional<Kind>& kind, const ShapeDraft& shape,
                                    const HistoryContext& context) {
  const auto patch = read_patch(section, shape);
  const auto drive = kind == Kind::driven ? read_drive(section, context) : std::nullopt;
  if (!kind) {  // it may be driven
    section.has("direction");
    section.has("acceleration");
  }
  section.finish();
  if (!kind || !patch || !simulated(section, *kind, *patch, *shape.of_kind)) return std::nullopt;
  if (kind == Kind::driven && !drive) return std::nullopt;
  return Support{*kind, *patch, drive};
}

// A base moves as a whole: what it drives, it drives alike, and no other face of the body stands still.
void check_base(Section& section, const Support& support, const Support& other) {
  const auto is_pair = [&](Kind a, Kind b) { return support.kind == a && other.kind == b; };
  if (is_pair(Kind::fixed, Kind::driven) || is_pair(Kind::driven, Kind::fixed)) {
    section.error("kind", "a body has fixed or driven supports, not both: the base moves as a whole",
                  "'driven' holds the face as 'fixed' does, relative to the moving base");
  }
  if (!support.drive || !other.drive) return;
  // 1e-12: the same direction, normalised from other digits
  if ((support.drive->direction - other.drive->direction).norm() > 1e-12) {
    section.error("direction", "all driven supports of a body state the same direction: the base moves as a whole");
  }
  if (!(support.drive->acceleration == other.drive->acceleration)) {
    section.error("acceleration",
                  "all driven supports of a body state the same acceleration: the base moves as a whole");
  }
}

// A diaphragm leaves the normal free, of which a mean may take the rigid part; any other two of a face clash.
bool is_twice(const Support& support, const Support& other) {
  const auto is = [&](Kind a, Kind b) { return support.kind == a && other.kind == b; };
  if (is(Kind::diaphragm, Kind::mean) || is(Kind::mean, Kind::diaphragm)) return false;
  return !support.patch.disc && !other.patch.disc && support.patch.face == other.patch.face;
}

}  // namespace

const char* to_string(Kind kind) {
  static constexpr const char* names[] = {"fixed", "sliding", "mean", "diaphragm", "driven"};
  return names[static_cast<int>(kind)];
}

SupportDrafts read_supports(Section& body, const ShapeDraft& shape, const HistoryContext& context) {
  SupportDrafts drafts;
  auto& supports = drafts.supports;
  for (Section& section : body.sections("support", {0, 64})) {
    const auto kind = read_kind(section);
    drafts.driven = drafts.driven || !kind || kind == Kind::driven;
    if (kind == Kind::driven) drafts.driven_at.push_back(section.where("kind"));
    auto support = read_support(section, kind, shape, context);
    if (!support) continue;
    if (std::any_of(supports.begin(), supports.end(),
                    [&](const Support& other) { return is_twice(*support, other); })) {
      section.error("face",
                    fmt::format("face '{}' is supported twice: one constraint would repeat or contradict the other",
                                support->patch.face));
    }
    for (const Support& other : supports) check_base(section, *support, other);
    supports.push_back(std::move(*support));
  }
  return drafts;
}

}  // namespace mb
