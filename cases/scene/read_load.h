// [[load]] with its history and tractions, and [[probe]].
#pragma once

#include "cases/scene/names.h"
#include "cases/scene/read_body.h"
#include "cases/scene/read_history.h"

namespace mb {

// References to bodies are resolved among drafts: a body with a problem of its own is still known by its name.
// names: those of the loads, or probes, before it.
std::optional<Load> read_load(Section section, const std::vector<BodyDraft>& bodies, const HistoryContext& context,
                              Names& names);
std::optional<Probe> read_probe(Section section, const std::vector<BodyDraft>& bodies, Names& names);

}  // namespace mb
