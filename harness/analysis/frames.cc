#include "harness/analysis/frames.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "mechanics/algebra/dense_eigen.h"

namespace mb {

Recording recording(const MatrixXd& x, const VectorXd& w, double rate) {
  if (w.size() != x.rows() || x.size() == 0 || !(w.minCoeff() > 0) || !x.allFinite())
    throw std::invalid_argument("a recording needs finite values and a positive weight for each");
  const MatrixXd weighted = w.cwiseSqrt().asDiagonal() * x;
  const bool wide = weighted.cols() > weighted.rows();
  const MatrixXd gram = wide ? MatrixXd(weighted * weighted.transpose()) : MatrixXd(weighted.transpose() * weighted);
  const EigenPairs of_gram = symmetric_eigen(gram);
  const VectorXd& squares = of_gram.values;  // of singular values, ascending
  const double largest = squares(squares.size() - 1);
  if (!(largest > 0)) return {MatrixXd::Zero(x.rows(), 1), PaddedSpectrum(MatrixXd::Zero(1, x.cols()), rate)};
  const Index n_kept = (squares.array() > 1e-14 * largest).count();
  const MatrixXd kept = of_gram.vectors.rightCols(n_kept);
  if (wide) return {kept, PaddedSpectrum(kept.transpose() * weighted, rate)};
  const VectorXd sigma = squares.tail(n_kept).cwiseSqrt();
  return {weighted * kept * sigma.cwiseInverse().asDiagonal(),
          PaddedSpectrum(sigma.asDiagonal() * kept.transpose(), rate)};
}

FrameView frame_view(const PaddedSpectrum& y, const VectorXd& t, double frame_rate, const Shutter& shutter,
                     const MatrixXd& y_shown) {
  const double f_c = frame_rate / 2;
  FrameView view{y.at(t, [&](double f) { return low_pass(f, f_c); }),
                 y.at(t, [&](double f) { return low_pass(f, f_c) * gain(shutter, f); }), y_shown};
  view.high_shown -= view.low_shown;
  return view;
}

FrameView frame_view(const PaddedSpectrum& y, const VectorXd& t, double frame_rate, const Shutter& shutter) {
  return frame_view(y, t, frame_rate, shutter, y.at(t, [&](double f) { return gain(shutter, f); }));
}

FrameView values_of(const MatrixXd& shapes, const FrameView& signals, Index n) {
  const auto U = shapes.leftCols(n);
  return {U * signals.low.topRows(n), U * signals.low_shown.topRows(n), U * signals.high_shown.topRows(n)};
}

FrameMarks frame_marks(const FrameView& y, const MatrixXd& x_low) {
  const double norm = x_low.norm(), scale = norm > 0 ? norm : std::numeric_limits<double>::quiet_NaN();
  return {y.high_shown.norm() / scale, (y.low_shown - y.low).norm() / scale, (y.low - x_low).norm() / scale,
          (y.low_shown + y.high_shown - x_low).norm() / scale};
}

std::string aliasing_verdict(const FrameMarks& full, const FrameMarks& cut, bool in_transition) {
  constexpr double visible = 0.01, removed = 0.1;  // [-] of the slow motion; of full order's aliasing
  if (!(full.aliasing >= visible)) return "not decided: full order shows less than 1 % of aliasing";
  const bool goes =
      cut.aliasing <= removed * full.aliasing || (cut.aliasing <= visible && cut.aliasing <= 0.5 * full.aliasing);
  if (!goes && in_transition) return "not decided: a mode kept lies where the filter passes only part of it";
  if (!goes) return "does not hold: the modes kept are driven above half the frame rate, too";
  if (cut.frame_error <= full.frame_error) return "holds";
  return "holds within limits: aliasing goes, but what is cut costs more than it";
}

FindingCell sub_samples_needed(const std::vector<std::pair<int, double>>& boxes, double exact_mean, double wanted) {
  for (const auto& [n, aliasing] : boxes)
    if (aliasing <= wanted) return static_cast<double>(n);
  if (exact_mean > wanted) return "none";
  return fmt::format("> {}", boxes.back().first);
}

BandEnergy band_energy(const PaddedSpectrum& y, double f_c) {
  using Complex = std::complex<double>;
  return {y.mean_square([&](double f) { return Complex(0, 2 * pi * f * (1 - low_pass(f, f_c))); }),
          y.mean_square([](double f) { return Complex(0, 2 * pi * f); })};
}

}  // namespace mb
