#include <gtest/gtest.h>

#include "cases/contract/linear.h"
#include "mechanics/verified_test.h"
#include "modal/bases/eigenmodes.h"
#include "modal/bases/ritz_modes.h"
#include "modal/bases/verification_test.h"
#include "modal/methods/methods.h"
#include "modal/methods/whole_body_test.h"

namespace mb {
namespace {

using testing::beam;
using testing::beam_model;
using testing::beam_shift;
using testing::beam_times;
using testing::expect_verified;

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

// omega^2 of the elastic modes which the method has for a free sphere.
VectorXd eigenvalues_of_sphere(const Method& method, const Resolution& resolution) {
  auto scene = std::make_shared<Scene>(one_body(Sphere{testing::radius}, testing::steel, resolution));
  const std::shared_ptr<const FullModel> full = full_model(*scene, scene->bodies[0], resolution);
  const Matrix3Xd centre = Matrix3Xd::Zero(3, 1);
  Model model;
  model.scene = scene;
  model.bodies.push_back({full, {}, full->displacement_at(centre), full->strain_at(centre)});
  const System reduced = dynamic_cast<const LinearMethod&>(method).reduce(model, {}).bodies.at(0).system;
  EXPECT_EQ(reduced.R.cols(), 6);
  return reduced.K.diagonal().tail(reduced.K.rows() - 6);
}

// A free sphere with u = A x, A symmetric: 2 U = (2 mu A:A or, of A = 1, 9 K) V, 2 T = A:A omega^2 rho V a^2/5. Hence
// omega^2 = 10 mu/(rho a^2) five times and 15 K/(rho a^2). A mesh of the sphere has a slightly smaller mean square of
// x, for both alike: by O(h^2p), the volume between the sphere and its interpolation at Lobatto's points. Seen 1.2e-3
// and 7.7e-5 (p = 2), 1.15e-7 (p = 4).
TEST(PolynomialMethodsVerification, LinearStrainOfASphere) {
  const Material& m = testing::steel;
  const double rho_a2 = m.density * testing::radius * testing::radius;
  const double mu = m.youngs_modulus / (2 * (1 + m.poissons_ratio));
  const double K = m.youngs_modulus / (3 * (1 - 2 * m.poissons_ratio));
  ASSERT_LT(10 * mu, 15 * K);  // ascending
  const VectorXd expected = (VectorXd(6) << VectorXd::Constant(5, 10 * mu), 15 * K).finished() / rho_a2;
  const auto errors = [&](const Resolution& resolution) -> VectorXd {
    return eigenvalues_of_sphere(*linear_strain(), resolution).cwiseQuotient(expected).array() - 1;
  };
  for (const Resolution& resolution : {Resolution{2, {2}}, {2, {4}}, {4, {2}}}) {
    const VectorXd error = errors(resolution);
    ASSERT_EQ(error.size(), 6);
    EXPECT_GT(error.minCoeff(), 0);
    EXPECT_LT(error.maxCoeff() - error.minCoeff(), 1e-11);  // rounding: a cube's symmetries spare isotropy
  }
  EXPECT_NEAR(std::log2(errors({2, {2}})[0] / errors({2, {4}})[0]), 4, 0.05);
  expect_verified(
      {.quantity = "squared frequencies of a free sphere whose strain is uniform, quartic cells, relative, the "
                   "worst of six",
       .reference = "exact solution",
       .source = "energies of u = A x, A symmetric: 10 mu/(rho a^2) five times and 15 K/(rho a^2)",
       .uncertainty = "rounding",
       .tolerance = 2e-7,
       .why = "The mesh's mean square of x is smaller by what lies between the sphere and its interpolation, "
              "1.15e-7 as seen; its order is tested, too."},
      testing::largest(errors({4, {2}})));
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
