#include <limits>
#include <optional>

#include "mechanics/contact/contact_record.h"
#include "mechanics/contact/contact_steppers.h"
#include "mechanics/system/explicit_euler.h"
#include "mechanics/system/finite_force.h"
#include "mechanics/system/march.h"
#include "mechanics/system/spd_factor.h"
#include "mechanics/system/symplectic_euler.h"
#include "mechanics/system/unbalanced_force.h"

namespace mb {

namespace {

enum class VelocityOfDisplacement { old, updated };  // explicit, symplectic

class Euler final : public Stepper {
 public:
  Euler(const System& system, const std::vector<Contact>& contacts, double h, VelocityOfDisplacement velocity)
      : system_(system),
        h_(h),
        velocity_(velocity),
        contact_(contacts),
        in_contact_(!contacts.empty()),
        M_(mass_of(system)) {
    if (system.stored_energy)
      finite_.emplace(system, FiniteForce::Mass::lumped_if_any);
    else
      linear_.emplace(system);
  }

  States run(const VectorXd& times) const override {
    VectorXd a(system_.u0.size()), f_C;
    ContactRecord record(contact_);
    if (in_contact_) record.add(0, system_.u0, system_.v0);
    States out = march(system_, h_, times, [&](double t, double t1, const Motion& from, Motion& to) {
      const bool whole = accelerate(t, from, a, f_C);
      to.v.noalias() = from.v + h_ * a;
      to.u.noalias() = from.u + h_ * (velocity_ == VelocityOfDisplacement::old ? from.v : to.v);
      if (!whole) to.u.setConstant(std::numeric_limits<double>::quiet_NaN());
      if (in_contact_) record.add(t1, to.u, to.v);
    });
    if (in_contact_) out.contact = record.history(times, out.u, out.v, out.n_valid);
    out.work.factorisations = M_.is_diagonal() ? 0 : 1;
    out.work.solves = out.work.factorisations * out.work.steps;
    return out;
  }

 private:
  static const SparseMatrix& mass_of(const System& system) {
    require_consistent(system);
    return system.lumped_mass.rows() > 0 ? system.lumped_mass : system.M;
  }

  // Whether there is an acceleration: a body turned inside out has none.
  bool accelerate(double t, const Motion& at, VectorXd& a, VectorXd& f_C) const {
    if (linear_)
      (*linear_)(t, at.u, at.v, a);
    else if (!at.u.allFinite() || !(*finite_)(t, at.u, at.v, a))
      return false;
    if (in_contact_) {
      contact_(contact_.gather(at.u), contact_.gather(at.v), f_C);
      contact_.add(f_C, a);
    }
    M_.solve(a.data(), a.data());
    return true;
  }

  const System& system_;
  double h_;
  VelocityOfDisplacement velocity_;
  ContactForces contact_;
  bool in_contact_;
  std::optional<UnbalancedForce> linear_;
  std::optional<FiniteForce> finite_;
  SpdFactor M_;
};

}  // namespace

std::unique_ptr<Stepper> explicit_euler(const System& system, double h) { return explicit_euler(system, {}, h); }
std::unique_ptr<Stepper> symplectic_euler(const System& system, double h) { return symplectic_euler(system, {}, h); }

std::unique_ptr<Stepper> explicit_euler(const System& system, const std::vector<Contact>& contacts, double h) {
  return std::make_unique<Euler>(system, contacts, checked_step(h, "explicit Euler"), VelocityOfDisplacement::old);
}

std::unique_ptr<Stepper> symplectic_euler(const System& system, const std::vector<Contact>& contacts, double h) {
  return std::make_unique<Euler>(system, contacts, checked_step(h, "symplectic Euler"),
                                 VelocityOfDisplacement::updated);
}

}  // namespace mb
