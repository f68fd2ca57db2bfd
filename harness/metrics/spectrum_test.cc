#include "harness/metrics/spectrum.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mb {
namespace {

constexpr double rate = 600;  // [1/s]
const VectorXd t = VectorXd::LinSpaced(175, 0, 174 / rate);

Eigen::RowVectorXd wave(double frequency) { return (2 * pi * frequency * t.array() + 0.7).sin().transpose(); }

TEST(EnergyShare, OfTwoWavesIsThatOfTheSquaresOfTheirVelocities) {
  // 90 and 250 /s: of the latter a difference over a sample shows no more than 0.74.
  for (const double fast : {90.0, 250.0}) {
    MatrixXd x(2, t.size());
    x.row(0) = 3 * wave(12) / 12;
    x.row(1) = 4 * wave(fast) / fast;
    // 5e-4 of a Hann-windowed wave's energy lies outside its main lobe; the phase of a short record adds as much again.
    EXPECT_NEAR(energy_share_above(x, VectorXd::Ones(2), rate, 30), 16.0 / 25, 2e-3) << fast;
    EXPECT_NEAR(energy_share_above(x, VectorXd{{16, 9}}, rate, 30), 0.5, 2e-3) << fast;
    EXPECT_NEAR(energy_share_above(x.colwise().sum(), VectorXd::Ones(1), rate, 30), 16.0 / 25, 2e-3) << fast;
  }
}

TEST(EnergyShare, WhatStandsStillHasNone) {
  const MatrixXd x = wave(12) / 12 + wave(90) / 90;
  const double share = energy_share_above(x, VectorXd::Ones(1), rate, 30);
  EXPECT_NEAR(share, 0.5, 2e-3);
  // A sag a thousand times as large: three digits of 1e-16 are lost, and as many again with the squares.
  EXPECT_NEAR(energy_share_above((x.array() + 100).matrix(), VectorXd::Ones(1), rate, 30), share, 1e-10);
}

TEST(EnergyShare, LeaksLittleBeyondTwoBins) {
  const double bin = rate / static_cast<double>(t.size());
  for (const double frequency : {5.0, 12.3, 50.0}) {
    EXPECT_LT(energy_share_above(wave(frequency), VectorXd::Ones(1), rate, frequency + 2 * bin), 1e-3) << frequency;
    EXPECT_GT(energy_share_above(wave(frequency), VectorXd::Ones(1), rate, frequency - 2 * bin), 0.99) << frequency;
  }
}

TEST(EnergyShare, LimitsAndScale) {
  const MatrixXd x = MatrixXd::Random(5, 64);
  const VectorXd w = VectorXd::Ones(5);
  EXPECT_EQ(energy_share_above(x, w, rate, rate), 0);
  const double share = energy_share_above(x, w, rate, 100);
  EXPECT_GT(share, 0);
  EXPECT_LT(share, energy_share_above(x, w, rate, 50));
  EXPECT_NEAR(energy_share_above(1e-200 * x, w, rate, 100), share, 1e-12);  // no underflow
}

TEST(EnergyShare, NothingHasNoShare) {
  EXPECT_TRUE(std::isnan(energy_share_above(MatrixXd::Zero(3, 20), VectorXd::Ones(3), rate, 1)));
  EXPECT_TRUE(std::isnan(energy_share_above(MatrixXd(0, 20), VectorXd(), rate, 1)));
  EXPECT_TRUE(std::isnan(energy_share_above(MatrixXd(3, 0), VectorXd::Ones(3), rate, 1)));
  EXPECT_TRUE(std::isnan(energy_share_above(MatrixXd::Ones(3, 1), VectorXd::Ones(3), rate, 1)));
  const MatrixXd rest = (MatrixXd::Random(3, 20).array() * 1e-15 + 1).matrix();  // at rest but for rounding
  EXPECT_TRUE(std::isnan(energy_share_above(rest, VectorXd::Ones(3), rate, 1)));
  EXPECT_TRUE(std::isnan(energy_share_above(MatrixXd::Constant(3, 20, NAN), VectorXd::Ones(3), rate, 1)));
  for (const double bad : {double{NAN}, double{INFINITY}, 1e308}) {
    MatrixXd x = MatrixXd::Constant(3, 20, -1e308);  // differences overflow
    x(1, 19) = bad;
    EXPECT_TRUE(std::isnan(energy_share_above(x, VectorXd::Ones(3), rate, 1))) << bad;
  }
}

}  // namespace
}  // namespace mb
