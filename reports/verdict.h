// The first lines of a report: do the checks hold, what is won at 1 % error, what failed and why.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/views.h"

namespace mb {

struct Verdict {
  int n_cases = 0, n_cases_within = 0;  // within: every check of the case holds
  int n_checks = 0, n_hold = 0, n_not_decidable = 0, n_not_measured = 0;
  bool is_timed = false;                // whether any run was: without times there is no speed-up to speak of
  std::vector<SpeedUp> at_target;       // a case: its cheapest reduced run within the error target, see speed_ups_at
  long n_compared = 0;                  // of at_target, those that have a rival
  std::optional<double> median;         // [-] speed-up over those that have a rival
  long n_perturbed = 0, n_at_edge = 0;  // of at_target, by has_perturbed_time and stands_at_edge
  int n_failed_runs = 0;                // runs with a measure that failed; undefined and unstable ones are none
  int n_unstable_runs = 0;              // explicit integrators beyond their step limit
  std::vector<std::string> sentences;   // plain text, untrusted names within
};
Verdict verdict_of(const Evaluation& evaluation);

// Of every case and profile the cheapest reduced run over the cheapest full-order one, both within the target [-] by
// that norm against the best truth. Without cases of beam or plate theory: their full-order runs are half waves, modes
// too, against which a modal method has nothing to win that the paper claims.
std::vector<SpeedUp> at_target(const Evaluation& evaluation, const std::string& norm, double target = error_target);

// "left out are a, b, whose bodies are beams or plates by theory: ..."; "" where no run is of such a case.
std::string theory_remark(const Evaluation& evaluation);

std::vector<std::pair<std::string, SpeedUp>> headline_pairs(const Evaluation& evaluation);  // norm, pair; all norms

Sheet headline_table(const Evaluation& evaluation);  // the pairs of the headline's norm

// Lines for a shell. A comment says what they do not repeat: runs of settings which the case file does not list.
std::vector<std::string> reproducing_commands(const Evaluation& evaluation);

}  // namespace mb
