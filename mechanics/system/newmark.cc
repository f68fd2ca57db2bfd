#include "mechanics/system/newmark.h"

#include "mechanics/contact/newmark_finite.h"
#include "mechanics/system/march.h"
#include "mechanics/system/shifted.h"
#include "mechanics/system/symmetric_product.h"

namespace mb {

namespace {

class Newmark final : public Stepper {
 public:
  Newmark(const System& system, double h)
      : system_(system),
        h_(h),
        A_(system, h / 2),
        M_(system.M),
        K_(system.K),
        a0_(initial_acceleration(system)),
        factors_(system) {}

  States run(const VectorXd& times) const override;

 private:
  struct Scratch {
    VectorXd w, z, b;
  };
  static VectorXd initial_acceleration(const System& s) {
    const VectorXd f = s.F * LoadFactors(s)(0) - apply_damping(s, s.v0) - s.K * s.u0;
    if (f.isZero(0)) return f;  // at rest and unloaded: spares the factor of M
    return SpdFactor(s.M).solve(f);
  }
  // b = M (4/h^2 u + 4/h v + a) + C (2/h u + v) + F s
  void right_hand_side(const Motion& x, const VectorXd& a, const VectorXd& s, Scratch& scratch) const;

  const System& system_;
  double h_;
  Shifted A_;
  SymmetricProduct M_, K_;
  VectorXd a0_;
  LoadFactors factors_;
};

void Newmark::right_hand_side(const Motion& x, const VectorXd& a, const VectorXd& s, Scratch& scratch) const {
  auto& [w, z, b] = scratch;
  const auto [alpha, beta] = system_.damping;
  w.noalias() = (4 / (h_ * h_)) * x.u + (4 / h_) * x.v + a;
  z.noalias() = (2 / h_) * x.u + x.v;
  if (alpha != 0) w.noalias() += alpha * z;
  M_(w, b);
  A_.low_rank().add_product(1, z, b);
  if (beta != 0) {
    K_(z, w);
    b.noalias() += beta * w;
  }
  if (system_.viscous.rows() > 0) b.noalias() += system_.viscous * z;
  if (!s.isZero(0)) b.noalias() += system_.F * s;
}

States Newmark::run(const VectorXd& times) const {
  const Index n = system_.u0.size();
  VectorXd a = a0_;
  Scratch scratch{VectorXd(n), VectorXd(n), VectorXd(n)};
  States out = march(system_, h_, times, [&](double, double t1, const Motion& from, Motion& to) {
    right_hand_side(from, a, factors_(t1), scratch);
    A_.solve(scratch.b, to.u);
    to.u *= h_ * h_ / 4;
    to.v.noalias() = (2 / h_) * (to.u - from.u) - from.v;
    a = (4 / (h_ * h_)) * (to.u - from.u) - (4 / h_) * from.v - a;
  });
  const bool starts_loaded = !a0_.isZero(0);
  if (!A_.is_diagonal()) {
    out.work.factorisations = starts_loaded ? 2 : 1;
    out.work.solves = out.work.steps + (starts_loaded ? 1 : 0);
  }
  return out;
}

}  // namespace

std::unique_ptr<Stepper> newmark(const System& system, double h) {
  require_consistent(system);
  if (system.stored_energy) return newmark_finite(system, {}, checked_step(h, "newmark"));
  return std::make_unique<Newmark>(system, checked_step(h, "newmark"));
}

}  // namespace mb
