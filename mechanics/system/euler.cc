#include "mechanics/system/explicit_euler.h"
#include "mechanics/system/march.h"
#include "mechanics/system/spd_factor.h"
#include "mechanics/system/stored_energy.h"
#include "mechanics/system/symplectic_euler.h"
#include "mechanics/system/unbalanced_force.h"

namespace mb {

namespace {

enum class VelocityOfDisplacement { old, updated };  // explicit, symplectic

class Euler final : public Stepper {
 public:
  Euler(const System& system, double h, VelocityOfDisplacement velocity)
      : system_(system), h_(h), velocity_(velocity), force_(system), M_(force_.M()) {}

  States run(const VectorXd& times) const override {
    VectorXd a(system_.u0.size());
    States out = march(system_, h_, times, [&](double t, double, const Motion& from, Motion& to) {
      force_(t, from.u, from.v, a);
      M_.solve(a.data(), a.data());
      to.v.noalias() = from.v + h_ * a;
      to.u.noalias() = from.u + h_ * (velocity_ == VelocityOfDisplacement::old ? from.v : to.v);
    });
    out.work.factorisations = M_.is_diagonal() ? 0 : 1;
    out.work.solves = out.work.factorisations * out.work.steps;
    return out;
  }

 private:
  const System& system_;
  double h_;
  VelocityOfDisplacement velocity_;
  UnbalancedForce force_;
  SpdFactor M_;
};

}  // namespace

std::unique_ptr<Stepper> explicit_euler(const System& system, double h) {
  require_linear(system, "explicit Euler");
  return std::make_unique<Euler>(system, checked_step(h, "explicit Euler"), VelocityOfDisplacement::old);
}

std::unique_ptr<Stepper> symplectic_euler(const System& system, double h) {
  require_linear(system, "symplectic Euler");
  return std::make_unique<Euler>(system, checked_step(h, "symplectic Euler"), VelocityOfDisplacement::updated);
}

}  // namespace mb
