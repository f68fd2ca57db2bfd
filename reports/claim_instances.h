// A claim is measured in several cases, schemes or norms: what each says, and what they say together.
//
//   holds in all that decide -> holds, in some -> holds within stated limits, in none -> does not hold
#pragma once

#include <string>
#include <vector>

#include "reports/claims.h"

namespace mb {

struct Instance {
  std::string where;  // "cylinder-shear"
  std::string label;  // "explicit-euler", "24 1/s", ""
  double value;       // NaN where there is none
  Ruling ruling;
  bool decides = true;  // false: it stands beside the others and is not what the claim speaks of
};

// Rows of every table of that name which name the claim and carry a verdict.
std::vector<Instance> rows_of(const Evaluation& evaluation, const std::string& claim, const std::string& table,
                              const std::string& label, const std::string& value);

std::string by_label(const std::vector<Instance>& instances);  // "explicit-euler: 1.99 to 2.01; ...", all of them
std::string limits(const std::vector<Instance>& instances);    // "holds in a, b; does not hold in c", who decide
void conclude(Claim& claim, const std::vector<Instance>& instances);  // ruling, limits; what was measured is appended

void rule_on_speed_up(Claim& claim, const Evaluation& evaluation);     // C1
void rule_on_polynomials(Claim& claim, const Evaluation& evaluation);  // C4
void rule_on_steps(Claim& claim, const Evaluation& evaluation);        // C6
void rule_on_collision(Claim& claim, const Evaluation& evaluation);    // C11
void rule_on_contact(Claim& claim, const Evaluation& evaluation);      // C12

}  // namespace mb
