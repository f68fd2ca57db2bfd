#include "mechanics/system/central_difference.h"

#include "mechanics/contact/central_difference_finite.h"
#include "mechanics/contact/contact_record.h"
#include "mechanics/contact/contact_steppers.h"
#include "mechanics/system/march.h"
#include "mechanics/system/shifted.h"
#include "mechanics/system/unbalanced_force.h"

namespace mb {

namespace {

// Of a lumped mass, what a step solves with: the mass and the damping proportional to it.
System lumped_part(const UnbalancedForce& force, double alpha) {
  System part;
  part.M = force.M();
  part.K.resize(part.M.rows(), part.M.cols());
  part.damping.alpha = alpha;
  part.R = force.R();
  return part;
}

// In velocities half way between steps, w = (u - u-)/h and w+ = (u+ - u)/h, both ways to damp read
//
//   (M + h/2 C_i) (w+ - w)/h = F s - K u - C w
//
// with C_i the part of C that is implicit: all of it, or that of the lumped mass. Then v = (w + w+)/2.
class CentralDifference final : public Stepper {
 public:
  CentralDifference(const System& system, const std::vector<Contact>& contacts, double h)
      : system_(system),
        h_(h),
        contact_(contacts),
        in_contact_(!contacts.empty()),
        force_(system),
        lumped_(system.lumped_mass.rows() > 0 ? lumped_part(force_, system.damping.alpha) : System()),
        A_(system.lumped_mass.rows() > 0 ? lumped_ : system, h / 2, 0),
        first_(system.v0 + h / 2 * first_acceleration()) {}

  States run(const VectorXd& times) const override {
    VectorXd w = first_, a(w.size()), f_C;
    ContactRecord record(contact_);
    if (in_contact_) record.add(0, system_.u0, system_.v0);
    States out = march(system_, h_, times, [&](double, double t1, const Motion& from, Motion& to) {
      to.u.noalias() = from.u + h_ * w;
      force_(t1, to.u, w, a);
      if (in_contact_) {
        contact_(contact_.gather(to.u), contact_.gather(w), f_C);
        contact_.add(f_C, a);
      }
      A_.solve(a, a);
      to.v.noalias() = w + (h_ / 2) * a;
      w.noalias() += h_ * a;
      if (in_contact_) record.add(t1, to.u, to.v);
    });
    if (in_contact_) out.contact = record.history(times, out.u, out.v, out.n_valid);
    out.work.factorisations = n_factors_;
    if (!A_.is_diagonal()) out.work.solves = out.work.steps + 1;
    return out;
  }

 private:
  // a of (u_1 - u_0)/h = v0 + h/2 a, where (u_1 - u_-1)/(2h) = v0 and M a + C v0 + K u0 = F s.
  VectorXd first_acceleration() {
    VectorXd a(system_.u0.size());
    force_(0, system_.u0, system_.v0, a);
    n_factors_ = A_.is_diagonal() ? 0 : 1;
    if (is_damped(system_) && !a.isZero(0)) {
      const SpdFactor mass(force_.M());
      n_factors_ += mass.is_diagonal() ? 0 : 1;
      return mass.solve(a);
    }
    A_.solve(a, a);
    return a;
  }

  const System& system_;
  double h_;
  ContactForces contact_;
  bool in_contact_;
  UnbalancedForce force_;
  System lumped_;
  Shifted A_;
  long n_factors_ = 0;
  VectorXd first_;  // [m/s]
};

}  // namespace

std::unique_ptr<Stepper> central_difference(const System& system, double h) {
  return central_difference(system, {}, h);
}

std::unique_ptr<Stepper> central_difference(const System& system, const std::vector<Contact>& contacts, double h) {
  checked_step(h, "central difference");
  if (system.stored_energy) return central_difference_finite(system, contacts, h);
  return std::make_unique<CentralDifference>(system, contacts, h);
}

}  // namespace mb
