// What a sequence of frames makes of a motion, x = x_low + x_high taken apart at half the frame rate (band_split.h) and
// seen through a shutter B (shutter.h), root mean squares taken over the frames and, weighted, over the points:
//
//   aliasing         |B y_high| / |x_low|          frames show it as slow motion that is not there
//   droop            |B y_low - y_low| / |x_low|   what averaging costs
//   low-band error   |y_low - x_low| / |x_low|     what of slow motion the contender y itself has wrong
//   frame error      |B y - x_low| / |x_low|       all of it
//
// x is the truth. A motion is given as shapes times signals, u(t) = U q(t).
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cases/contract/finding.h"
#include "harness/metrics/band_split.h"
#include "harness/metrics/shutter.h"

namespace mb {

struct Recording {
  MatrixXd shapes;         // U: values x signals, rows times the square root of their weight
  PaddedSpectrum signals;  // q
};

// x in the weights w (one a row, > 0) by few signals: diag(w)^1/2 x = U q, U^T U = I, by the method of snapshots; what
// is left out is below 1e-7 of the largest signal. Sirovich 1987, Q. Appl. Math. 45(3).
Recording recording(const MatrixXd& x, const VectorXd& w, double rate);

// y_low, B y_low, B y_high at frames (columns): of signals, or of weighted values.
struct FrameView {
  MatrixXd low, low_shown, high_shown;
};
// t [s]: frame times, within the record.
FrameView frame_view(const PaddedSpectrum& y, const VectorXd& t, double frame_rate, const Shutter& shutter);
// The same where B y is known better than samples tell, as exact means of a closed form are.
FrameView frame_view(const PaddedSpectrum& y, const VectorXd& t, double frame_rate, const Shutter& shutter,
                     const MatrixXd& y_shown);
// From the first n signals to weighted values.
FrameView values_of(const MatrixXd& shapes, const FrameView& signals, Index n);

struct FrameMarks {
  double aliasing, droop, low_band_error, frame_error;  // [-] NaN where the truth has no slow motion
};
FrameMarks frame_marks(const FrameView& y, const MatrixXd& x_low);  // of weighted values

// Claim C2 at one frame rate: full order and the modal answer without the modes above half of it, both at points.
// in_transition: a mode kept lies where the filter passes only part of it.
std::string aliasing_verdict(const FrameMarks& full, const FrameMarks& cut, bool in_transition);

// The smallest box of n sub-samples with which full order aliases at most as much as `wanted`; boxes: (n, aliasing),
// n ascending, at least one. "none" where the exact mean, their limit, aliases more: no number does then. "> n" where
// the record has no samples for as many as it takes.
FindingCell sub_samples_needed(const std::vector<std::pair<int, double>>& boxes, double exact_mean, double wanted);

// Mean |q_high'|^2 and |q'|^2 over the padded record, signal by signal: twice the kinetic energy where U^T U = I.
struct BandEnergy {
  VectorXd high, whole;
};
BandEnergy band_energy(const PaddedSpectrum& y, double f_c);

}  // namespace mb
