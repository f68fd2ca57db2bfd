// Who competes in a case, and the jobs that come of it. Jobs are independent of each other: any process may run any of
// them, in any order, once the truths are there.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cases/contract/record.h"
#include "harness/catalogue.h"

namespace mb {

// Every reduced method at every mode count in closed form, every stepping, every full-order rival on every mesh.
// Grouped by resolution, so that each mesh is made once.
std::vector<Contender> contenders(const Scene& scene, const Catalogue& catalogue);

// The truths `finer` and, on the body's mesh, the one at the scene's tolerance, under whose names their own marks
// stand.
std::vector<Contender> truth_contenders(const Scene& scene);

// One unit of work with one result file, named by its hash: the marks of one contender, or the tables of one analysis.
struct Job {
  enum class Kind { marks, analysis } kind;
  std::string hash;
  std::string label;    // "static-correction r=32 exact Q4 1x4", "step-limits"
  Contender contender;  // of marks
  std::string analysis; /* of an analysis: its name */
};
// Each once, however often the study lists it.
std::vector<Job> jobs(const Scene& scene, const Catalogue& catalogue);

// A part of all jobs: every n-th, from the i-th on. Parts are disjoint and together whole.
struct Shard {
  long i = 1, n = 1;  // 1 <= i <= n
  bool whole() const { return n == 1; }
  Shard part(int k, int m) const { return {i + n * (k - 1), n * m}; }  // its k-th of m parts, k from 1
};
inline constexpr long most_shards = 1'000'000;
std::optional<Shard> parse_shard(const std::string& text);  // "2/8"; nothing where it is no such part
std::vector<Job> part(const std::vector<Job>& jobs, const Shard& shard);

bool takes_times(const Job& job);               // an analysis that measures
std::string label(const Contender& contender);  // "static-correction r=32 exact Q4 1x4"
bool is_full_order(const Contender& contender);
// Whether it takes modes, or functions in their place, by steps where it could in closed form: not `full`.
bool steps_modes(const Contender& contender);

}  // namespace mb
