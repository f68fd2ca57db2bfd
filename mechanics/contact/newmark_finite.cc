// Average acceleration of a body of finite deformation: the same steps as newmark_in_contact.cc, stage by
// finite_stage.h,
//
//   M v1 = M (v0 + h/2 a0) + h/2 (F s - r(u1, v1) + f_C),   u1 = u0 + h/2 v0 + h/2 v1
#include "mechanics/contact/newmark_finite.h"
#include "mechanics/contact/contact_record.h"
#include "mechanics/contact/contact_steppers.h"
#include "mechanics/contact/finite_stage.h"
#include "mechanics/system/march.h"
#include "mechanics/system/spd_factor.h"

namespace mb {

namespace {

// [-] Of the speeds; each step's part adds up over thousands: 1e-12 changes no answer of beyond-linear by 1e-7 of it.
constexpr double stage_tolerance = 1e-11;
constexpr double contact_tolerance = 1e-12;  // [-] likewise: linear momentum is handed over to this

// [m/s] of the contacts and the start.
double speed_scale(const System& system, const std::vector<Contact>& contacts) {
  double speed = system.v0.lpNorm<Eigen::Infinity>();
  for (const Contact& contact : contacts) speed = std::max(speed, contact.scale.velocity);
  return speed;
}

class NewmarkFinite final : public Stepper {
 public:
  NewmarkFinite(const System& system, const std::vector<Contact>& contacts, double h)
      : system_(system),
        touches_(!contacts.empty()),
        h_(h),
        speed_(speed_scale(system, contacts)),
        contact_(contacts),
        force_(system),
        stage_(system, force_, contacts.empty() ? nullptr : &contact_),
        mass_(system.M) {}

  States run(const VectorXd& times) const override {
    const Index n = system_.u0.size();
    const double gamma = h_ / 2;
    stage_.forget();
    VectorXd Ma(n), a_u(n), b(n), f_C;
    Status status = unbalanced(system_.u0, system_.v0, 0, Ma, f_C) ? Status::ok : Status::inverted;
    double speed = std::max({speed_, h_ * mass_.solve(Ma).lpNorm<Eigen::Infinity>(), brought_by_loads(times)});
    ContactRecord record(contact_);
    record.add(0, system_.u0, system_.v0);
    Work work;
    double failed = 0;  // [s] start of the step that failed: after it nothing moves
    States out = march(system_, h_, times, [&](double t0, double t1, const Motion& from, Motion& to) {
      to = from;
      if (status != Status::ok) return;
      a_u.noalias() = from.u + gamma * from.v;
      force_.mass(from.v, b);
      b += gamma * Ma;
      force_.add_load(t1, gamma, b);
      speed = std::max(speed, from.v.lpNorm<Eigen::Infinity>());
      const auto outcome = stage_.solve(t1, b, a_u, gamma, stage_tolerance * speed, contact_tolerance * speed, to.v);
      work.solves += outcome.solves;
      work.factorisations += outcome.factorisations;
      to.u.noalias() = a_u + gamma * to.v;
      const bool whole = outcome.converged && unbalanced(to.u, to.v, t1, Ma, f_C);
      if (!whole) {
        status = outcome.inverted || outcome.converged ? Status::inverted : Status::no_convergence;
        failed = t0;
        to = from;
        return;
      }
      record.add(t1, to.u, to.v);
    });
    out.work.solves = work.solves + 1;
    out.work.factorisations = work.factorisations + 1;
    if (status != Status::ok) {
      out.status = status;
      out.n_valid = (times.array() <= failed).count();
      blank_rest(out);
    }
    if (touches_) out.contact = record.history(times, out.u, out.v, out.n_valid);
    return out;
  }

 private:
  // [m/s] in a step, by the loads at their peaks: while they begin, rounding of the forces within the body is more than
  // any part of what moves.
  double brought_by_loads(const VectorXd& times) const {
    if (times.size() == 0 || !(times[times.size() - 1] > 0)) return 0;
    double largest = 0;
    for (Index l = 0; l < system_.F.cols(); ++l)
      largest = std::max(largest, peak(system_.s[static_cast<size_t>(l)], times[times.size() - 1]) *
                                      mass_.solve(VectorXd(system_.F.col(l))).lpNorm<Eigen::Infinity>());
    return h_ * largest;
  }

  // M a = F s - r(u, v) + f_C
  bool unbalanced(const VectorXd& u, const VectorXd& v, double t, VectorXd& Ma, VectorXd& f_C) const {
    if (!force_(t, u, v, Ma)) return Ma.setZero(u.size()), false;
    if (!touches_) return true;
    contact_(contact_.gather(u), contact_.gather(v), f_C);
    contact_.add(f_C, Ma);
    return true;
  }

  const System& system_;
  bool touches_;
  double h_, speed_;
  ContactForces contact_;
  FiniteForce force_;
  mutable FiniteStage stage_;
  SpdFactor mass_;
};

}  // namespace

std::unique_ptr<Stepper> newmark_finite(const System& system, const std::vector<Contact>& contacts, double h) {
  return std::make_unique<NewmarkFinite>(system, contacts, h);
}

}  // namespace mb
