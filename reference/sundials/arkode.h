// ARKODE on one system, with contact or without:
//
//   y = (u, v),        u' = v,   M v' = F s - C v - K u + f_contact(u, v)
//   y = (u, v, J, D)   with contact: impulse J' = sum f [N s] and losses D' [J], by the quadrature of the scheme itself
//
// and with a stored energy r(u, v) in the place of C v + K u (mechanics/contact/finite_stage.h).
//
// Per stage (M + gamma C + gamma^2 K) v = ...: one SPD factor a gamma; contact is condensed onto the unknowns it acts
// on (mechanics/contact/contact_stage.h). Included only within reference/sundials (SUNDIALS' door).
#pragma once

#include <nvector/nvector_serial.h>
#include <sundials/sundials_nonlinearsolver.h>

#include <list>
#include <optional>

#include "mechanics/contact/contact_stage.h"
#include "mechanics/contact/finite_stage.h"
#include "mechanics/system/shifted.h"
#include "mechanics/system/symmetric_product.h"
#include "mechanics/system/unbalanced_force.h"

namespace mb::ark {

using Vector = Eigen::Map<VectorXd>;
inline constexpr Index n_quadratures = 4;  // J, D

// Largest changes of the motion, by which errors are weighed: both > 0.
struct Scales {
  double displacement, velocity;
};  // [m], [m/s]

// Tolerances: of displacement and velocity tolerance * scale, and with `relative` also that part of their own size.
struct Accuracy {
  double tolerance;  // [-]
  Scales scales;
  bool relative;
  double longest_step;  // [s]
};

// A factor of M + gamma C + gamma^2 K and what contact has found of its inverse.
struct Factor {
  Shifted A;
  std::optional<ContactStage> stage;
  bool current;  // made in this run
};

// The factors of the last few gammas: steps are powers of sqrt(2) of the first, so that few are enough and come back.
class Factors {
 public:
  Factors(const System& system, double gamma, const ContactForces* contact);  // both must outlive this
  Factor& at(double gamma);  // made where it is not there, in the place of the one longest unused
  // Each run pays for its own: what is there serves as a pattern alone.
  void forget();
  long n_made() const { return n_made_; }  // since then

 private:
  void add(double gamma);

  static constexpr size_t most = 6;
  const System& system_;
  const ContactForces* contact_;
  std::list<Factor> used_;  // the last one used first
  long n_made_ = 0;
};

// Of a body with a stored energy.
struct FiniteParts {
  FiniteParts(const System& system, const ContactForces* contact) : force(system), stage(system, force, contact) {}
  FiniteForce force;
  FiniteStage stage;
};

// The parts that last: made once, used by every run.
struct Parts {
  Parts(const System& system, double gamma, const std::vector<Contact>& contacts);
  UnbalancedForce force;
  SpdFactor mass;
  SymmetricProduct M;
  std::optional<ContactForces> contact;  // or none
  Factors factors;
  std::unique_ptr<FiniteParts> finite;  // or none
};

// What one run needs at every callback. ARKODE sees it as user data and as the stage solver's content.
struct Problem {
  Problem(Index n_, Parts& parts_) : parts(parts_), n(n_), b(n_), u(n_), v(n_) {}
  Index size() const { return 2 * n + (parts.contact ? n_quadratures : 0); }
  double load_time(double t) const { return std::min(t, std::nextafter(before, 0.0)); }
  ContactSum contact_at(const VectorXd& u_, const VectorXd& v_, VectorXd& f_C) const;

  Parts& parts;
  Index n;
  VectorXd b, u, v, f;
  void* arkode = nullptr;
  double before = 0;      // [s] next breakpoint: loads are taken from its left
  double tolerance = 0;   // [m/s] of contact stages
  double speed = 0;       // [m/s] its scale
  bool inverted = false;  // the last state that was tried
  Work work;
};

struct Free {
  void operator()(SUNContext c) const { SUNContext_Free(&c); }
  void operator()(N_Vector v) const { N_VDestroy(v); }
  void operator()(SUNNonlinearSolver s) const { SUNNonlinSolFreeEmpty(s); }
};
template <class T>
using Owned = std::unique_ptr<std::remove_pointer_t<T>, Free>;
struct FreeArkode {
  void operator()(void* arkode) const;
};

// Where a step has to end.
struct Stop {
  double t;   // [s]
  bool jump;  // a load has another value from here on
};

// Owns every SUNDIALS object of one run.
class Run {
 public:
  Run(const System& system, Parts& parts, const Accuracy& accuracy);

  // Integrates to t, at most to `next`: a negative flag where it fails. Past a stop at which loads jump ARKODE starts
  // anew.
  int advance(double t, const Stop& next);
  // One step, at most to t; it may end earlier, also where the least gap passes zero. `reached` is set.
  int step(double t, double& reached);
  // State at a time within the last step.
  void look_at(double t);

  Vector displacement() { return {NV_DATA_S(y_.get()), problem_.n}; }  // of the last advance, step or look
  Vector velocity() { return {NV_DATA_S(y_.get()) + problem_.n, problem_.n}; }
  Vector quadratures() { return {NV_DATA_S(y_.get()) + 2 * problem_.n, problem_.parts.contact ? n_quadratures : 0}; }
  ContactSum contact();
  Work work() const;
  Status status_of(int flag) const;  // of an evolution that failed

 private:
  void configure(const Accuracy& accuracy, SUNContext context);

  Problem problem_;
  bool jumped_ = false;  // at the stop behind
  Owned<SUNContext> context_;
  Owned<N_Vector> y_, tolerance_;
  Owned<SUNNonlinearSolver> stage_solver_;
  std::unique_ptr<void, FreeArkode> arkode_;
};

}  // namespace mb::ark
