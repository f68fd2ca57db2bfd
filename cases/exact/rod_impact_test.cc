#include "cases/exact/rod_impact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "mechanics/geometry/gauss.h"
#include "mechanics/verified_test.h"

namespace mb {
namespace {

constexpr double L = 0.7, E = 3e6, rho = 900, v = 0.2;
const double c = std::sqrt(E / rho), tau = 2 * L / c, impedance = rho * c;

// k_n L/E = layers
RodImpact rod(double layers) { return {L, E, rho, v, layers * E / L}; }

// p(t) of the formulas is k_n times how deep the waves that it sends take the end, and the end is out for good
// afterwards: twelve passages on. Rounding of the sums.
TEST(RodImpactVerification, TheEndFeelsTheLayer) {
  for (const double layers : {5.0, 20.0, 100.0, 1e4}) {
    const RodImpactWaves waves(rod(layers));
    for (double t = 0.001 * tau; t < 12 * tau; t += 0.013 * tau) {
      const double depth = -waves.state(0, t).u, size = v * tau;
      EXPECT_NEAR(waves.pressure(t) / (layers * E / L), std::max(0.0, depth), 1e-14 * size) << layers << ' ' << t / tau;
      if (t > waves.contact().duration) {
        EXPECT_LT(depth, 0);
      }
    }
    EXPECT_NEAR(waves.state(0, waves.contact().duration).u, 0, 1e-14 * v * tau);
  }
}

// Strain is du/dz, -p/E at the wall and 0 at the free end.
TEST(RodImpactVerification, StrainIsThatOfTheDisplacement) {
  const RodImpactWaves waves(rod(20));
  const double h = 1e-6 * L;
  for (double t = 0.017 * tau; t < 4 * tau; t += 0.031 * tau) {
    EXPECT_NEAR(waves.state(0, t).strain, -waves.pressure(t) / E, 1e-12 * v / c);
    EXPECT_NEAR(waves.state(L, t).strain, 0, 1e-12 * v / c);
    for (const double z : {0.11 * L, 0.523 * L, 0.87 * L})  // second derivatives are about kappa/c = 40/L
      EXPECT_NEAR((waves.state(z + h, t).u - waves.state(z - h, t).u) / (2 * h), waves.state(z, t).strain,
                  1e-4 * v / c);
  }
}

// Momentum of the whole rod, and its energy with that of the layer: u_t by differences, sums by a Gauss rule on pieces.
TEST(RodImpactVerification, KeepsMomentumAndEnergy) {
  const double layers = 20;
  const RodImpactWaves waves(rod(layers));
  const Rule rule = gauss_legendre(6);
  const double h = 1e-6 * tau;
  for (double t = 0.1 * tau; t < 4 * tau; t += 0.237 * tau) {
    double momentum = 0, energy = 0;
    const int n_pieces = 400;  // fronts are kinks at the pieces' scale: of the energy they take (kappa h/c)^2
    for (int piece = 0; piece < n_pieces; ++piece)
      for (Index i = 0; i < rule.x.size(); ++i) {
        const double z = (piece + rule.x[i]) * L / n_pieces, w = rule.w[i] * L / n_pieces;
        const double rate = (waves.state(z, t + h).u - waves.state(z, t - h).u) / (2 * h);
        const double strain = waves.state(z, t).strain;
        momentum += w * rho * rate;
        energy += w * (rho * rate * rate + E * strain * strain) / 2;
      }
    energy += waves.pressure(t) * waves.pressure(t) / (2 * layers * E / L);
    EXPECT_NEAR(momentum, -rho * L * v + waves.impulse(t), 1e-4 * rho * L * v) << t / tau;
    EXPECT_NEAR(energy, rho * L * v * v / 2, 1e-3 * rho * L * v * v / 2) << t / tau;
  }
}

// An independent rod: a chain of n masses at Courant number one, exact within; its first half mass feels the layer by
// the mean of the steps before and after, which is stable. Of order one, for the force has a kink at the touch.
TEST(RodImpactVerification, AgreesWithAChainOfMasses) {
  const double layers = 20;
  const RodImpactWaves waves(rod(layers));
  const int n = 1600;
  const double h = L / n / c, k_n = layers * E / L, by_mass = h * h / (rho * L / n / 2);
  VectorXd before = VectorXd::Constant(n + 1, v * h), now = VectorXd::Zero(n + 1), next(n + 1);
  VectorXd off(3 * n);
  double end = 0;
  for (int step = 0; step < 3 * n; ++step) {
    next.segment(1, n - 1) = now.segment(2, n - 1) + now.head(n - 1) - before.segment(1, n - 1);
    next[n] = 2 * now[n - 1] - before[n];
    next[0] = 2 * now[1] - before[0];
    const double middle = (next[0] + before[0]) / 2 / (1 + by_mass * k_n / 2), p = k_n * std::max(0.0, -middle);
    next[0] += by_mass * p;
    off[step] = p - waves.pressure(step * h);
    if (p > 0) end = step * h;
    before = now;
    now = next;
  }
  testing::expect_verified(
      {.quantity =
           "pressure at the end of a rod that strikes a layer of k_n L/E = 20, largest error over three passages "
           "of its waves, over rho c v",
       .reference = "second route",
       .source = "a chain of 1600 masses at Courant number one",
       .uncertainty = "k_n L/(E n) = 0.0125, of first order in the n masses",
       .tolerance = layers / n,
       .why = "The force has a kink at the touch: the chain is off by at most the force's first rise over one step."},
      off.cwiseAbs().maxCoeff<Eigen::PropagateNaN>() / (impedance * v));
  EXPECT_NEAR(end, waves.contact().duration, 2 * h);
}

// Limits of a hard wall, approached as 1/Y: by 1.678/Y of the duration and 0.103/Y of the speed.
TEST(RodImpactVerification, TendsToTheHardWall) {
  for (const double layers : {100.0, 1e3, 1e5}) {
    const RodContact contact = RodImpactWaves(rod(layers)).contact();
    const double Y = 2 * layers;
    EXPECT_NEAR((contact.duration / tau - 1) * Y, 1.678347, 1e-6);  // e^y = 2 (1 + y); cancellation: 1e-16 Y
    EXPECT_NEAR(contact.peak, impedance * v, 1e-12 * impedance * v);
    EXPECT_NEAR((2 - contact.impulse / (rho * L * v)) * Y, 0.103423, 1e-6);  // 2 (y + 2 e^-y - 2)
  }
}

TEST(RodImpactVerification, LargestPressureIsWhereItSays) {
  const RodImpactWaves waves(rod(5));  // e^-Y/2 = 2e-5
  const auto& [duration, peak, peak_time, impulse] = waves.contact();
  EXPECT_NEAR(waves.pressure(peak_time), peak, 1e-14 * peak);
  for (double t = 0; t < duration; t += 1e-3 * tau) EXPECT_LE(waves.pressure(t), peak);
  EXPECT_EQ(waves.impulse(2 * duration), impulse);
  EXPECT_EQ(waves.impulse(-1), 0);
  EXPECT_EQ(waves.pressure(-1), 0);
}

TEST(RodImpactTest, RefusesBadInput) {
  for (const double bad : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(RodImpactWaves({bad, E, rho, v, 1e9}), std::invalid_argument);
    EXPECT_THROW(RodImpactWaves({L, bad, rho, v, 1e9}), std::invalid_argument);
    EXPECT_THROW(RodImpactWaves({L, E, bad, v, 1e9}), std::invalid_argument);
    EXPECT_THROW(RodImpactWaves({L, E, rho, bad, 1e9}), std::invalid_argument);
    EXPECT_THROW(RodImpactWaves({L, E, rho, v, bad}), std::invalid_argument);
  }
  EXPECT_THROW(RodImpactWaves(rod(4.9)), std::invalid_argument);
}

}  // namespace
}  // namespace mb
