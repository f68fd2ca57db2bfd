#include "mechanics/system/exact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "mechanics/system/exact_test_systems.h"
#include "mechanics/system/modal_form.h"

namespace mb {
namespace {

// Runge-Kutta, fourth order, in small steps that end at every breakpoint; loads are taken from the left at a step's
// end.
MatrixXd runge_kutta(const System& system, const VectorXd& times) {
  std::vector<double> stops(times.data(), times.data() + times.size());
  for (const auto& history : system.s)
    for (double t : breakpoints(history, times.maxCoeff())) stops.push_back(t);
  std::sort(stops.begin(), stops.end());
  const Eigen::LLT<MatrixXd> M{MatrixXd(system.M)};
  const Index n = system.M.rows();
  VectorXd state(2 * n);
  state << system.u0, system.v0;
  const auto rate = [&](double t, const VectorXd& x) {
    const VectorXd u = x.head(n), v = x.tail(n);
    VectorXd result(2 * n);
    result << v, M.solve(system.F * LoadFactors(system)(t) - apply_damping(system, v) - system.K * u);
    return result;
  };
  MatrixXd states(2 * n, times.size());
  double t = 0;
  Index next = 0;
  for (const double stop : stops) {
    const int n_steps = static_cast<int>(std::ceil((stop - t) / 1e-3));
    const double h = n_steps > 0 ? (stop - t) / n_steps : 0;
    for (int i = 0; i < n_steps; ++i) {
      const double start = t + i * h, end = std::nextafter(i + 1 < n_steps ? start + h : stop, 0);
      const VectorXd k1 = rate(start, state), k2 = rate(start + h / 2, state + h / 2 * k1);
      const VectorXd k3 = rate(start + h / 2, state + h / 2 * k2), k4 = rate(end, state + h * k3);
      state += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
    t = stop;
    while (next < times.size() && times[next] == stop) states.col(next++) = state;
  }
  return states;
}

double distance(const States& states, const MatrixXd& reference) {  // relative, displacement and velocity
  const Index n = states.u.rows();
  return std::max((states.u - reference.topRows(n)).norm() / reference.topRows(n).norm(),
                  (states.v - reference.bottomRows(n)).norm() / reference.bottomRows(n).norm());
}

double distance(const States& a, const States& b) {
  MatrixXd reference(2 * b.u.rows(), b.u.cols());
  reference << b.u, b.v;
  return distance(a, reference);
}

TEST(ExactTest, MatchesRungeKutta) {
  const VectorXd times = equally_spaced(2.5, 41);
  for (const System& system :
       {supported(all_exact_loads()), supported({}), free_chain(all_exact_loads()), free_chain({}),
        diagonal(all_exact_loads()), braked(all_exact_loads()), braked(all_exact_loads(), 300)}) {
    const States states = exact(system, 2.5)->run(times);
    EXPECT_EQ(states.status, Status::ok);
    EXPECT_EQ(states.n_valid, times.size());
    EXPECT_LT(distance(states, runge_kutta(system, times)), 1e-9);  // (omega h)^4 omega t/120, omega h <= 0.02
  }
}

TEST(ExactTest, ResampledLoadsKeepTheirTolerance) {
  const VectorXd times = equally_spaced(2, 21);
  const System system = supported({Chirp{1, 12, 1.5, 2, 0.25}, Expression{"t < 1 ? sin(4*t) : exp(-t)"}});
  System stopped = system;  // the jump at 1 s, told to Runge-Kutta by a load that does nothing
  stopped.s.push_back(Step{1, 1});
  stopped.F.conservativeResize(Eigen::NoChange, 3);
  stopped.F.col(2).setZero();
  const MatrixXd reference = runge_kutta(stopped, times);
  const double coarse = distance(exact(system, 2, 1e-3)->run(times), reference);
  const double fine = distance(exact(system, 2, 1e-7)->run(times), reference);
  EXPECT_LT(coarse, 2e-3);
  EXPECT_LT(fine, 2e-7);
  EXPECT_LT(fine, coarse / 100);
}

// Equal steps repeat one transition; single times are evaluated from the start of their piece.
TEST(ExactTest, EqualStepsEqualSingleTimes) {
  for (const System& system : {supported(all_exact_loads()), free_chain(all_exact_loads()), diagonal(all_exact_loads()),
                               braked(all_exact_loads())}) {
    const auto stepper = exact(system, 30);
    const VectorXd times = equally_spaced(30, 1801);
    const States together = stepper->run(times);
    States alone = together;
    for (Index j = 0; j < times.size(); ++j) {
      const States one = stepper->run(times.segment(j, 1));
      alone.u.col(j) = one.u;
      alone.v.col(j) = one.v;
    }
    EXPECT_LT(distance(together, alone), 1e-12);
  }
}

TEST(ExactTest, LoadsSuperpose) {
  const VectorXd times = equally_spaced(2, 33);
  System system = free_chain(all_exact_loads());
  const States all = exact(system, 2)->run(times);
  States sum = all;
  System free_motion = system;
  free_motion.F.resize(5, 0);
  free_motion.s.clear();
  const States start = exact(free_motion, 2)->run(times);
  sum.u = start.u, sum.v = start.v;
  system.u0.setZero(), system.v0.setZero();
  for (Index l = 0; l < system.F.cols(); ++l) {
    System single = system;
    single.F = system.F.col(l);
    single.s = {system.s[static_cast<std::size_t>(l)]};
    const States part = exact(single, 2)->run(times);
    sum.u += part.u, sum.v += part.v;
  }
  EXPECT_LT(distance(sum, all), 1e-13);
}

TEST(ExactTest, DiagonalAndDenseRoutesAgree) {
  const System system = diagonal(all_exact_loads());
  System heavier = system;  // twice of everything: the same motion through the eigenproblem
  heavier.M *= 2;
  heavier.K *= 2;
  heavier.F *= 2;
  heavier.R /= std::sqrt(2.0);
  EXPECT_EQ(modal_form(system).Phi.size(), 0);
  EXPECT_EQ(modal_form(heavier).Phi.size(), 16);
  const VectorXd times = equally_spaced(3, 50);
  EXPECT_LT(distance(exact(heavier, 3)->run(times), exact(system, 3)->run(times)), 1e-12);
}

TEST(ExactTest, UndampedFreeMotionKeepsItsEnergy) {
  for (const System& system : {supported({}, {}), free_chain({}, {})}) {
    const States states = exact(system, 100)->run(equally_spaced(100, 500));
    const double first = kinetic_energy(system, system.v0) + strain_energy(system, system.u0);
    for (Index j = 0; j < 500; ++j)  // omega t = 600: the phase of the eigenvalues' rounding does not enter
      EXPECT_NEAR(kinetic_energy(system, states.v.col(j)) + strain_energy(system, states.u.col(j)), first,
                  1e-12 * first);
  }
}

TEST(ExactTest, RigidMotionIsNotDamped) {
  System system = free_chain({Step{2, 0.5}}, {3, 0.1});
  const double duration = 4, momentum0 = (system.M * system.v0).sum();
  const States states = exact(system, duration)->run(VectorXd::Constant(1, duration));
  const double impulse = 2 * (duration - 0.5) * system.F.sum();
  EXPECT_NEAR((system.M * states.v).sum(), momentum0 + impulse, 1e-12 * (std::abs(momentum0) + std::abs(impulse)));
}

TEST(ExactTest, ModalFormDiagonalises) {
  const System system = free_chain({});
  const ModalForm form = modal_form(system);
  const MatrixXd unit = form.Phi.transpose() * (system.M * form.Phi), K = form.Phi.transpose() * (system.K * form.Phi);
  EXPECT_LT((unit - MatrixXd::Identity(5, 5)).norm(), 1e-13);
  EXPECT_LT((K - MatrixXd(form.lambda.asDiagonal())).norm(), 1e-13 * K.norm());
  MatrixXd C(5, 5);
  for (Index i = 0; i < 5; ++i) C.col(i) = form.Phi.transpose() * apply_damping(system, form.Phi.col(i));
  EXPECT_LT((C - MatrixXd(form.c.asDiagonal())).norm(), 1e-13 * C.norm());
  EXPECT_EQ(form.lambda[0], 0);
  EXPECT_EQ(form.c[0], 0);
}

TEST(ExactTest, WorkIsCounted) {
  const System system = diagonal({Step{1, 0.5}});
  const States states = exact(system, 2)->run(equally_spaced(2, 9));
  EXPECT_EQ(states.work.steps, 4 * (9 + 1));  // nine outputs and one piece passed
  EXPECT_EQ(states.work.load_evaluations, 2);
  EXPECT_EQ(exact(system, 2)->run(VectorXd()).u.cols(), 0);
  const System nothing{SparseMatrix(0, 0), SparseMatrix(0, 0), {}, {},         {},
                       MatrixXd(0, 0),     MatrixXd(0, 0),     {}, VectorXd(), VectorXd()};
  EXPECT_EQ(exact(nothing, 1)->run(equally_spaced(1, 3)).n_valid, 3);  // r = 0 of a supported body
}

TEST(ExactTest, FailureIsAStatus) {
  System system = diagonal({});
  system.v0[0] = std::numeric_limits<double>::max();
  system.v0[1] = std::numeric_limits<double>::infinity();
  const States states = exact(system, 1)->run(equally_spaced(1, 5));
  EXPECT_EQ(states.status, Status::not_finite);
  EXPECT_EQ(states.n_valid, 0);
  EXPECT_TRUE(states.u.array().isNaN().all() && states.v.array().isNaN().all());
}

TEST(ExactTest, BadInput) {
  const System good = free_chain({Step{}});
  const auto fails = [&](auto change) {
    System system = good;
    change(system);
    EXPECT_THROW(exact(system, 1), std::invalid_argument);
  };
  fails([](System& system) { system.u0.resize(4); });
  fails([](System& system) { system.s.clear(); });
  fails([](System& system) { system.R.resize(4, 1); });
  fails([](System& system) { system.M *= -1; });
  fails([](System& system) { system.s = {Pulse{-1}}; });
  fails([](System& system) { system.damping.alpha = -10; });
  for (const double duration : {0.0, -1.0, std::nan("")}) {
    EXPECT_THROW(exact(good, duration), std::invalid_argument);
    EXPECT_THROW(exact(supported({}), duration), std::invalid_argument);
  }
  const auto stepper = exact(good, 1);
  for (const auto& times : {Eigen::Vector2d(0.5, 0.4), Eigen::Vector2d(-0.1, 0.4), Eigen::Vector2d(0, 1.1),
                            Eigen::Vector2d(0, std::nan(""))})
    EXPECT_THROW(stepper->run(times), std::invalid_argument);
}

TEST(ExactTest, RigidModesMustBeAsStated) {
  System system = free_chain({});
  system.R.resize(5, 0);
  EXPECT_THROW(exact(system, 1), std::runtime_error);  // one zero eigenvalue, none stated
  system = supported({});
  system.R = MatrixXd::Constant(4, 1, 0.5);
  EXPECT_THROW(exact(system, 1), std::runtime_error);  // one stated, none there
  system = diagonal({});
  system.R.conservativeResize(Eigen::NoChange, 1);
  EXPECT_THROW(exact(system, 1), std::runtime_error);
  system = supported({});
  system.K *= -1;
  EXPECT_THROW(exact(system, 1), std::runtime_error);  // not semi-definite
}

}  // namespace
}  // namespace mb
