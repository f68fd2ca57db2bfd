#include "reference/sundials.h"

#include <arkode/arkode_arkstep.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_nonlinearsolver.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

#include "mechanics/system/shifted.h"
#include "mechanics/system/symmetric_product.h"
#include "mechanics/system/unbalanced_force.h"

namespace mb {

namespace {

using Vector = Eigen::Map<VectorXd>;
constexpr long max_steps = 2'000'000;
constexpr double longest_step = 0.25;         // [-] of the duration
constexpr double expression_resolved = 0.01;  // [-] of its peak

struct Scales {
  double displacement, velocity;
};  // [m], [m/s], both > 0

// Sizes that the motion can reach, in the M norm per root mass: with T the duration, the initial state and the
// responses to each load at its peak and to the initial velocity of  (K + M/T^2) x = F max|s|, by M + T^2 K.
Scales motion_scales(const System& system, double duration, const Shifted& shifted) {
  const double mass = system.M.sum() / 3;  // the body's where it is free; a scale is all that is needed
  const auto norm = [&](const SparseMatrix& A, const VectorXd& x) {  // of a nearly rigid x rounding may fall below 0
    const double square = x.dot(A * x) / mass;
    return std::isfinite(square) ? std::sqrt(std::max(0.0, square)) : square;
  };
  VectorXd x = VectorXd::Zero(system.u0.size());
  Scales scale{norm(system.M, system.u0), norm(system.M, system.v0) + norm(system.K, system.u0)};
  for (Index l = 0; l < system.F.cols(); ++l) {
    shifted.solve(system.F.col(l) * (duration * duration * peak(system.s[static_cast<size_t>(l)], duration)), x);
    scale.displacement += norm(system.M, x);
    scale.velocity += norm(system.K, x) + norm(system.M, x) / duration;
  }
  shifted.solve(system.M * system.v0, x);
  scale.displacement += std::sqrt(std::max(0.0, system.v0.dot(system.M * x) / mass)) * duration;
  if (!std::isfinite(scale.displacement) || !std::isfinite(scale.velocity))
    throw std::runtime_error("sundials: loads or initial state not finite");
  return {scale.displacement > 0 ? scale.displacement : 1, scale.velocity > 0 ? scale.velocity : 1};  // 1: at rest
}

// The parts that last: made once, used by every run.
struct Parts {
  Parts(const System& system, double duration)
      : force(system, UnbalancedForce::Mass::consistent), mass(system.M), M(system.M), A(system, duration) {}
  UnbalancedForce force;
  SpdFactor mass;
  SymmetricProduct M;
  Shifted A;  // M + gamma C + gamma^2 K
};

// What one run needs at every callback. ARKODE sees it as user data and as the stage solver's content.
struct Problem {
  Problem(Index n_, Parts& parts_) : parts(parts_), n(n_), b(n_), u(n_), v(n_) {}

  Parts& parts;
  Index n;
  VectorXd b, u, v;
  void* arkode = nullptr;
  double before = 0;  // [s] next breakpoint: loads are taken from its left
  Work work;

