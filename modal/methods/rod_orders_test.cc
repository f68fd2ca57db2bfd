// How the error of a rod (nu = 0) in its r lowest modes falls as r grows. A load on one end drives every mode k alike,
// |f_k| = f, at omega_k = k pi c/L (the other end held: k - 1/2). A mode that is left out takes away, altogether and
// beyond its static part,
//
//   step     f (1 - cos omega_k t)/omega_k^2     and   -f cos omega_k t/omega_k^2
//   sin^2    f s/omega_k^2 + ...                 and   f (s''(0) cos omega_k t - s'')/omega_k^4 + ...
//
// The root of the sum of squares over k > r falls as r^-3/2 and r^-7/2 (M norm), times omega: r^-1/2 and r^-5/2 (K
// norm). At the loaded end all modes pull the same way: sums over omega^-2 and omega^-4, r^-1 and r^-3, but those of
// cosines alone, which cancel while no front passes: r^-2.
#include <gtest/gtest.h>

#include <cmath>

#include "cases/contract/linear.h"
#include "cases/exact/exact_test_table.h"
#include "cases/exact/rod_step.h"
#include "mechanics/algebra/worse_test.h"
#include "mechanics/system/exact.h"
#include "mechanics/verified_test.h"
#include "modal/methods/methods.h"

namespace mb {
namespace {

using testing::expect_verified;

constexpr Index n_all = 8192;                                                      // elastic modes of the whole rod
constexpr double L = 1.7, area = 0.03 * 0.02, E = 3e9, rho = 1200, tension = 6e5;  // [m], [m^2], [Pa], [kg/m^3], [Pa]
const double c = std::sqrt(E / rho), transit = L / c;                              // [m/s], [s]

// A rod in its exact modes, which its coordinates are: what lies between is the methods' own work. x [m] runs from the
// end that is held or free to the loaded one.
class ExactRod : public FullModel {
 public:
  explicit ExactRod(bool held) : held_(held), n_rigid_(held ? 0 : 1) {
    VectorXd omega = VectorXd::Zero(n_all + n_rigid_);
    for (Index k = 1; k <= n_all; ++k) omega[n_rigid_ + k - 1] = c * wave_number(k);
    system_.M = VectorXd::Ones(omega.size()).asDiagonal();
    system_.K = omega.cwiseAbs2().asDiagonal();
    system_.R = MatrixXd::Identity(omega.size(), n_rigid_);
    system_.F = area * tension * displacements(L);
    system_.s = {Step{}};
    system_.u0 = system_.v0 = VectorXd::Zero(omega.size());
  }
  const System& system() const override { return system_; }
  SparseMatrix displacement_at(const Matrix3Xd&) const override { return system_.M; }  // I
  SparseMatrix strain_at(const Matrix3Xd&) const override { return displacement_at({}); }
  MatrixXd polynomials(int) const override { throw std::logic_error("exact modes have no mesh"); }
  Index n_cells() const override { return 1; }
  double mesh_volume() const override { return area * L; }

  VectorXd displacements(double x) const {  // of all modes at x
    VectorXd phi(n_all + n_rigid_);
    if (!held_) phi[0] = std::sqrt(1 / (rho * area * L));
    for (Index k = 1; k <= n_all; ++k)
      phi[n_rigid_ + k - 1] =
          std::sqrt(2 / (rho * area * L)) * (held_ ? std::sin(wave_number(k) * x) : std::cos(wave_number(k) * x));
    return phi;
  }
  VectorXd strains(double x) const {
    VectorXd derivative = VectorXd::Zero(n_all + n_rigid_);
    for (Index k = 1; k <= n_all; ++k) {
      const double a = wave_number(k), slope = held_ ? std::cos(a * x) : -std::sin(a * x);
      derivative[n_rigid_ + k - 1] = std::sqrt(2 / (rho * area * L)) * a * slope;
    }
    return derivative;
  }

