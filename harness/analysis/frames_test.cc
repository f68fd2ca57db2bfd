#include "harness/analysis/frames.h"

#include <gmock/gmock.h>

#include <cmath>

namespace mb {
namespace {

using ::testing::StartsWith;

constexpr double rate = 960, F = 24;  // [1/s] 40 samples a frame
const VectorXd t = VectorXd::LinSpaced(4 * 960 + 1, 0, 4);
const VectorXd frames = whole_frames(F, 4).segment(20, 55);  // in the middle, away from the record's ends

Eigen::RowVectorXd wave(double f) { return (2 * pi * f * t.array() + 0.3).sin().transpose(); }
Eigen::RowVectorXd wave_at(const VectorXd& times, double f) {
  return (2 * pi * f * times.array() + 0.3).sin().transpose();
}
double rms(const MatrixXd& x) { return std::sqrt(x.squaredNorm() / static_cast<double>(x.size())); }

FrameMarks marks_of(const MatrixXd& x, const Shutter& shutter) {
  const PaddedSpectrum spectrum(x, rate);
  return frame_marks(frame_view(spectrum, frames, F, shutter), frame_view(spectrum, frames, F, shutter).low);
}

TEST(Frames, OfSlowMotionShowNoAliasing) {
  const FrameMarks marks = marks_of(wave(5), {1 / F, 1});
  EXPECT_LT(marks.aliasing, 1e-4);
  EXPECT_LT(marks.droop, 1e-12);  // a point averages nothing
  EXPECT_EQ(marks.low_band_error, 0);
  EXPECT_LT(marks.frame_error, 1e-4);
}

TEST(Frames, OfFastMotionShowItAtItsAliasFrequency) {
  const double fast = 41;  // seen as 7 Hz, backwards: sin(2 pi 41 j/24 + 0.3) = -sin(2 pi 7 j/24 - 0.3)
  const MatrixXd x = wave(5) + 0.5 * wave(fast);
  const FrameView view = frame_view(PaddedSpectrum(x, rate), frames, F, {1 / F, 1});
  EXPECT_DOUBLE_EQ(apparent_frequency(fast, F), 7);
  const Eigen::RowVectorXd alias = -0.5 * (2 * pi * 7 * frames.array() - 0.3).sin().transpose();
  EXPECT_LT(rms(view.high_shown - alias), 1e-4);
  const FrameMarks marks = frame_marks(view, view.low);
  EXPECT_NEAR(marks.aliasing, 0.5 * rms(wave_at(frames, fast)) / rms(wave_at(frames, 5)), 1e-4);
  EXPECT_NEAR(marks.frame_error, marks.aliasing, 1e-12);
}

TEST(Frames, BoxesAndMeansWeighEveryWaveWithTheirGain) {
  const double slow = 5, fast = 41;
  const MatrixXd x = wave(slow) + 0.5 * wave(fast);
  for (const int n : {1, 2, 4, 8, 0}) {
    const Shutter shutter{1 / F, n};
    const FrameMarks marks = marks_of(x, shutter);
    const double point = 0.5 * rms(wave_at(frames, fast)) / rms(wave_at(frames, slow));
    EXPECT_NEAR(marks.aliasing, std::abs(gain(shutter, fast)) * point, 1e-4) << n;
    EXPECT_NEAR(marks.droop, 1 - gain(shutter, slow), 1e-4) << n;
  }
  // 41 Hz over 1/24 s: the mean's sinc leaves 0.148 of it.
  EXPECT_NEAR(gain({1 / F, 0}, fast), std::sin(pi * fast / F) / (pi * fast / F), 1e-15);
}

TEST(Frames, LowBandErrorIsTheContendersOwn) {
  const MatrixXd x = wave(5) + 0.5 * wave(41), y = 0.9 * wave(5);
  const MatrixXd low = frame_view(PaddedSpectrum(x, rate), frames, F, {1 / F, 1}).low;
  const FrameMarks marks = frame_marks(frame_view(PaddedSpectrum(y, rate), frames, F, {1 / F, 1}), low);
  EXPECT_NEAR(marks.low_band_error, 0.1, 1e-4);
  EXPECT_NEAR(marks.frame_error, 0.1, 1e-4);
  EXPECT_LT(marks.aliasing, 1e-4);
}

TEST(Frames, WhatIsShownMayBeKnownBetter) {
  const PaddedSpectrum spectrum(wave(5), rate);
  const MatrixXd shown = wave_at(frames, 5) + 0.25 * wave_at(frames, 30);
  const FrameMarks marks = frame_marks(frame_view(spectrum, frames, F, {1 / F, 1}, shown), wave_at(frames, 5));
  EXPECT_NEAR(marks.aliasing, 0.25 * rms(wave_at(frames, 30)) / rms(wave_at(frames, 5)), 1e-4);
}

TEST(Frames, EnergyIsThatOfVelocities) {
  MatrixXd x(2, t.size());
  x.row(0) = wave(5) / 5;
  x.row(1) = 2 * wave(41) / 41;
  const BandEnergy energy = band_energy(PaddedSpectrum(x, rate), F / 2);
  EXPECT_NEAR(energy.high.sum() / energy.whole.sum(), 0.8, 5e-3);  // four times the energy; the ends blur it
  EXPECT_LT(energy.high(0), 1e-2 * energy.whole(0));
  EXPECT_GT(energy.high(1), 0.99 * energy.whole(1));
}

TEST(Frames, ARecordingIsTheMotionItself) {
  MatrixXd modes = MatrixXd::Random(30, 2), x = modes.col(0) * wave(5) + modes.col(1) * wave(41);
  const VectorXd w = VectorXd::Random(30).array().abs() + 0.1;
  for (const Index n_times : {Index{12}, t.size()}) {  // fewer times than values, and more
    const Recording found = recording(x.leftCols(n_times), w, rate);
    EXPECT_EQ(found.shapes.cols(), 2);
    EXPECT_LT((found.shapes.transpose() * found.shapes - MatrixXd::Identity(2, 2)).norm(), 1e-6);
    const MatrixXd again = found.shapes * found.signals.at(t.head(n_times), [](double) { return 1.0; });
    const MatrixXd weighted = w.cwiseSqrt().asDiagonal() * x.leftCols(n_times);
    EXPECT_LT((again - weighted).norm(), 1e-7 * weighted.norm());
  }
  const Recording still = recording(MatrixXd::Zero(6, 9), VectorXd::Ones(6), rate);
  EXPECT_EQ(still.shapes.norm(), 0);
  const FrameView nothing = frame_view(still.signals, VectorXd::Constant(1, 4 / rate), F, {1 / F, 1});
  EXPECT_TRUE(std::isnan(frame_marks(nothing, nothing.low).aliasing));
}

TEST(Frames, ViewsOfValuesFollowThoseOfSignals) {
  const MatrixXd shapes = MatrixXd::Random(6, 3);
  MatrixXd q(3, t.size());
  q << wave(5), wave(9), wave(41);
  const FrameView view = frame_view(PaddedSpectrum(q, rate), frames, F, {1 / F, 2});
  const FrameView two = values_of(shapes, view, 2);
  const FrameView direct = frame_view(PaddedSpectrum(shapes.leftCols(2) * q.topRows(2), rate), frames, F, {1 / F, 2});
  EXPECT_LT((two.low - direct.low).norm() + (two.low_shown - direct.low_shown).norm(), 1e-11);
  EXPECT_LT((two.high_shown - direct.high_shown).norm(), 1e-11);
}

TEST(Frames, VerdictsFollowFromTheFigures) {
  const FrameMarks calm{0.009, 0, 0, 0.009}, strong{0.3, 0, 0, 0.3};
  const auto verdict = [](const FrameMarks& full, const FrameMarks& cut) { return aliasing_verdict(full, cut, false); };
  EXPECT_THAT(verdict(calm, {0, 0, 0, 0}), StartsWith("not decided"));
  EXPECT_EQ(verdict(strong, {0.02, 0, 0.1, 0.1}), "holds");
  EXPECT_THAT(verdict(strong, {0.02, 0, 0.5, 0.5}), StartsWith("holds within limits"));
  EXPECT_THAT(verdict(strong, {0.05, 0, 0.1, 0.1}), StartsWith("does not hold"));
  EXPECT_EQ(verdict({0.05, 0, 0, 0.05}, {0.009, 0, 0, 0.01}), "holds");  // a tenth, or below what is seen and by half
  EXPECT_THAT(verdict({0.0101, 0, 0, 0.05}, {0.0099, 0, 0, 0.01}), StartsWith("does not hold"));
  EXPECT_THAT(verdict({NAN, 0, 0, 0}, {0, 0, 0, 0}), StartsWith("not decided"));
  EXPECT_THAT(aliasing_verdict(strong, {0.05, 0, 0.1, 0.1}, true), StartsWith("not decided: a mode kept"));
  EXPECT_EQ(aliasing_verdict(strong, {0.02, 0, 0.1, 0.1}, true), "holds");
}

TEST(Frames, SubSamplesNeededAreANumberOpenOrNone) {
  const std::vector<std::pair<int, double>> boxes{{1, 0.5}, {2, 0.2}, {4, 0.1}};
  EXPECT_EQ(sub_samples_needed(boxes, 0.01, 0.2), FindingCell(2.0));
  EXPECT_EQ(sub_samples_needed(boxes, 0.01, 0.05), FindingCell("> 4"));   // eight may do
  EXPECT_EQ(sub_samples_needed(boxes, 0.06, 0.05), FindingCell("none"));  // no number can
  EXPECT_EQ(sub_samples_needed(boxes, 0.06, 0.1), FindingCell(4.0));
}

TEST(Frames, RefuseBadInput) {
  EXPECT_THROW(recording(MatrixXd::Ones(3, 4), VectorXd::Ones(2), rate), std::invalid_argument);
  EXPECT_THROW(recording(MatrixXd::Ones(3, 4), VectorXd::Zero(3), rate), std::invalid_argument);
  EXPECT_THROW(recording(MatrixXd(3, 0), VectorXd::Ones(3), rate), std::invalid_argument);
  EXPECT_THROW(recording(MatrixXd::Constant(3, 4, NAN), VectorXd::Ones(3), rate), std::invalid_argument);
}

}  // namespace
}  // namespace mb