  double load_time(double t) const { return std::min(t, std::nextafter(before, 0.0)); }
};

int right_hand_side(realtype t, N_Vector y, N_Vector ydot, void* data) {
  Problem& p = *static_cast<Problem*>(data);
  p.u = Vector(NV_DATA_S(y), p.n);
  p.v = Vector(NV_DATA_S(y) + p.n, p.n);
  Vector(NV_DATA_S(ydot), p.n) = p.v;
  p.parts.force(p.load_time(t), p.u, p.v, p.b);
  p.parts.mass.solve(p.b.data(), NV_DATA_S(ydot) + p.n);
  ++p.work.load_evaluations;
  ++p.work.solves;
  return 0;
}

// One implicit stage z = a + gamma f(z), linear in z, without forming f:
//   (M + gamma C + gamma^2 K) v = M a_v + gamma (F s - K a_u),   u = a_u + gamma v
int solve_stage(SUNNonlinearSolver solver, N_Vector, N_Vector correction, N_Vector, realtype, booleantype, void*) {
  Problem& p = *static_cast<Problem*>(solver->content);
  realtype t, gamma;
  N_Vector predicted, z, Fi, data;
  void* user;
  if (ARKStepGetNonlinearSystemData(p.arkode, &t, &predicted, &z, &Fi, &gamma, &data, &user) != ARK_SUCCESS) return -1;
  Shifted& A = p.parts.A;
  if (std::abs(gamma / A.gamma() - 1) > 1e-12) {  // ARKODE recomputes an unchanged gamma with rounding
    A.set_gamma(gamma);
    ++p.work.factorisations;
  }
  const Vector predicted_u(NV_DATA_S(predicted), p.n), data_u(NV_DATA_S(data), p.n),
      predicted_v(NV_DATA_S(predicted) + p.n, p.n), data_v(NV_DATA_S(data) + p.n, p.n);
  p.u = predicted_u + data_u;
  p.parts.force.without_damping(p.load_time(t), p.u, p.b);
  ++p.work.load_evaluations;
  p.v = predicted_v + data_v;
  p.parts.M(p.v, p.u);
  p.b = gamma * p.b + p.u;
  A.solve(p.b, p.v);
  ++p.work.solves;
  if (!std::isfinite(p.v.sum())) return -1;
  Vector(NV_DATA_S(correction), p.n) = data_u + gamma * p.v;
  Vector(NV_DATA_S(correction) + p.n, p.n) = p.v - predicted_v;
  return SUN_NLS_SUCCESS;
}

SUNNonlinearSolver_Type root_finding(SUNNonlinearSolver) { return SUNNONLINEARSOLVER_ROOTFIND; }
int accept_function(SUNNonlinearSolver, SUNNonlinSolSysFn) { return SUN_NLS_SUCCESS; }

struct Free {
  void operator()(SUNContext c) const { SUNContext_Free(&c); }
  void operator()(N_Vector v) const { N_VDestroy(v); }
  void operator()(SUNNonlinearSolver s) const { SUNNonlinSolFreeEmpty(s); }
};
template <class T>
using Owned = std::unique_ptr<std::remove_pointer_t<T>, Free>;
struct FreeArkode {
  void operator()(void* arkode) const { ARKStepFree(&arkode); }
};

void require(int flag, const char* call) {
  if (flag < 0)
    throw std::runtime_error(std::string("SUNDIALS: ") + call + " failed with flag " + std::to_string(flag));
}

// Where a step has to end.
struct Stop {
  double t;   // [s]
  bool jump;  // a load has another value from here on
};

// Breakpoints, and the pieces that a load without any, an expression, is resampled to. The last is beyond all times.
std::vector<Stop> stops(const System& system, double duration) {
  std::map<double, bool> all;
  for (const History& s : system.s) {
    const auto value = evaluator(s);
    const double small = 1e-9 * peak(s, duration);
    const auto add = [&](double t) { all[t] |= std::abs(value(t) - value(std::nextafter(t, 0.0))) > small; };
    for (const double t : breakpoints(s, duration)) add(t);
    if (!std::holds_alternative<Expression>(s)) continue;
    for (const Segment& piece : segments(s, duration, expression_resolved).pieces)
      if (piece.start > 0) add(piece.start);
  }
  std::vector<Stop> ascending;
  for (const auto& [t, jump] : all) ascending.push_back({t, jump});
  ascending.push_back({std::numeric_limits<double>::max(), false});
  return ascending;
}

// ARKODE on one system: owns every SUNDIALS object of one run.
class Run {
 public:
  Run(const System& system, Parts& parts, double tolerance, Scales scales, double largest_step)
      : problem_(system.u0.size(), parts) {
    const Index n = system.u0.size();
    SUNContext context = nullptr;
    require(SUNContext_Create(nullptr, &context), "SUNContext_Create");
    context_.reset(context);
    y_.reset(N_VNew_Serial(2 * n, context));
    tolerance_.reset(N_VNew_Serial(2 * n, context));
    displacement() = system.u0;
    velocity() = system.v0;
    Vector(NV_DATA_S(tolerance_.get()), n).setConstant(tolerance * scales.displacement);
    Vector(NV_DATA_S(tolerance_.get()) + n, n).setConstant(tolerance * scales.velocity);
    arkode_.reset(ARKStepCreate(nullptr, right_hand_side, 0, y_.get(), context));
    if (!arkode_) throw std::runtime_error("SUNDIALS: ARKStepCreate failed");
    configure(tolerance, largest_step, context);
  }

  // Integrates to t, at most to `next`. Past a stop at which loads jump ARKODE starts anew.
  int advance(double t, const Stop& next) {
    if (next.t != problem_.before) {
      if (jumped_) require(ARKStepReset(arkode_.get(), problem_.before, y_.get()), "ARKStepReset");
      problem_.before = next.t;
      jumped_ = next.jump;
    }
    require(ARKStepSetStopTime(arkode_.get(), next.t), "ARKStepSetStopTime");
    realtype reached = 0;
    return ARKStepEvolve(arkode_.get(), t, y_.get(), &reached, ARK_NORMAL);
  }

