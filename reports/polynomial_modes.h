// What rigid motion with linear, or linear and quadratic, modes leaves of each body of a case:
//
//   aspect = largest over smallest extent,   compact: aspect <= 5, disparate: beyond
//   suffices: displacement error <= 10 %, in contact peak force and impulse, too
//
// Of runs in closed form, against the best truth; in contact of the least step.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/views.h"

namespace mb {

inline constexpr double most_compact = 5;      // [-] aspect up to which a body counts as compact
inline constexpr double still_suffices = 0.1;  // [-] of each error: to the eye still the right shape, force and impulse

double aspect_ratio(const Shape& shape);  // [-] >= 1, of its bounding box

struct PolynomialMark {
  std::string case_name, profile, body, method;  // "linear" or "quadratic"
  double aspect;
  bool in_contact;
  const Record* displacement;            // never null; of the evaluation
  const Record *peak_force, *impulse;    // null where there is none
  const Record *translation, *rotation;  // of the pose; null where the body is held
  bool compact() const { return aspect <= most_compact; }
};
std::vector<PolynomialMark> polynomial_marks(const Evaluation& evaluation);

double worst_error(const PolynomialMark& mark);       // [-] largest of those that decide, each by counted_error
std::optional<bool> suffices(const PolynomialMark&);  // none: 10 % lies within an error bar
std::string kind(const PolynomialMark& mark);         // "compact, in contact", "disparate, under loads"

Sheet polynomials_table(const Evaluation& evaluation);

}  // namespace mb
