#include "harness/metrics/spectrum.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mb {
namespace {

constexpr double rate = 600;  // [1/s]
const VectorXd t = VectorXd::LinSpaced(175, 0, 174 / rate);

Eigen::RowVectorXd wave(double frequency) { return (2 * pi * frequency * t.array() + 0.7).sin().transpose(); }

TEST(EnergyShare, OfTwoWavesIsThatOfTheirSquares) {
  MatrixXd x(2, t.size());
  x.row(0) = 3 * wave(12);
  x.row(1) = 4 * wave(90);
  // 5e-4 of a Hann-windowed wave's energy lies outside its main lobe; the phase of a short record adds as much again.
  EXPECT_NEAR(energy_share_above(x, VectorXd::Ones(2), rate, 30), 16.0 / 25, 2e-3);
  EXPECT_NEAR(energy_share_above(x, VectorXd{{16, 9}}, rate, 30), 0.5, 2e-3);
  EXPECT_NEAR(energy_share_above(x.colwise().sum(), VectorXd::Ones(1), rate, 30), 16.0 / 25, 2e-3);
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
  EXPECT_TRUE(std::isnan(energy_share_above(MatrixXd::Constant(3, 20, NAN), VectorXd::Ones(3), rate, 1)));
}

}  // namespace
}  // namespace mb
