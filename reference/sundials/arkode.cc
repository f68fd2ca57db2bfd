#include "reference/sundials/arkode.h"

#include <arkode/arkode_arkstep.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace mb::ark {

namespace {

constexpr long max_steps = 2'000'000;
constexpr double unweighed = 1e300;         // quadratures follow, they do not rule the steps
constexpr double stage_tolerance = 1e-3;    // [-] of the step's own
constexpr double finite_tolerance = 1e-2;   // [-] likewise, of stages that iterate: a tenth of it changes no answer
constexpr double contact_tolerance = 1e-5;  // [-] of a finite stage's: by this momentum is handed over
constexpr int recoverable = 1;

void require(int flag, const char* call) {
  if (flag < 0)
    throw std::runtime_error(std::string("SUNDIALS: ") + call + " failed with flag " + std::to_string(flag));
}

void set_quadratures(const ContactSum& sum, double* to) {
  for (Index i = 0; i < 3; ++i) to[i] = sum.force[i];
  to[3] = sum.dissipation;
}

int right_hand_side(realtype t, N_Vector y, N_Vector ydot, void* data) {
  Problem& p = *static_cast<Problem*>(data);
  p.u = Vector(NV_DATA_S(y), p.n);
  p.v = Vector(NV_DATA_S(y) + p.n, p.n);
  Vector(NV_DATA_S(ydot), p.n) = p.v;
  if (p.parts.finite) {
    p.inverted = !p.parts.finite->force(p.load_time(t), p.u, p.v, p.b);
    if (p.inverted) return recoverable;
  } else {
    p.parts.force(p.load_time(t), p.u, p.v, p.b);
  }
  if (p.parts.contact) {
    set_quadratures(p.contact_at(p.u, p.v, p.f), NV_DATA_S(ydot) + 2 * p.n);
    p.parts.contact->add(p.f, p.b);
  }
  p.parts.mass.solve(p.b.data(), NV_DATA_S(ydot) + p.n);
  ++p.work.load_evaluations;
  ++p.work.solves;
  return 0;
}

// What ARKODE knows of the stage z = predicted + correction = predicted + data + gamma f(z).
struct Stage {
  realtype t, gamma;
  N_Vector predicted, data;
  Vector part(N_Vector x, Index from, Index n) const { return {NV_DATA_S(x) + from, n}; }
};

void set_quadratures(const ContactSum& sum, const Problem& p, const Stage& stage, N_Vector correction) {
  double rates[n_quadratures];
  set_quadratures(sum, rates);
  const Index at = 2 * p.n;
  stage.part(correction, at, n_quadratures) =
      stage.part(stage.data, at, n_quadratures) + stage.gamma * Vector(rates, n_quadratures);
}

// Contact in a stage whose linear solution stands in p.v: false where Newton's method fails.
bool solve_contact(Problem& p, const Stage& stage, Factor& factor, N_Vector correction) {
  const VectorXd a = stage.part(stage.predicted, 0, p.n) + stage.part(stage.data, 0, p.n);
  const auto outcome = factor.stage->solve(factor.A, a, stage.gamma, p.tolerance, p.v);
  p.work.solves += outcome.solves;
  if (outcome.converged) set_quadratures(outcome.sum, p, stage, correction);
  return outcome.converged;
}

// The nonlinear stage of a finite body, from the predicted velocity: false where it fails.
bool solve_finite(Problem& p, const Stage& stage, N_Vector correction) {
  const VectorXd a = stage.part(stage.predicted, 0, p.n) + stage.part(stage.data, 0, p.n);
  p.v = stage.part(stage.predicted, p.n, p.n) + stage.part(stage.data, p.n, p.n);
  p.parts.finite->force.mass(p.v, p.b);
  p.parts.finite->force.add_load(p.load_time(stage.t), stage.gamma, p.b);
  p.v = stage.part(stage.predicted, p.n, p.n);
  const double exact = std::max(contact_tolerance * p.tolerance, 1e-13 * p.speed);
  const auto outcome = p.parts.finite->stage.solve(p.load_time(stage.t), p.b, a, stage.gamma, p.tolerance, exact, p.v);
  p.work.solves += outcome.solves;
  p.work.factorisations += outcome.factorisations;
  ++p.work.load_evaluations;
  p.inverted = outcome.inverted;
  if (outcome.converged && p.parts.contact)
    set_quadratures(p.contact_at(a + stage.gamma * p.v, p.v, p.f), p, stage, correction);
  return outcome.converged;
}

// One implicit stage without forming f, linear but for contact:
//   (M + gamma C + gamma^2 K) v = M a_v + gamma (F s - K a_u),   u = a_u + gamma v
int solve_stage(SUNNonlinearSolver solver, N_Vector, N_Vector correction, N_Vector, realtype, booleantype, void*) {
  Problem& p = *static_cast<Problem*>(solver->content);
  Stage stage{};
  N_Vector z, Fi;
  void* user;
  if (ARKStepGetNonlinearSystemData(p.arkode, &stage.t, &stage.predicted, &z, &Fi, &stage.gamma, &stage.data, &user) !=
      ARK_SUCCESS)
    return -1;
  const double gamma = stage.gamma;
  const Vector data_u = stage.part(stage.data, 0, p.n), data_v = stage.part(stage.data, p.n, p.n),
               predicted_u = stage.part(stage.predicted, 0, p.n), predicted_v = stage.part(stage.predicted, p.n, p.n);
  const auto give = [&] {
    stage.part(correction, 0, p.n) = data_u + gamma * p.v;
    stage.part(correction, p.n, p.n) = p.v - predicted_v;
    return SUN_NLS_SUCCESS;
  };
  if (p.parts.finite) return solve_finite(p, stage, correction) ? give() : SUN_NLS_CONV_RECVR;
  Factor& factor = p.parts.factors.at(gamma);
  p.u = predicted_u + data_u;
  p.parts.force.without_damping(p.load_time(stage.t), p.u, p.b);
  ++p.work.load_evaluations;
  p.v = predicted_v + data_v;
  p.parts.M(p.v, p.u);
  p.b = gamma * p.b + p.u;
  factor.A.solve(p.b, p.v);
  ++p.work.solves;
  if (!std::isfinite(p.v.sum())) return -1;
  if (p.parts.contact && !solve_contact(p, stage, factor, correction)) return SUN_NLS_CONV_RECVR;
  return give();
}

SUNNonlinearSolver_Type root_finding(SUNNonlinearSolver) { return SUNNONLINEARSOLVER_ROOTFIND; }
int accept_function(SUNNonlinearSolver, SUNNonlinSolSysFn) { return SUN_NLS_SUCCESS; }

// The next step: what the error of the last asks for (order 5, embedded 4), down to a power of sqrt(2). `safety` is
// what ARKODE multiplies by afterwards.
constexpr double safety = 0.96, room = 0.75;
int step_on_the_grid(N_Vector, realtype, realtype h, realtype, realtype, realtype error, realtype, realtype, int, int p,
                     realtype* next, void*) {
  const double wanted = h * room * std::pow(std::max(error, 1e-10), -1.0 / (p + 1));
  const double grid = std::exp2(std::floor(2 * std::log2(wanted)) / 2);
  *next = grid / safety;
  return std::isfinite(grid) ? ARK_SUCCESS : -1;
}

int least_gap(realtype, N_Vector y, realtype* gap, void* data) {
  Problem& p = *static_cast<Problem*>(data);
  p.u = Vector(NV_DATA_S(y), p.n);
  p.v = Vector(NV_DATA_S(y) + p.n, p.n);
  gap[0] = p.contact_at(p.u, p.v, p.f).least_gap;
  return 0;
}

}  // namespace

