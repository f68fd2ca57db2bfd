#include <gtest/gtest.h>

#include "modal/bases/eigenmodes.h"
#include "modal/bases/ritz_modes.h"
#include "modal/methods/methods.h"
#include "modal/methods/whole_body_test.h"

namespace mb {
namespace {

using testing::beam;
using testing::beam_model;
using testing::beam_shift;
using testing::beam_times;

std::unique_ptr<Method> polynomials(int degree) { return degree == 1 ? linear_strain() : quadratic_strain(); }

// The same Galerkin projection in the monomials themselves, integrated by the dense closed form.
MatrixXd in_monomials(const System& body, const MatrixXd& Y) {
  System reduced;
  reduced.M = MatrixXd(Y.transpose() * (body.M * Y)).sparseView();
  reduced.K = MatrixXd(Y.transpose() * (body.K * Y)).sparseView();
  reduced.damping = body.damping;
  const MatrixXd gram = Y.transpose() * (body.M * Y);
  reduced.R = MatrixXd(Y.cols(), body.R.cols());
  if (body.R.cols() > 0) reduced.R = gram.llt().solve(Y.transpose() * (body.M * body.R));
  reduced.F = Y.transpose() * body.F;
  reduced.s = body.s;
  reduced.u0 = gram.llt().solve(Y.transpose() * (body.M * body.u0));
  reduced.v0 = gram.llt().solve(Y.transpose() * (body.M * body.v0));
  return Y * exact(reduced, testing::beam_duration)->run(beam_times()).u;
}

TEST(PolynomialMethods, AreGalerkinProjections) {
  for (const bool clamped : {false, true}) {
    const System body = beam(clamped).system;
    const Model model = beam_model(clamped);
    for (const int degree : {1, 2}) {
      const MatrixXd expected = in_monomials(body, model.bodies[0].full->polynomials(degree));
      const Trajectory answer = testing::simulate(*polynomials(degree), model, 0, {.t = beam_times()});
      ASSERT_EQ(answer.status, Status::ok);
      EXPECT_LT(testing::error(body, answer.bodies.at(0).displacement, expected), 1e-9) << clamped << degree;
    }
  }
}

TEST(PolynomialMethods, HaveSixAndTwentyFourElasticFunctionsOfAFreeBody) {
  const Model model = beam_model(false);
  for (const auto& [degree, n_elastic] : {std::pair{1, 6}, {2, 24}}) {
    const auto prepared = polynomials(degree)->prepare(model, {}, testing::closed_form);
    EXPECT_EQ(prepared->modes_used(), n_elastic);
    EXPECT_EQ(prepared->n_unknowns(), 6 + n_elastic);
  }
  EXPECT_EQ(linear_strain()->name(), "linear");
  EXPECT_EQ(quadratic_strain()->name(), "quadratic");
  EXPECT_FALSE(linear_strain()->takes_modes());
  EXPECT_EQ(linear_strain()->prepare(beam_model(true), {}, testing::closed_form)->modes_used(), 3);
}

// Min-max: frequencies within a subspace are never too low, and fall as it grows.
TEST(RitzModes, ApproachFromAbove) {
  for (const bool clamped : {false, true}) {
    const System body = beam(clamped).system;
    const auto full = beam_model(clamped).bodies[0].full;
    const Modes linear = ritz_modes(body, full->polynomials(1)), quadratic = ritz_modes(body, full->polynomials(2));
    const Modes modes = lowest_modes(body, 24, beam_shift);
    ASSERT_EQ(linear.n_rigid, clamped ? 0 : 6);
    for (Index i = linear.n_rigid; i < linear.size(); ++i) EXPECT_LE(quadratic.omega(i), linear.omega(i));
    for (Index i = linear.n_rigid; i < std::min(quadratic.size(), modes.size()); ++i)
      EXPECT_GE(quadratic.omega(i), modes.omega(i) * (1 - 1e-12));
    const MatrixXd gram = quadratic.Phi.transpose() * (body.M * quadratic.Phi);
    EXPECT_LT((gram - MatrixXd::Identity(gram.rows(), gram.cols())).cwiseAbs().maxCoeff(), 1e-11);
    EXPECT_EQ(quadratic.Phi.leftCols(quadratic.n_rigid), body.R);
  }
}

TEST(RitzModes, DoNotDependOnTheScaleOrMixtureOfTheFunctions) {
  const System body = beam(false).system;
  const MatrixXd Y = beam_model(false).bodies[0].full->polynomials(2);
  const Modes modes = ritz_modes(body, Y);
  const VectorXd scale = VectorXd::LinSpaced(Y.cols(), -5, 5).array().exp() * 1e3;
  const Modes other = ritz_modes(body, Y.rowwise().reverse() * scale.asDiagonal());
  EXPECT_LT(((other.omega - modes.omega).array() / modes.omega.maxCoeff()).abs().maxCoeff(), 1e-10);
}

TEST(RitzModes, OfRigidMotionsAloneAreRigid) {
  const System body = beam(false).system;
  const Modes modes = ritz_modes(body, body.R);
  EXPECT_EQ(modes.size(), 6);
  EXPECT_EQ(modes.n_rigid, 6);
}

TEST(RitzModes, RefuseBadInput) {
  const System body = beam(false).system;
  const MatrixXd Y = beam_model(false).bodies[0].full->polynomials(1);
  EXPECT_THROW(ritz_modes(body, Y.topRows(7)), std::invalid_argument);
  EXPECT_THROW(ritz_modes(body, Y.leftCols(5)), std::invalid_argument);
  EXPECT_THROW(ritz_modes(body, NAN * Y), std::invalid_argument);
  MatrixXd twice(Y.rows(), Y.cols() + 1);
  twice << Y, Y.col(4);
  EXPECT_THROW(ritz_modes(body, twice), std::runtime_error);
  EXPECT_THROW(ritz_modes(body, Y.rightCols(9)), std::runtime_error);  // a rigid motion is missing
}

}  // namespace
}  // namespace mb
