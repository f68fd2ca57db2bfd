// A body's motion as the truth has it and as its modes do, ready to be taken apart into frames (frames.h): at the
// volume points, in the M norm, without rigid motion where the body is free. That is projected out,
//
//   x - R (R^T R)^-1 R^T x,   R: rigid motions at the points, weighted
//
// which is linear, unlike the best rigid frame of metrics: it commutes with filters and shutters, and both agree to
// first order in the rotation.
#pragma once

#include <memory>

#include "harness/analysis/frames.h"
#include "harness/analysis/modal_body.h"

namespace mb {

struct RecordedMotions {
  VectorXd t;  // [s] samples
  ModalBody body;
  VectorXd scale;  // [kg^1/2] square roots of the mass at every value
  MatrixXd rigid;  // values x rigid motions, scaled; no columns where a support holds the body
  Recording truth;
  // All modes solved for, in closed form. They are uncoupled: the answer of fewer modes is their first signals.
  Recording modal;
  VectorXd zeta;                    // [-] of the elastic ones
  std::unique_ptr<System> reduced;  // before the stepper, which refers to it
  std::unique_ptr<Stepper> stepper;
};

// With as many modes as asked for, n_elastic, and as it takes to reach a frequency f [1/s], but no more than 256 or a
// third of the degrees of freedom for the sake of the latter.
RecordedMotions recorded_motions(const AnalysisContext& context, int n_elastic, double f);

// The answer of the first n modes with the static response of all others, in closed form.
class CorrectedMotion {
 public:
  CorrectedMotion(const AnalysisContext& context, const RecordedMotions& motions, Index n);
  const Recording& samples() const { return samples_; }
  // At times t, or exact means over a shutter [s] > 0 around them; weighted values x times.
  MatrixXd shown(const VectorXd& t, double shutter) const;

 private:
  const RecordedMotions& motions_;
  std::unique_ptr<Prepared> prepared_;
  Recording samples_;
};

}  // namespace mb