ContactSum Problem::contact_at(const VectorXd& u_, const VectorXd& v_, VectorXd& f_C) const {
  const ContactForces& forces = *parts.contact;
  return forces(forces.gather(u_), forces.gather(v_), f_C);
}

void FreeArkode::operator()(void* arkode) const { ARKStepFree(&arkode); }

namespace {

constexpr double most_lightness = 30;  // [-]

// sqrt(mean m / m_i), m_i = M_ii: with these, errors are weighed in the M norm, and the many small cells of a graded
// mesh count by their mass, not by their number.
VectorXd lightness_of_nodes(const System& system) {
  const VectorXd m = system.M.diagonal();
  return (m.mean() / m.array()).sqrt().min(most_lightness);
}

}  // namespace

Run::Run(const System& system, Parts& parts, const Accuracy& accuracy) : problem_(system.u0.size(), parts) {
  parts.factors.forget();
  if (parts.finite) parts.finite->stage.forget();
  const Index n = system.u0.size(), size = problem_.size();
  SUNContext context = nullptr;
  require(SUNContext_Create(nullptr, &context), "SUNContext_Create");
  context_.reset(context);
  y_.reset(N_VNew_Serial(size, context));
  tolerance_.reset(N_VNew_Serial(size, context));
  N_VConst(0, y_.get());
  N_VConst(unweighed, tolerance_.get());
  displacement() = system.u0;
  velocity() = system.v0;
  const VectorXd lightness = lightness_of_nodes(system);
  Vector(NV_DATA_S(tolerance_.get()), n) = accuracy.tolerance * accuracy.scales.displacement * lightness;
  Vector(NV_DATA_S(tolerance_.get()) + n, n) = accuracy.tolerance * accuracy.scales.velocity * lightness;
  problem_.tolerance =
      (parts.finite ? finite_tolerance : stage_tolerance) * accuracy.tolerance * accuracy.scales.velocity;
  problem_.speed = accuracy.scales.velocity;
  arkode_.reset(ARKStepCreate(nullptr, right_hand_side, 0, y_.get(), context));
  if (!arkode_) throw std::runtime_error("SUNDIALS: ARKStepCreate failed");
  configure(accuracy, context);
}