 private:
  double wave_number(Index k) const { return (static_cast<double>(k) - (held_ ? 0.5 : 0)) * pi / L; }  // [1/m] k >= 1

  bool held_;
  Index n_rigid_;
  System system_;
};

struct Rod {
  explicit Rod(bool is_held) : held(is_held), exact_rod(std::make_shared<const ExactRod>(is_held)) {
    auto scene = std::make_shared<Scene>();
    Body body;
    body.name = "rod";
    body.shape = Box{{0.03, 0.02, L}};
    body.material = {E, 0, rho};
    scene->bodies.push_back(std::move(body));
    model.scene = scene;
    model.bodies.push_back({exact_rod, {}, exact_rod->displacement_at({}), exact_rod->strain_at({})});
  }
  bool held;
  std::shared_ptr<const ExactRod> exact_rod;
  Model model;

  Reduction reduced(const Method& method, int n_modes) const {
    Reduction reduction = dynamic_cast<const LinearMethod&>(method).reduce(model, Settings{.modes = n_modes});
    EXPECT_EQ(reduction.modes_used, n_modes);
    return reduction;
  }
  States whole(const History& load, const VectorXd& t) const {
    System system = exact_rod->system();
    system.s = {load};
    return exact(system, t[t.size() - 1])->run(t);
  }
};

// Coordinates of the whole rod, n x n_t.
MatrixXd answer(Reduction reduction, const History& load, const VectorXd& t) {
  const Integrator closed_form{"exact", "closed form",
                               [](const System& system, const Settings&, double end) { return exact(system, end); }};
  reduction.bodies.at(0).system.s = {load};
  const auto shared = std::make_shared<const Reduction>(std::move(reduction));
  const auto prepared = prepare_linear(shared, closed_form, {}, t[t.size() - 1]);
  return prepared->simulate({.t = t, .strain = false}).bodies.at(0).displacement;
}

// Two passes of the front, which is at the loaded end at 0, 2 and 4 L/c and is not looked at there.
VectorXd between_fronts() {
  VectorXd t(200);
  t << VectorXd::LinSpaced(100, 0.25, 1.75), VectorXd::LinSpaced(100, 2.25, 3.75);
  return t * transit;
}

// Relative errors over all times: in the M norm, in the K norm, at the loaded end.
Vector3d errors(const Rod& rod, const MatrixXd& u, const MatrixXd& truth) {
  const VectorXd omega = rod.exact_rod->system().K.diagonal().cwiseSqrt(), end = rod.exact_rod->displacements(L);
  const MatrixXd e = u - truth;
  return {e.norm() / truth.norm(), (omega.asDiagonal() * e).norm() / (omega.asDiagonal() * truth).norm(),
          (end.transpose() * e).norm() / (end.transpose() * truth).norm()};
}

// Errors, 3 x 5, with r = 8 ... 128 modes.
const Eigen::Array<int, 5, 1> numbers_of_modes(8, 16, 32, 64, 128);
MatrixXd errors(const Rod& rod, const Method& method, const History& load) {
  const VectorXd t = between_fronts();
  const MatrixXd truth = rod.whole(load, t).u;
  MatrixXd result(3, 5);
  for (Index i = 0; i < 5; ++i)
    result.col(i) = errors(rod, answer(rod.reduced(method, numbers_of_modes[i]), load, t), truth);
  return result;
}

// Least squares through log(error) over log(omega), omega in the middle of the gap where the series is cut: from there
// on the sum is its integral but for some (omega_1/omega)^2 of it.
Vector3d orders(const Rod& rod, const MatrixXd& errors) {
  const Eigen::ArrayXd cut = (numbers_of_modes.cast<double>() + (rod.held ? 0 : 0.5)).log(), x = cut - cut.mean();
  return -(errors.array().log().matrix() * x.matrix()) / x.square().sum();
}

// 0.01: the whole rod ends at n_all, which is 1/64 of the slowest sum, K^2, at r = 128. 0.06: the sum at the end swings
// with the phase of mode r + 1 at each of the times. Distance of the orders in the two norms.
double expect_orders(const Rod& rod, const MatrixXd& errors, const Vector3d& expected) {
  const Vector3d observed = orders(rod, errors);
  EXPECT_NEAR(observed[0], expected[0], 0.01) << "M norm, held " << rod.held;
  EXPECT_NEAR(observed[1], expected[1], 0.01) << "K norm, held " << rod.held;
  EXPECT_NEAR(observed[2], expected[2], 0.06) << "loaded end, held " << rod.held;
  return (observed - expected).head<2>().cwiseAbs().maxCoeff();
}

void expect_verified_orders(const std::string& load, const std::string& orders, double worst) {
  expect_verified(
      {.quantity = fmt::format("distance from {} of the orders in which errors of 8 to 128 modes of a rod under "
                               "{} fall, in the M and K norms, the worst",
                               orders, load),
       .reference = "exact solution",
       .source = "sums over the modes left out, each an oscillator in closed form",
       .uncertainty = "none in the limit of many modes",
       .tolerance = 0.01,
       .why = "The whole rod has 8192 modes: its missing tail is 1/64 of the slowest sum at 128 modes and "
              "turns that order by a few thousandths."},
      worst);
}

TEST(RodModesVerification, OrdersUnderAStep) {
  double worst = 0;
  for (const bool held : {true, false}) {
    const Rod rod(held);
    const MatrixXd plain = errors(rod, *eigenmodes(), Step{}), corrected = errors(rod, *static_correction(), Step{});
    worst = worse({worst, expect_orders(rod, plain, {1.5, 0.5, 1}), expect_orders(rod, corrected, {1.5, 0.5, 2})});
    // Over time (1 - cos)^2 is 3/2 in the mean, cos^2 1/2; the few times and modes leave 1 %.
    for (Index i = 0; i < 5; ++i)
      for (Index norm = 0; norm < 2; ++norm)
        EXPECT_NEAR(plain(norm, i) / corrected(norm, i), std::sqrt(3), 0.02 * std::sqrt(3)) << held << norm << i;
  }
  expect_verified_orders("a step", "1.5 and 0.5, statically corrected or not,", worst);
}

// As long as a round trip, so that the free oscillations from both ends of the pulse meet alike in every mode; else the
// sums over omega^-8, of which the first terms are most, scatter, and the orders by 0.05.
TEST(RodModesVerification, OrdersUnderASmoothPulse) {
  const Pulse pulse{2 * transit};
  double worst = 0;
  for (const bool held : {true, false}) {
    const Rod rod(held);
    worst = worse({worst, expect_orders(rod, errors(rod, *eigenmodes(), pulse), {1.5, 0.5, 1}),
                   expect_orders(rod, errors(rod, *static_correction(), pulse), {3.5, 2.5, 3})});
  }
  expect_verified_orders("a sin^2 pulse", "1.5 and 0.5, statically corrected 3.5 and 2.5,", worst);
}

// What is called the truth above. The tail of sum 2 (1 - cos)/(k pi)^2 is below 4/(pi^2 n_all), of the static stretch.
TEST(RodModesVerification, AllModesAreDAlembertsWaves) {
  const VectorXd t = between_fronts();
  const double stretch = tension / E * L, tolerance = 4.04 / (pi * pi * n_all);
  double worst = 0;
  for (const bool held : {true, false}) {
    const Rod rod(held);
    const VectorXd u = rod.whole(Step{}, t).u.transpose() * rod.exact_rod->displacements(L);
    for (Index j = 0; j < t.size(); ++j) {
      const double expected = rod_state({L, E, rho, tension, held}, L, t[j]).u;
      EXPECT_NEAR(u[j], expected, tolerance * stretch);
      worst = worse(worst, std::abs(u[j] - expected) / stretch);
    }
  }
  expect_verified(
      {.quantity = "displacement of the loaded end of a held and a free rod under a step, 8192 modes, over the "
                   "static stretch",
       .reference = "exact solution",
       .source = "d'Alembert's waves, Graff 1975, Wave Motion in Elastic Solids, sect. 2.3",
       .uncertainty = "rounding",
       .tolerance = tolerance,
       .why = "The bound of the modes left out, a sum of 2 (1 - cos)/(k pi)^2 over k > 8192, and 1 % for wave "
              "numbers at half-integers."},
      worst);
}

// rod_step_load.csv: 8 and 32 modes at the loaded end, twelve digits.
TEST(RodModesVerification, TruncatedSeriesOfTheTable) {
  const auto table = numbers("rod_step_load.csv");
  ASSERT_EQ(table.size(), 81u);
  VectorXd t(81);
  for (Index j = 0; j < 81; ++j) t[j] = table[static_cast<size_t>(j)][0] * transit;
  double worst = 0;
  for (const bool held : {true, false}) {
    const Rod rod(held);
    for (const int r : {8, 32}) {
      const MatrixXd u = answer(rod.reduced(*eigenmodes(), r), Step{}, t);
      const VectorXd end = u.transpose() * rod.exact_rod->displacements(L) / (tension / E * L);
      const size_t column = (held ? 3 : 9) + (r == 8 ? 0 : 1);
      for (Index j = 0; j < 81; ++j) {
        const double expected = table[static_cast<size_t>(j)][column];
        EXPECT_NEAR(end[j], expected, 1e-10) << held << " " << r << " " << t[j];
        worst = worse(worst, std::abs(end[j] - expected));
      }
    }
  }
  expect_verified(
      {.quantity = "displacement of the loaded end of a held and a free rod under a step, 8 and 32 modes, over "
                   "the static stretch",
       .reference = "table",
       .source = "truncated series by another program: rod_step_load.csv",
       .uncertainty = "5e-13, twelve printed decimals",
       .tolerance = 1e-10,
       .why = "Twelve decimals of values up to 32, and rounding of phases up to 800 at scaled times; a hundred "
              "times that is room."},
      worst);
}

// Highest strain (in space) and velocity (in time) behind a front in the middle of the rod, over the jumps that make
// it, tension/E and tension/(rho c). They are half a wave of the last mode away.
Eigen::Vector2d peaks(const Rod& rod, int n_modes) {
  const LinearBody body = rod.reduced(*eigenmodes(), n_modes).bodies.at(0);
  const MatrixXd& Phi = std::get<MatrixXd>(body.displacement.of_state);
  const VectorXd behind = VectorXd::LinSpaced(201, 0, 2.0 / n_modes);  // [-] of L and L/c
  const States states = exact(body.system, transit)->run((0.5 + behind.array()) * transit);
  const VectorXd v = (Phi * states.v).transpose() * rod.exact_rod->displacements(L / 2), u = Phi * states.u.col(0);
  double strain = 0;
  for (const double distance : behind) strain = std::max(strain, u.dot(rod.exact_rod->strains((0.5 + distance) * L)));
  return {strain / (tension / E), v.maxCoeff() / (tension / (rho * c))};
}

// Gibbs: the overshoot is Si(pi)/pi - 1/2 of the jump, 8.949 %, however many modes. The other fronts and the static
// strain add ripples there, at most 1/(pi r) of the jump.
TEST(RodModesVerification, StrainAndVelocityOvershootAtAFront) {
  for (const bool held : {true, false}) {
    const Rod rod(held);
    for (const int r : {32, 64, 128}) {
      const Eigen::Vector2d overshoot = peaks(rod, r).array() - 1;
      EXPECT_NEAR(overshoot[0], 0.0894898722, 1.1 / (pi * r)) << "strain, held " << held << ", " << r << " modes";
      EXPECT_NEAR(overshoot[1], 0.0894898722, 1.1 / (pi * r)) << "velocity, held " << held << ", " << r << " modes";
    }
  }
}

}  // namespace
}  // namespace mb
