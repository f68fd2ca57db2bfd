// One graded number, the unit of the result store (one JSON object a line in results.jsonl).
#pragma once

#include <map>
#include <optional>
#include <string>

#include "cases/contract/method.h"

namespace mb {

// Truth kinds: same_mesh shares M and K with the contender (truncation, stepping); finer adds discretisation; exact is
// a closed form of the continuum (cases/exact/); same_modes is the closed form of the same modes, of those that are
// stepped otherwise: what is left is their steps alone.
enum class TruthKind { same_mesh, finer, exact, same_modes };
const char* to_string(TruthKind kind);

struct Contender {
  std::string method;      // "eigenmodes", "static-correction", "full-order"
  std::string integrator;  // "exact", "newmark", "sundials"
  Resolution resolution;
  Settings settings;
};

struct Record {
  std::string run;  // content hash of scene and contender: names the trajectory file, if there is one
  std::string case_name, profile;
  Contender contender;
  int modes_used = -1;  // elastic modes kept, after rounding up; -1: not modal
  long n_unknowns = 0;  // degrees of freedom stepped in time
  std::string metric;   // a name of the metric catalogue
  std::string subject;  // body or probe that was measured, or ""
  std::string truth;    // "finer", "same_mesh", "exact", "same_modes", or "" where the metric needs none (times)
  double value = 0;     // stored as null where it is not finite, and then with a status other than "ok", or undefined
  std::string unit;
  std::optional<double> error_bar;  // same unit; a smaller value prints as "<= value + bar"
  std::string status;               // "ok", "unstable", "unstable: ..." (steps beyond the integrator's limit:
                                    // status.h), "not_finite", "no_convergence", "too_many_steps", "undefined: ...",
                                    // "failed: ..."
  Work work;
  std::map<std::string, std::string> provenance;  // commit, date, profile, processor, threads, blas, compiler; of some
                                                  // repeats, busy, growth
};

// Whether the steps of its run may be past their limit, which was looked for in vain: provenance "growth".
inline bool is_growth_unknown(const Record& record) { return record.provenance.contains("growth"); }

}  // namespace mb
