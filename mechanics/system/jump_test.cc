// A load put on all at once, steps far longer than every period:
//
//   u_n = (1 - (-1)^n) K^-1 F
//
// of average acceleration, whose step turns what it does not resolve by half a turn, damped or not. It does not grow,
// and tells nothing of a body that is at rest long before the first step ends.
#include <gtest/gtest.h>

#include "mechanics/system/exact.h"
#include "mechanics/system/newmark.h"
#include "mechanics/system/small_test_systems.h"
#include "mechanics/verified_test.h"

namespace mb {
namespace {

struct Jump {
  explicit Jump(double beta) {
    system.s.assign(static_cast<size_t>(system.F.cols()), Step{1, 0});
    system.damping = {0, beta};
    system.u0.setZero();
    system.v0.setZero();
    rest = MatrixXd(system.K).llt().solve(system.F.rowwise().sum());
  }
  System system = testing::small_box(true);
  VectorXd rest;  // [m] K^-1 F
};

TEST(JumpVerification, AverageAccelerationRingsBetweenNothingAndTwiceTheDeflection) {
  const double omega = std::sqrt(modal_form(Jump(0).system).lambda.minCoeff()), h = 1000 / omega, beta = 0.1 / omega;
  constexpr Index n = 21;
  const VectorXd t = h * VectorXd::LinSpaced(n, 0, n - 1);
  const Jump jump(beta);
  const States seen = newmark(jump.system, h)->run(t), still = exact(jump.system, t[n - 1])->run(t);
  double worst = 0, moves = 0;
  for (Index k = 1; k < n; ++k) {
    worst = std::max(worst, (seen.u.col(k) - (k % 2 == 1 ? 2 : 0) * jump.rest).norm() / jump.rest.norm());
    moves = std::max(moves, (still.u.col(k) - jump.rest).norm() / jump.rest.norm());
  }
  // Of n steps, to the first order: decay and the part of the velocity, 2 n beta/h each; what is left of half a turn.
  const double steps = n - 1, left = 4 * steps * beta / h + 8 * std::pow(steps / (omega * h), 2);
  testing::expect_verified(
      {.quantity = "displacement of average acceleration under a load that jumps at the start, twenty steps of 160 "
                   "periods of the lowest mode, which is damped by 5 %: twice the static one and none by turns, "
                   "absolute over the static one",
       .reference = "property",
       .source = "the step of average acceleration for omega h -> infinity (Hughes 1987, sect. 9.1.2)",
       .uncertainty = "4 n beta/h + 8 n^2/(omega h)^2 of n steps: 1.1 %",
       .tolerance = 1.25 * left,
       .why = "What twenty steps of finite length leave of the limit, a quarter more for higher orders."},
      worst);
  testing::expect_verified({.quantity = "the same by the closed form of all modes: the static one, absolute over it",
                            .reference = "exact solution",
                            .source = "K^-1 F: e^(-beta omega^2 h/2) = e^-50 is left of the vibration",
                            .uncertainty = "rounding",
                            .tolerance = 1e-12,
                            .why = "Rounding times the condition of K, at most 1e3."},
                           moves);
}

}  // namespace
}  // namespace mb
