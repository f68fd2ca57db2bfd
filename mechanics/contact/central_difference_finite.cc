#include "mechanics/contact/central_difference_finite.h"

#include <limits>

#include "mechanics/contact/contact_record.h"
#include "mechanics/contact/contact_steppers.h"
#include "mechanics/system/finite_force.h"
#include "mechanics/system/march.h"
#include "mechanics/system/spd_factor.h"

namespace mb {

namespace {

class CentralDifferenceFinite final : public Stepper {
 public:
  CentralDifferenceFinite(const System& system, const std::vector<Contact>& contacts, double h)
      : system_(system),
        touches_(!contacts.empty()),
        h_(h),
        contact_(contacts),
        force_(system, FiniteForce::Mass::lumped_if_any),
        mass_(force_.M()) {}

  States run(const VectorXd& times) const override {
    VectorXd a = VectorXd::Zero(system_.u0.size()), f_C;
    bool whole = accelerate(0, {system_.u0, system_.v0}, a, f_C);
    VectorXd w = system_.v0 + h_ / 2 * a;
    ContactRecord record(contact_);
    if (touches_) record.add(0, system_.u0, system_.v0);
    States out = march(system_, h_, times, [&](double, double t1, const Motion& from, Motion& to) {
      to.u.noalias() = from.u + h_ * w;
      to.v = w;
      whole = whole && accelerate(t1, to, a, f_C);
      if (!whole) to.u.setConstant(std::numeric_limits<double>::quiet_NaN());
      to.v.noalias() += (h_ / 2) * a;
      w.noalias() += h_ * a;
      if (touches_) record.add(t1, to.u, to.v);
    });
    if (touches_) out.contact = record.history(times, out.u, out.v, out.n_valid);
    out.work.factorisations = mass_.is_diagonal() ? 0 : 1;
    out.work.solves = out.work.factorisations * (out.work.steps + 1);
    return out;
  }

 private:
  bool accelerate(double t, const Motion& at, VectorXd& a, VectorXd& f_C) const {
    if (!at.u.allFinite() || !force_(t, at.u, at.v, a)) return false;
    if (touches_) {
      contact_(contact_.gather(at.u), contact_.gather(at.v), f_C);
      contact_.add(f_C, a);
    }
    mass_.solve(a.data(), a.data());
    return true;
  }

  const System& system_;
  bool touches_;
  double h_;
  ContactForces contact_;
  FiniteForce force_;
  SpdFactor mass_;
};

}  // namespace

std::unique_ptr<Stepper> central_difference_finite(const System& system, const std::vector<Contact>& contacts,
                                                   double h) {
  return std::make_unique<CentralDifferenceFinite>(system, contacts, h);
}

}  // namespace mb
