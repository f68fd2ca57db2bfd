// How fast errors fall:
//
//   error ~ C h^p,   log error = log C + p log h by least squares,   h = time step, tolerance or 1/r
//
// over the points that tell something of it. Points are left out where the error is above 0.5 (nothing is resolved) or
// not above 5 times what hides it (the truth's bar, or a known floor such as the same basis without time stepping).
// Going from coarse to fine, the curve has flattened where the last refinement falls short of half the slope that the
// points before it have: the last point goes, again and again, and at its end the smallest error is a floor, of which
// points within a factor 3 go too: a floor f that adds as sqrt(e^2 + f^2) then bends them by less than 6 %. No order is
// given where p < 0.1 or p is less than twice its standard error: an error of another kind rules it.
#pragma once

#include <string>
#include <vector>

#include "reports/views.h"

namespace mb {

inline constexpr double unresolved = 0.5, bars_clear = 5, floors_clear = 3,
                        least_order = 0.1;  // [-] the rule above

struct OrderPoint {
  double h;       // > 0: time step [s], tolerance [-] or 1/r [-]
  double error;   // >= 0, in the unit of its metric
  double hidden;  // >= 0, same unit: what of the error cannot be told, its bar or floor
};

struct ObservedOrder {
  double order, standard_error;  // [-] order > 0; both NaN where there is none
  int n_points, n_left_out;
  double coarsest, finest;  // h of the points used
  std::string why_none;     // "fewer than three points", "error does not fall"; "" where there is an order
};
ObservedOrder fit_order(std::vector<OrderPoint> points);

// What is varied along a curve, all else being fixed.
enum class Refinement { modes, step, tolerance };

// Runs of one case that differ in one setting, by one measure.
struct Curve {
  std::string case_name, profile;
  Measure measure;
  Refinement refinement;
  Contender contender;           // of its finest run
  Theory theory;                 // of the case's body
  std::vector<const Run*> runs;  // coarse to fine; as old as the evaluation
  ObservedOrder observed;
};
// Of the displacement, strain and surface norms: over r for every method and integrator (at its smallest step or
// tolerance), over the step or tolerance at every r and every mesh. Only curves of three runs or more.
std::vector<Curve> curves(const Evaluation& evaluation);

Sheet orders_table(const std::vector<Curve>& all);

// Whether a run stands in the figure of errors against r: closed form, or the smallest step (tolerance) that was run.
// Against the step: the largest r of a method and integrator, and the mesh with most unknowns of a degree.
struct Drawn {
  bool against_modes, against_step;
};
std::vector<Drawn> drawn(const std::vector<Run>& runs);  // one a run

}  // namespace mb
