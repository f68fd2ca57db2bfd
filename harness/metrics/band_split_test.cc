#include "harness/metrics/band_split.h"

#include <gtest/gtest.h>

#include <cmath>

#include "harness/metrics/shutter.h"

namespace mb {
namespace {

constexpr double rate = 600;  // [1/s]

MatrixXcd slow_transform(const MatrixXcd& x) {
  MatrixXcd X = MatrixXcd::Zero(x.rows(), x.cols());
  for (Index k = 0; k < x.cols(); ++k)
    for (Index n = 0; n < x.cols(); ++n)
      X.col(k) += x.col(n) * std::polar(1.0, -2 * pi * static_cast<double>(k * n) / static_cast<double>(x.cols()));
  return X;
}

TEST(Fourier, IsItsDefinition) {
  for (const Index n : {1, 2, 8, 64}) {
    const MatrixXcd x = MatrixXcd::Random(3, n), X = fourier(x);
    EXPECT_LT((X - slow_transform(x)).norm(), 1e-13 * static_cast<double>(n)) << n;
  }
}

TEST(Fourier, RefusesOtherSizes) {
  EXPECT_THROW(fourier(MatrixXcd::Zero(2, 0)), std::invalid_argument);
  EXPECT_THROW(fourier(MatrixXcd::Zero(2, 3)), std::invalid_argument);
}

TEST(LowPass, FallsFromOneToNothingAroundTheCut) {
  EXPECT_EQ(low_pass(0, 12), 1);
  EXPECT_EQ(low_pass(0.8 * 12, 12), 1);
  EXPECT_DOUBLE_EQ(low_pass(12, 12), 0.5);
  EXPECT_EQ(low_pass(1.2 * 12, 12), 0);
  for (double f = 9.6; f < 14.3; f += 0.1) EXPECT_GT(low_pass(f, 12), low_pass(f + 0.1, 12)) << f;
  EXPECT_DOUBLE_EQ(low_pass(11, 12) + low_pass(13, 12), 1);
}

// A wave that starts from rest as motions do, smoothly within a tenth of the record.
Eigen::RowVectorXd wave(const VectorXd& t, double f) {
  const Eigen::ArrayXd x = (10 * t.array() / t(t.size() - 1)).min(1);
  return ((2 * pi * f * t.array() + 0.4).sin() * (pi / 2 * x).sin().square()).matrix().transpose();
}
VectorXd samples(Index n) { return VectorXd::LinSpaced(n, 0, static_cast<double>(n - 1) / rate); }
double rms(const MatrixXd& x) { return std::sqrt(x.squaredNorm() / static_cast<double>(x.size())); }

TEST(BandSplit, WavesGoToTheirSide) {
  const VectorXd t = samples(1201);
  MatrixXd x(2, t.size());
  x.row(0) = wave(t, 5);
  x.row(1) = wave(t, 40);
  const PaddedSpectrum spectrum(x, rate);
  const MatrixXd low = spectrum.at(t, [](double f) { return low_pass(f, 12); });
  // In the middle half: what is left of the other side is the memory of the record's ends, falling as 1/t^3.
  const auto middle = [&](const Eigen::RowVectorXd& row) { return rms(row.segment(300, 600)); };
  EXPECT_LT(middle(low.row(0) - x.row(0)), 2e-3);
  EXPECT_LT(middle(low.row(1)), 2e-3);
  EXPECT_LT(rms(low.row(0) - x.row(0)), 3e-2);  // ends included, where the record goes on by guess
  EXPECT_LT(rms(low.row(1)), 3e-2);
}

TEST(BandSplit, WithGainOneIsTheRecord) {
  const VectorXd t = samples(175);
  MatrixXd x(2, t.size());
  x.row(0) = wave(t, 7);
  x.row(1) = wave(t, 70).array() + 3;  // about a rest that is not at zero
  const PaddedSpectrum spectrum(x, rate);
  const auto one = [](double) { return 1.0; };
  EXPECT_LT((spectrum.at(t, one) - x).cwiseAbs().maxCoeff(), 1e-13);
  // Between samples: the band-limited interpolant.
  const VectorXd between = (t.array().head(174) + 0.5 / rate).segment(20, 120);
  MatrixXd wanted(2, between.size());
  const VectorXd phase = 2 * pi * between;
  wanted.row(0) = (7 * phase.array() + 0.4).sin();
  wanted.row(1) = (70 * phase.array() + 0.4).sin() + 3;
  EXPECT_LT((spectrum.at(between, one) - wanted).cwiseAbs().maxCoeff(), 1e-3);
}

TEST(BandSplit, DerivativeIsAGainToo) {
  const VectorXd t = samples(601);
  const PaddedSpectrum spectrum(wave(t, 9), rate);
  const MatrixXd v = spectrum.at(t, [](double f) { return std::complex<double>(0, 2 * pi * f); });
  const Eigen::ArrayXd wanted = 18 * pi * (18 * pi * t.array() + 0.4).cos();
  // Away from the ends; the kink in curvature at the record's end rings on as 1/t^2.
  EXPECT_LT((v.row(0).transpose().array() - wanted).segment(150, 300).abs().maxCoeff(), 1e-3 * 18 * pi);
}

TEST(BandSplit, MeanSquareIsThatOfThePaddedRecord) {
  const VectorXd t = samples(601);
  const PaddedSpectrum spectrum(wave(t, 9 - 0.2 / pi), rate);
  // Ending in a zero, the record fades out over its own length within 4096 samples: energy 1/2 and 1/2 int cos^4 =
  // 3/16.
  const double wanted = (0.5 + 3.0 / 16) * 601 / 4096;
  EXPECT_NEAR(spectrum.mean_square([](double) { return 1.0; })(0), wanted, 0.1 * wanted);  // the start is smooth, too
  const VectorXd high = spectrum.mean_square([](double f) { return 1 - low_pass(f, 12); });
  EXPECT_LT(high(0), 5e-3 * wanted);  // a start within 0.1 s spreads the wave over some 10/s
}

TEST(BandSplit, BoxOfNIsAMeanOfShiftedRecords) {
  const VectorXd t = samples(601);
  const PaddedSpectrum spectrum(wave(t, 33), rate);
  const VectorXd frames = whole_frames(24, t(600));
  for (const int n : {1, 2, 4, 16}) {
    const Shutter box{1.0 / 24, n};
    MatrixXd mean = MatrixXd::Zero(1, frames.size());
    for (int j = 0; j < n; ++j)
      mean += spectrum.at(frames.array() + ((j + 0.5) / n - 0.5) / 24, [](double) { return 1.0; }) / n;
    EXPECT_LT((spectrum.at(frames, [&](double f) { return gain(box, f); }) - mean).norm(), 1e-12) << n;
  }
}

TEST(BandSplit, RefusesBadInput) {
  const MatrixXd x = MatrixXd::Ones(1, 8);
  EXPECT_THROW(PaddedSpectrum(MatrixXd::Ones(1, 1), rate), std::invalid_argument);
  EXPECT_THROW(PaddedSpectrum(x, 0), std::invalid_argument);
  EXPECT_THROW(PaddedSpectrum(x, NAN), std::invalid_argument);
  EXPECT_THROW(PaddedSpectrum(MatrixXd::Constant(1, 8, NAN), rate), std::invalid_argument);
  const auto one = [](double) { return 1.0; };
  EXPECT_THROW(PaddedSpectrum(x, rate).at(VectorXd::Constant(1, -0.01), one), std::invalid_argument);
  EXPECT_THROW(PaddedSpectrum(x, rate).at(VectorXd::Constant(1, 8 / rate), one), std::invalid_argument);
  EXPECT_THROW(PaddedSpectrum(x, rate).at(VectorXd::Constant(1, NAN), one), std::invalid_argument);
}

TEST(Shutter, GainsAreThoseOfTheirMeans) {
  const double w = 1.0 / 24;
  for (const double f : {0.0, 3.0, 12.0, 23.9, 24.0, 40.0, 96.0, 101.0}) {
    EXPECT_EQ(gain({w, 1}, f), 1) << f;
    double exact = 0;
    const int many = 20000;
    for (const int n : {2, 3, 4, 5, 64}) {
      double mean = 0;
      for (int j = 0; j < n; ++j) mean += std::cos(2 * pi * f * ((j + 0.5) / n - 0.5) * w) / n;
      EXPECT_NEAR(gain({w, n}, f), mean, 1e-12) << n << " " << f;
    }
    for (int j = 0; j < many; ++j) exact += std::cos(2 * pi * f * ((j + 0.5) / many - 0.5) * w) / many;
    EXPECT_NEAR(gain({w, 0}, f), exact, 1e-7) << f;  // the midpoint rule's error
  }
  EXPECT_LT(std::abs(gain({w, 0}, 24)), 1e-15);  // the mean over a period sees nothing
}

TEST(Shutter, ApparentFrequenciesAndFrames) {
  EXPECT_DOUBLE_EQ(apparent_frequency(5, 24), 5);
  EXPECT_DOUBLE_EQ(apparent_frequency(12, 24), 12);
  EXPECT_DOUBLE_EQ(apparent_frequency(30, 24), 6);
  EXPECT_DOUBLE_EQ(apparent_frequency(42, 24), 6);
  EXPECT_DOUBLE_EQ(apparent_frequency(48, 24), 0);
  const VectorXd frames = whole_frames(24, 0.25);  // 6 frames: the last one's shutter would stay open too long
  ASSERT_EQ(frames.size(), 5);
  EXPECT_DOUBLE_EQ(frames(0), 1.0 / 24);
  EXPECT_DOUBLE_EQ(frames(4), 5.0 / 24);
  EXPECT_EQ(whole_frames(24, 0.25 + 0.5 / 24).size(), 6);
  EXPECT_EQ(whole_frames(24, 0.01).size(), 0);
}

TEST(Shutter, RefusesBadInput) {
  EXPECT_THROW(gain({0, 1}, 3), std::invalid_argument);
  EXPECT_THROW(gain({1, -1}, 3), std::invalid_argument);
  EXPECT_THROW(whole_frames(0, 1), std::invalid_argument);
}

}  // namespace
}  // namespace mb
