// Manufactured solutions of the dynamic reference, in space and time: a box held on all its faces moves by
//
//   u = f(x) sin(omega t),   b = rho u'' + alpha rho u' - div(sigma(u) + beta sigma(u'))
//
// f as in manufactured_test.h, b [N/m^3] the body force that keeps it so. Nothing is of unit size. Orders are fitted in
// the mesh at steps far finer, and in the step against the same mesh at steps far finer.
#include <gtest/gtest.h>

#include "mechanics/algebra/cholesky.h"
#include "mechanics/system/central_difference.h"
#include "mechanics/system/exact.h"
#include "mechanics/system/newmark.h"
#include "reference/manufactured_test.h"
#include "reference/static_answer.h"
#include "reference/sundials/sundials.h"

namespace mb {
namespace {

const Vector3d size(0.3, 0.2, 0.4);  // [m]
const Material stuff{7.1e5, 0.31, 1300};
const testing::Waves waves{{{1.2e-4, -0.9e-4, 2e-4}, {1, 1, 1}}, {{-0.4e-4, 0.6e-4, 0.5e-4}, {1, 1, 2}}};
const Rayleigh damping{3.7, 2.3e-4};
constexpr double omega = 87, end = 0.113;  // [rad/s] below the first mode, 300 1/s; [s] a period and a half

// div sigma of the linear field, [N/m^3]
Vector3d divergence(const testing::Field& f) {
  const double mu = shear_modulus(stuff), nu = stuff.poissons_ratio, lambda = 2 * mu * nu / (1 - 2 * nu);
  Vector3d sum = Vector3d::Zero();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const auto& second = f.second[static_cast<size_t>(j)];
      sum[i] += (lambda + mu) * second(i, j);
      sum[j] += mu * second(i, i);
    }
  return sum;
}

struct Manufactured {
  System system;
  SparseMatrix U;                                    // displacements at the rule's points
  VectorXd w, f;                                     // weights, the field there
  double error(const VectorXd& u, double t) const {  // relative, L2
    const VectorXd e = U * u - std::sin(omega * t) * f;
    return std::sqrt(e.cwiseAbs2().dot(w) / f.cwiseAbs2().dot(w));
  }
};

Manufactured on(const Resolution& mesh) {
  Scene scene = one_body(Box{size}, stuff, mesh);
  scene.bodies[0].damping = damping;
  for (const char* face : {"x-min", "x-max", "y-min", "y-max", "z-min", "z-max"})
    scene.bodies[0].supports.push_back(testing::support(Support::Kind::fixed, testing::face(face)));
  const auto model = full_model(scene, scene.bodies[0], mesh);
  const Quadrature rule = testing::rule_of(size, mesh);
  Manufactured all{model->system(), model->displacement_at(rule.points), {}, {}};
  all.w = rule.weights.replicate(1, 3).transpose().reshaped();
  all.f.resize(all.w.size());
  VectorXd stress(all.w.size());
  for (Index q = 0; q < rule.weights.size(); ++q) {
    const testing::Field field = testing::field(size, waves, rule.points.col(q));
    all.f.segment<3>(3 * q) = field.u;
    stress.segment<3>(3 * q) = -divergence(field);
  }
  System& s = all.system;
  const VectorXd inertia = stuff.density * (all.U.transpose() * all.w.cwiseProduct(all.f));
  const VectorXd elastic = all.U.transpose() * all.w.cwiseProduct(stress);
  s.F.resize(s.M.rows(), 2);
  s.F << elastic - omega * omega * inertia, omega * (damping.alpha * inertia + damping.beta * elastic);
  s.s = {Harmonic{omega}, Harmonic{.omega = omega, .phase = pi / 2}};
  // Starts in the mesh's own answer, f's projection by energy: no mode of the mesh rings.
  s.u0 = VectorXd::Zero(s.M.rows());
  s.v0 = omega * Cholesky(s.K).solve(elastic);
  return all;
}

VectorXd at_the_end(const Stepper& stepper) {
  const States states = stepper.run(VectorXd::Constant(1, end));
  EXPECT_EQ(states.status, Status::ok);
  return states.u.col(0);
}

TEST(ManufacturedVerification, ConvergesInSpaceAtFullOrder) {
  for (const auto& [degree, coarse] : {std::pair{1, std::vector{4, 4, 6}}, {2, {2, 2, 3}}, {3, {2, 1, 2}}}) {
    std::vector<int> fine = coarse;
    for (int& n : fine) n *= 2;
    const auto error = [&](const std::vector<int>& cells) {
      const Manufactured m = on({degree, cells});
      return m.error(at_the_end(*sundials(m.system, 1e-8, end)), end);
    };
    const double e_coarse = error(coarse), e_fine = error(fine);
    EXPECT_GT(std::log2(e_coarse / e_fine), degree + 1 - 0.2) << degree;  // not yet in the asymptotic range
    EXPECT_LT(e_fine, 0.1) << degree;
  }
}

// Order p of steps h, h/2 against steps far finer on the same mesh.
template <typename Make>
double order_in_time(const System& system, const VectorXd& truth, double h, Make make) {
  const auto error = [&](double step) { return (at_the_end(*make(system, step)) - truth).norm(); };
  return std::log2(error(h) / error(h / 2));
}

TEST(ManufacturedVerification, ConvergesInTimeAtTheOrderOfEveryScheme) {
  const Manufactured m = on({2, {2, 2, 3}});
  const VectorXd truth = at_the_end(*exact(m.system, end));
  const auto by_newmark = [](const System& s, double h) { return newmark(s, h); };
  const auto by_differences = [](const System& s, double h) { return central_difference(s, h); };
  EXPECT_NEAR(order_in_time(m.system, truth, end / 400, by_newmark), 2, 0.05);
  System lumped = m.system;  // what central differences step; their damping lags by half a step, which is of order 1
  lumped.M = lumped.lumped_mass;
  EXPECT_NEAR(order_in_time(m.system, at_the_end(*exact(lumped, end)), end / 800, by_differences), 1, 0.05);
  lumped.damping = {};
  System undamped = m.system;
  undamped.damping = {};
  EXPECT_NEAR(order_in_time(undamped, at_the_end(*exact(lumped, end)), end / 800, by_differences), 2, 0.05);
  // Adaptive: the error follows the tolerance.
  const auto error = [&](double rtol) { return (at_the_end(*sundials(m.system, rtol, end)) - truth).norm(); };
  const double loose = error(1e-4), tight = error(1e-7);
  EXPECT_LT(tight, 1e-5 * truth.norm());
  EXPECT_GT(std::log10(loose / tight), 2) << "three decades of tolerance";
}

// Two routes to one answer: closed form of all modes, adaptive Runge-Kutta, average acceleration extrapolated.
TEST(ManufacturedVerification, ThreeIntegratorsAgree) {
  const Manufactured m = on({2, {2, 2, 3}});
  const VectorXd closed = at_the_end(*exact(m.system, end));
  EXPECT_LT((at_the_end(*sundials(m.system, 1e-9, end)) - closed).norm(), 1e-6 * closed.norm());
  const VectorXd h = at_the_end(*newmark(m.system, end / 2000)), half = at_the_end(*newmark(m.system, end / 4000));
  EXPECT_LT(((4 * half - h) / 3 - closed).norm(), 1e-6 * closed.norm());  // Richardson: h^4 is left
}

}  // namespace
}  // namespace mb