  Vector displacement() { return {NV_DATA_S(y_.get()), problem_.n}; }
  Vector velocity() { return {NV_DATA_S(y_.get()) + problem_.n, problem_.n}; }
  Work work() const {
    Work work = problem_.work;
    long attempts = 0;
    ARKStepGetNumSteps(arkode_.get(), &work.steps);
    ARKStepGetNumStepAttempts(arkode_.get(), &attempts);
    work.rejected = attempts - work.steps;
    return work;
  }

 private:
  void configure(double tolerance, double largest_step, SUNContext context) {
    void* ark = problem_.arkode = arkode_.get();
    stage_solver_.reset(SUNNonlinSolNewEmpty(context));
    stage_solver_->content = &problem_;
    stage_solver_->ops->gettype = root_finding;
    stage_solver_->ops->setsysfn = accept_function;
    stage_solver_->ops->solve = solve_stage;
    require(ARKStepSetUserData(ark, &problem_), "ARKStepSetUserData");
    require(ARKStepSVtolerances(ark, tolerance, tolerance_.get()), "ARKStepSVtolerances");
    require(ARKStepSetOrder(ark, 5), "ARKStepSetOrder");
    require(ARKStepSetMaxNumSteps(ark, max_steps), "ARKStepSetMaxNumSteps");
    require(ARKStepSetNonlinearSolver(ark, stage_solver_.get()), "ARKStepSetNonlinearSolver");
    require(ARKStepSetDeduceImplicitRhs(ark, 1), "ARKStepSetDeduceImplicitRhs");
    // From rest, error control alone would step over a load that comes late.
    require(ARKStepSetMaxStep(ark, largest_step), "ARKStepSetMaxStep");
    // The step stays unless it may grow by 1.6: an unchanged gamma keeps the factor.
    require(ARKStepSetFixedStepBounds(ark, 1.0, 1.6), "ARKStepSetFixedStepBounds");
  }

  Problem problem_;
  bool jumped_ = false;  // at the stop behind
  Owned<SUNContext> context_;
  Owned<N_Vector> y_, tolerance_;
  Owned<SUNNonlinearSolver> stage_solver_;
  std::unique_ptr<void, FreeArkode> arkode_;
};

Status status_of(int flag) {
  if (flag == ARK_TOO_MUCH_WORK) return Status::too_many_steps;
  return Status::no_convergence;
}

class Sundials final : public Stepper {
 public:
  Sundials(const System& system, double tolerance, double duration)
      : system_(system),
        tolerance_(tolerance),
        duration_(duration),
        parts_(system, duration),
        scales_(motion_scales(system, duration, parts_.A)),
        stops_(stops(system, duration)) {}

  States run(const VectorXd& times) const override {
    States out{MatrixXd(system_.u0.size(), times.size()), MatrixXd(system_.u0.size(), times.size()), {}, Status::ok, 0};
    Run run(system_, parts_, tolerance_, scales_, longest_step * duration_);
    size_t next = 0;
    for (Index k = 0; k < times.size(); ++k) {
      int flag = ARK_SUCCESS;
      for (; stops_[next].t < times[k] && flag >= 0; ++next) flag = run.advance(stops_[next].t, stops_[next]);
      if (times[k] > 0 && flag >= 0) flag = run.advance(times[k], stops_[next]);
      if (flag < 0 || !run.displacement().allFinite()) {
        out.status = flag < 0 ? status_of(flag) : Status::not_finite;
        break;
      }
      out.u.col(k) = run.displacement();
      out.v.col(k) = run.velocity();
      out.n_valid = k + 1;
    }
    out.work = run.work();
    out.work.factorisations += (parts_.mass.is_diagonal() ? 0 : 1) + (parts_.A.is_diagonal() ? 0 : 1);
    return out;
  }

 private:
  const System& system_;
  double tolerance_, duration_;
  mutable Parts parts_;  // a run leaves its last factor behind; what it starts from changes no digit
  Scales scales_;
  std::vector<Stop> stops_;
};

}  // namespace

std::unique_ptr<Stepper> sundials(const System& system, double relative_tolerance, double duration) {
  if (!(relative_tolerance >= 1e-12 && relative_tolerance <= 1e-2))
    throw std::invalid_argument("sundials: the relative tolerance must lie in [1e-12, 1e-2]");
  if (!(duration > 0)) throw std::invalid_argument("sundials: the duration must be positive");
  return std::make_unique<Sundials>(system, relative_tolerance, duration);
}

}  // namespace mb