int Run::advance(double t, const Stop& next) {
  if (next.t != problem_.before) {
    if (jumped_) require(ARKStepReset(arkode_.get(), problem_.before, y_.get()), "ARKStepReset");
    problem_.before = next.t;
    jumped_ = next.jump;
  }
  require(ARKStepSetStopTime(arkode_.get(), next.t), "ARKStepSetStopTime");
  realtype reached = 0;
  return ARKStepEvolve(arkode_.get(), t, y_.get(), &reached, ARK_NORMAL);
}

int Run::step(double t, double& reached) {
  problem_.before = std::numeric_limits<double>::max();  // loads have no breakpoints here
  require(ARKStepSetStopTime(arkode_.get(), t), "ARKStepSetStopTime");
  void* const ark = arkode_.get();
  const int flag = ARKStepEvolve(ark, t, y_.get(), &reached, ARK_ONE_STEP);
  if (flag != ARK_ILL_INPUT) return flag;
  // The gap grazes zero: one root right behind another, which ARKODE refuses. This step goes without them.
  require(ARKStepRootInit(ark, 0, nullptr), "ARKStepRootInit");
  const int again = ARKStepEvolve(ark, t, y_.get(), &reached, ARK_ONE_STEP);
  require(ARKStepRootInit(ark, 1, least_gap), "ARKStepRootInit");
  return again;
}

void Run::look_at(double t) { require(ARKStepGetDky(arkode_.get(), t, 0, y_.get()), "ARKStepGetDky"); }

ContactSum Run::contact() { return problem_.contact_at(displacement(), velocity(), problem_.f); }

Work Run::work() const {
  Work work = problem_.work;
  work.factorisations += problem_.parts.factors.n_made();
  long attempts = 0;
  ARKStepGetNumSteps(arkode_.get(), &work.steps);
  ARKStepGetNumStepAttempts(arkode_.get(), &attempts);
  work.rejected = attempts - work.steps;
  return work;
}

void Run::configure(const Accuracy& accuracy, SUNContext context) {
  void* ark = problem_.arkode = arkode_.get();
  stage_solver_.reset(SUNNonlinSolNewEmpty(context));
  stage_solver_->content = &problem_;
  stage_solver_->ops->gettype = root_finding;
  stage_solver_->ops->setsysfn = accept_function;
  stage_solver_->ops->solve = solve_stage;
  const double relative = accuracy.relative ? accuracy.tolerance : 0;
  require(ARKStepSetUserData(ark, &problem_), "ARKStepSetUserData");
  require(ARKStepSVtolerances(ark, relative, tolerance_.get()), "ARKStepSVtolerances");
  require(ARKStepSetOrder(ark, 5), "ARKStepSetOrder");
  require(ARKStepSetMaxNumSteps(ark, max_steps), "ARKStepSetMaxNumSteps");
  require(ARKStepSetNonlinearSolver(ark, stage_solver_.get()), "ARKStepSetNonlinearSolver");
  require(ARKStepSetDeduceImplicitRhs(ark, 1), "ARKStepSetDeduceImplicitRhs");
  // From rest, error control alone would step over a load that comes late.
  // Where stages iterate, a guess: polynomials of a degree that falls with the distance.
  if (problem_.parts.finite) require(ARKStepSetPredictorMethod(ark, 2), "ARKStepSetPredictorMethod");
  require(ARKStepSetMaxStep(ark, accuracy.longest_step), "ARKStepSetMaxStep");
  require(ARKStepSetAdaptivityFn(ark, step_on_the_grid, nullptr), "ARKStepSetAdaptivityFn");
  require(ARKStepSetSafetyFactor(ark, safety), "ARKStepSetSafetyFactor");
  require(ARKStepSetFixedStepBounds(ark, 1.0, 1.0), "ARKStepSetFixedStepBounds");
  if (!problem_.parts.contact) return;
  require(ARKStepRootInit(ark, 1, least_gap), "ARKStepRootInit");
  require(ARKStepSetErrFile(ark, nullptr), "ARKStepSetErrFile");  // steps that fail are tried again, or have a status
}

Status Run::status_of(int flag) const {
  if (problem_.inverted) return Status::inverted;
  if (flag == ARK_TOO_MUCH_WORK) return Status::too_many_steps;
  return Status::no_convergence;
}

}  // namespace mb::ark
