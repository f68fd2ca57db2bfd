// One impact at several speeds, by linear and by finite kinematics on the same mesh, and by modes:
//
//   v = factor v_0,   error of linear theory = |d_linear - d_finite|_M / |d_finite|_M   over [0, T/4 + 2 T]
//
// T Hertz's duration at that speed, d the deformation of the first body in its best rigid frame. Without gravity, so
// that the speed alone is varied; the layer is the scene's own at all speeds. Other bodies stay linear.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "harness/analysis/analysis.h"
#include "harness/analysis/first_impact.h"
#include "mechanics/types.h"

namespace mb {

struct AmplitudeRow {
  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();

  double speed, factor;      // [m/s] along the normal at the first touch; [-] of the scene's
  std::string status;        // "ok", else which answer failed and how: what it would say is NaN
  double strain = nan;       // [-] largest principal strain in magnitude, of the finite answer
  double deformation = nan;  // [-] largest of the surface over the body's extent, of the finite answer
  double strain_moved = nan, deformation_moved = nan;  // [-] what ten times the tolerance makes of both in linear full
                                                       // order, relative
  double of_linear = nan;                              // [-] the error above
  double of_steps = nan;                               // [-] likewise of linear full order at ten times the tolerance
  double modal_linear = nan;                           // [-] likewise of modes against linear full order
  double modal_finite = nan;                           // [-] and against finite
  double of_modal_steps = nan;                         // [-] likewise of modes by steps twice as long
  FirstImpact linear = {nan, nan, nan, nan}, finite = {nan, nan, nan, nan};
  FirstImpact loose = {nan, nan, nan, nan};  // of linear full order at ten times the tolerance
};

// With the study's most modes, static shapes, and the least of its steps; full order at a tenth of the truth's
// tolerance, since differences of its answers are asked for. Throws std::invalid_argument as `thrown` does
// (contact_variants.h), and for a first body that is no isotropic solid with Rayleigh damping.
std::vector<AmplitudeRow> amplitude_sweep(const AnalysisContext& context, const std::vector<double>& factors);

// Where y, at least one, passes the limit for the first time over ascending x, both > 0, by a line in logarithms: 0
// where it lies above already at the first, infinity where nowhere. Points that are not finite are left out.
struct Passed {
  double at, bar;  // the bar: distance to the farther of the two points that it lies between
};
Passed where_passed(const VectorXd& x, const VectorXd& y, double limit);

double largest_principal(const MatrixXd& strain);  // [-] in magnitude; 6 p x n_t, Voigt with engineering shear

}  // namespace mb
