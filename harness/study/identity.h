// Names of results: the content hash of all that determines them (scene, contender, sources, library versions).
#pragma once

#include <set>
#include <string>

#include "cases/contract/record.h"

namespace mb {

// The truth on one mesh at one tolerance; sources of mechanics, cases and reference count.
std::string truth_hash(const Scene& scene, const Resolution& resolution, double relative_tolerance);

// Of all truths of a scene (truth.h).
std::set<std::string> truth_hashes(const Scene& scene);

// A contender's run and its marks, under the case's name and profile; all sources but those of reports count.
std::string run_hash(const Scene& scene, const Contender& contender);

// The tables of one analysis; all sources but those of reports count.
std::string analysis_hash(const Scene& scene, const std::string& analysis);

}  // namespace mb
