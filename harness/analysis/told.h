// What an analysis finds, with what it is held to and an error bar beside every number that follows from the truth of
// the case or from the body's mesh: 5/4 of the distance of the same tables told of the truth's neighbour, `coarser` in
// the place of `finer` and rtol in that of rtol/100 (harness/study/truth.h), or twice that to `finer` in the place of
// the body's mesh (another_mesh), the larger of both; more where errors need not fall as far
// (harness/study/mesh_bar.h).
#pragma once

#include "harness/analysis/analysis.h"
#include "harness/study/mesh_bar.h"
#include "modal/bases/mode_pairs.h"

namespace mb {

// Elastic modes of a body on its mesh that move alike on the other.
struct ElasticPairs {
  Index n_rigid;
  ModePairs pairs;
};

// Throws as the analysis does. Scenes with contact are not told twice: their budget has its own neighbours.
std::vector<Finding> told(const Analysis& analysis, const AnalysisContext& context);

// bars = per_distance |cell - cell of the other|, in columns of strain the local one, where tables and the texts that
// a row begins with are the same, and, where one has more rows, the counts with them; else NaN. Bars that a table has
// of its own stay where they are larger. Of a table with a column "mode", counted from the first elastic one, or
// "undamped mode", from the first, rows are those of modes that move alike, where `elastic` says which: the largest bar
// of several, and of several rows of a mode the one in the same place; rows in the same place where the other table has
// none of these modes. A bar of 0 from before, in a column whose other rows have one, is infinite where no row is
// beside.
void add_bars(std::vector<Finding>& findings, const std::vector<Finding>& neighbours, PerDistance per_distance,
              const ElasticPairs* elastic = nullptr);

// A column "standard error" or "standard error of ..." becomes the bar of the fit in the column before it, unless that
// has a larger one.
void bar_fits(Finding& finding);

}  // namespace mb
