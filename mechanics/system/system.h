// One body, full or reduced:
//
//   M u'' + C u' + K u = F s(t),    u(0) = u0, u'(0) = v0,
//   C = alpha (M - M R R^T M) + beta K + W diag(d) W^T + V
//
// or with finite deformation (stored_energy.h)   M u'' + alpha M (1 - P(u)) u' + f(u, u') = F s(t) + Q(u) F' s'(t),
// F' of loads that turn with the body.
//
// Free degrees of freedom only: supports are condensed, never unit rows. A reduced system is a System again, so every
// integrator and every measure works on both.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "mechanics/contact/touches.h"
#include "mechanics/history/history.h"
#include "mechanics/material/damping.h"
#include "mechanics/types.h"

namespace mb {

class StoredEnergy;  // stored_energy.h

struct System {
  SparseMatrix M;            // [kg] n x n, SPD, full storage
  SparseMatrix K;            // [N/m] n x n, symmetric positive semi-definite, K R = 0
  SparseMatrix lumped_mass;  // [kg] n x n, SPD, diagonal but for supports that are means; for explicit steps. 0 x 0: M
  Rayleigh damping;
  ModalDamping modal_damping;
  MatrixXd R;                 // n x m, rigid modes which the supports leave free, R^T M R = I; m = 6 for a free body
  MatrixXd F;                 // [N] n x number of loads
  std::vector<History> s;     // one a column of F
  VectorXd u0, v0;            // [m], [m/s]; n
  SparseMatrix viscous = {};  // V [N s/m] n x n, symmetric positive semi-definite; 0 x 0: none (joined.h)
  // Of finite deformation: then K u + beta K v stands for it near rest alone. Methods that reduce take K.
  std::shared_ptr<const StoredEnergy> stored_energy = nullptr;
  // Likewise: which loads turn with the body, Q(u) F s; one a column of F, or empty: none.
  std::vector<bool> follows = {};
};

void require_consistent(const System& system);  // throws std::invalid_argument where sizes disagree

bool is_damped(const System& system);                             // C is not 0
VectorXd apply_damping(const System& system, const VectorXd& v);  // C v [N]

// The system with its lumped mass as its only one, R orthonormal in it, as explicit integrators see it. Throws
// std::invalid_argument where it has none.
System with_lumped_mass(const System& system);
System with_consistent_mass(const System& system);  // and without the lumped one

// s(t) of all loads, prepared for many evaluations; one a thread.
class LoadFactors {
 public:
  explicit LoadFactors(const System& system);
  const VectorXd& operator()(double t) const;  // valid until the next call

 private:
  std::vector<std::function<double(double)>> histories_;
  mutable VectorXd s_;
};

double kinetic_energy(const System& system, const VectorXd& v);  // [J]
double strain_energy(const System& system, const VectorXd& u);   // [J] the stored one where the system has it

// What an integrator did, its preparation included; counts, never seconds. A load evaluation is that of all loads at
// one time, or of one of their pieces in closed form.
struct Work {
  long steps = 0, rejected = 0, factorisations = 0, solves = 0, load_evaluations = 0;
};
Work operator+(const Work& a, const Work& b);

// unstable: energy grew; inverted: a deformation whose Jacobian is not positive everywhere
enum class Status { ok, not_finite, no_convergence, too_many_steps, unstable, inverted };
const char* to_string(Status status);

// States at the times asked for. Where status is not ok, columns from n_valid on are NaN, but where all were reached.
struct States {
  MatrixXd u, v;  // [m], [m/s]; n x number of times
  Work work;
  Status status = Status::ok;
  Index n_valid = 0;
  ContactHistory contact = {};  // of steppers in contact
  VectorXd energy = {};         // [J] kinetic, strain and contact's, less the loads' work; 0: take it from u and v
};
void blank_rest(States& states);  // u and v from n_valid on: what was not reached is no number, in every run the same

// A time integrator prepared for one system (factors made). Runs repeat to the last digit, one thread at a time: they
// share scratch space.
class Stepper {
 public:
  virtual ~Stepper() = default;
  // times [s]: ascending, first >= 0; the run starts at t = 0 from u0, v0.
  virtual States run(const VectorXd& times) const = 0;
  // Exact means of u and v over [t - width/2, t + width/2] for every t of times, the state before t = 0 being the
  // initial one at rest. Only closed-form steppers have them: others throw std::invalid_argument.
  virtual States averages(const VectorXd& times, double width) const;
  // Largest error made in representing the loads [-] (history.h: load_error); 0 where they enter as they are.
  virtual double load_error() const { return 0; }
};

}  // namespace mb
