#include "mechanics/contact/contact_record.h"
#include "mechanics/contact/contact_stage.h"
#include "mechanics/contact/contact_steppers.h"
#include "mechanics/contact/newmark_finite.h"
#include "mechanics/system/march.h"
#include "mechanics/system/shifted.h"
#include "mechanics/system/symmetric_product.h"
#include "mechanics/system/unbalanced_force.h"

namespace mb {

namespace {

constexpr double stage_tolerance = 1e-9;  // [-] of the contacts' speed: 1e-12 changes answers by 1e-11 of their error

double largest_speed(const std::vector<Contact>& contacts) {
  double speed = 0;
  for (const Contact& contact : contacts) speed = std::max(speed, contact.scale.velocity);
  return speed;
}

class NewmarkInContact final : public Stepper {
 public:
  NewmarkInContact(const System& system, const std::vector<Contact>& contacts, double h)
      : system_(system),
        h_(h),
        tolerance_(stage_tolerance * largest_speed(contacts)),
        forces_(contacts),
        stage_(forces_, system.u0.size()),
        force_(system, UnbalancedForce::Mass::consistent),
        A_(system, h / 2),
        M_(system.M) {}

  States run(const VectorXd& times) const override {
    const Index n = system_.u0.size();
    const double gamma = h_ / 2;
    VectorXd Ma(n), a_u(n), b(n), f_C;
    force_(0, system_.u0, system_.v0, Ma);  // M a = F s - K u - C v + f
    ContactRecord record(forces_);
    record.add(0, forces_(forces_.gather(system_.u0), forces_.gather(system_.v0), f_C));
    forces_.add(f_C, Ma);
    long solves = 0;
    bool converged = true;
    States out = march(system_, h_, times, [&](double, double t1, const Motion& from, Motion& to) {
      a_u.noalias() = from.u + gamma * from.v;
      force_.without_damping(t1, a_u, b);
      M_(from.v, to.u);
      b = to.u + gamma * (Ma + b);
      A_.solve(b, to.v);
      const auto outcome = stage_.solve(A_, a_u, gamma, tolerance_, to.v);
      solves += 1 + outcome.solves;
      converged = converged && outcome.converged;
      to.u.noalias() = a_u + gamma * to.v;
      // The very forces that the step took: momentum is handed over to rounding, not to the tolerance.
      force_(t1, to.u, to.v, Ma);
      forces_.add(stage_.force(), Ma);
      record.add(t1, outcome.sum);
    });
    out.work.solves = solves;
    out.work.factorisations = 1;
    if (!converged) out.status = Status::no_convergence;
    out.contact = record.history(times, out.u, out.v, out.n_valid);
    return out;
  }

 private:
  const System& system_;
  double h_, tolerance_;
  ContactForces forces_;
  mutable ContactStage stage_;  // columns of A^-1, found when needed
  UnbalancedForce force_;
  Shifted A_;
  SymmetricProduct M_;
};

}  // namespace

std::unique_ptr<Stepper> newmark(const System& system, const std::vector<Contact>& contacts, double h) {
  require_consistent(system);
  if (system.stored_energy) return newmark_finite(system, contacts, checked_step(h, "newmark"));
  return std::make_unique<NewmarkInContact>(system, contacts, checked_step(h, "newmark"));
}

}  // namespace mb
