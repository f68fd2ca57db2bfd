// The claims of Pentland and Williams (Good Vibrations, SIGGRAPH 1989) with what was measured. Verdicts follow from
// records and findings alone and decide no exit code.
#pragma once

#include <string>
#include <vector>

#include "reports/views.h"

namespace mb {

enum class Ruling { holds, holds_within_limits, does_not_hold, not_decided, not_measured };
const char* to_string(Ruling ruling);  // "holds within stated limits"

struct Claim {
  std::string id, statement;  // "C6"
  std::string measured;       // the number, in words; "" where not measured
  Ruling ruling = Ruling::not_measured;
  std::string limits;     // where it holds and where not
  std::string criterion;  // what the ruling goes by
  std::string evidence;   // section of the report: "step-limits"
};
std::vector<Claim> claims(const Evaluation& evaluation);

// Of single rulings the one on all of them; those not measured or not decided do not count beside others.
Ruling together(const std::vector<Ruling>& rulings);

Sheet claims_table(const Evaluation& evaluation);

}  // namespace mb
