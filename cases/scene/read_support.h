// [[body.support]]: which faces are held, guided or driven.
#pragma once

#include "cases/scene/read_history.h"
#include "cases/scene/read_shape.h"
#include "cases/scene/scene.h"

namespace mb {

struct SupportDrafts {
  std::vector<Support> supports;   // those without a problem
  bool driven = false;             // whether one of any kind may be driven, right or wrong
  std::vector<Position> driven_at; /* of those that are driven, right or wrong: where they say so */
};

// context: of a load's history; the histories of driven supports are accelerations.
SupportDrafts read_supports(Section& body, const ShapeDraft& shape, const HistoryContext& context);

const char* to_string(Support::Kind kind);  // "fixed", "sliding", "mean", "diaphragm", "driven"

}  // namespace mb
