// A run is one contender on one case: the records that grade it, brought together.
//
//   records (one number each)  ->  runs (one contender each: what it answered, what it cost)
#pragma once

#include <compare>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cases/contract/record.h"
#include "cases/scene/scene.h"

namespace mb {

struct Measure {
  std::string metric, subject, truth;
  auto operator<=>(const Measure&) const = default;
};

struct Run {
  std::string case_name, profile;
  Contender contender;
  int modes_used = -1;                       // elastic modes; -1: full order
  long n_unknowns = 0;                       // degrees of freedom stepped in time
  std::map<Measure, Record> measures;        // all but the times
  std::optional<Record> online, offline;     // [s]; these four on the machine whose times are compared (times.h)
  std::optional<Record> stepping, assembly;  // [s] parts of online and offline
};

// One entry a contender, a case and a profile; a later record of the same measure replaces an earlier one. Records of a
// truth alone make no run: a truth is no contender. Sorted by case, profile, reduced before full order, method,
// integrator, modes, mesh and time step (largest first).
std::vector<Run> group_runs(const std::vector<Record>& records);

const Run* find_run(const std::vector<Run>& grouped, const Record& record);  // of group_runs; nullptr where none

bool same_contender(const Contender& a, const Contender& b);
bool precedes(const Contender& a, const Contender& b);  // the order of group_runs within a case
bool is_reduced(const Contender& contender);       // not of full order; the identity basis "full" is of full order too
bool takes_modes(const Contender& contender);      // whether its settings.modes means anything
bool takes_tolerance(const Contender& contender);  // neither closed form nor fixed steps
// "exact" of a scene with contact (Study::contact_steps): flight in closed form, but steps while bodies touch.
bool steps_in_contact(const Contender& contender);
double accuracy(const Contender& contender);  // time step [s] or tolerance [-], smaller is finer; 0 where neither
bool is_of_truth(const Record& record);       // says something of a truth alone: its metric is named truth-...
bool is_mark(const Record& record);           // a contender against a truth, unlike times, load errors, truth-...
bool is_usable(const Record& record);         // status ok and a finite value
bool is_unstable(const Record& record);       // steps beyond the limit of its integrator: a result
bool is_undefined(const Record& record);      // the metric has no meaning here: no fault of the contender
// The truth that a run is held to by that metric: `exact` where a closed form graded it, `finer` otherwise.
std::string best_truth(const Run& run, const std::string& metric);
bool is_against_best(const Run& run, const Measure& measure);

double counted_error(const Record& record);  // |value|, or the error bar where that is larger: to compare runs

// What the error is at most and at least, as far as its bar can tell: to compare it with a bound.
double largest_error(const Record& record);   // |value| + bar
double smallest_error(const Record& record);  // |value| - bar, or 0

// "too_many_steps"; of "failed: no such cell" what follows the colon; "not_finite" where an ok record has no value.
std::string reason(const Record& record);

// The theory is that of the contender's body (views.h): the "mesh" of a beam or plate by theory is half waves.
std::string describe_mesh(const Resolution& mesh, Theory theory);  // "Q2 1x4", "5 half waves", "7x7 half waves"

// Family and setting: "Q2 1x4, newmark, step 0.00125 s".
std::string describe(const Contender& contender, Theory theory = Theory::solid);
// "eigenmodes", "linear, newmark", "Q2 1x4, newmark"
std::string describe_family(const Contender& contender, Theory theory = Theory::solid);
// "r = 8", "Q2 1x4"; "" where the method has no choice
std::string describe_size(const Contender& contender, Theory theory = Theory::solid);
// As drawn: "eigenmodes", "full order Q2, newmark", "full order in half waves, newmark".
std::string describe_series(const Contender& contender, Theory theory = Theory::solid);
// Of its steps: "step 0.00125 s", "step 0.0001 s in contact", "rtol 1e-06"; "" of a closed form.
std::string describe_accuracy(const Contender& contender);
std::string describe_setting(const Contender& contender);  // "r = 8, step 0.00125 s", "rtol 1e-06", ""
// "newmark"; instead of "exact": "closed form", or "closed form, steps in contact"
std::string describe_method(const Contender& contender);  // "eigenmodes", "eigenmodes, rotation coupled"
std::string describe_integrator(const Contender& contender);

}  // namespace mb
