#include "mechanics/system/newmark.h"

#include <stdexcept>

#include "mechanics/algebra/cholesky.h"
#include "mechanics/system/mass_product.h"
#include "mechanics/system/shifted.h"

namespace mb {

namespace {

struct State {
  VectorXd u, v, a;
};

class Newmark final : public Stepper {
 public:
  Newmark(const System& system, double h)
      : system_(system),
        h_(h),
        A_(system, h / 2),
        M_(system.M),
        MR_(system.M * system.R),
        a0_(initial_acceleration(system)),
        factors_(system) {}

  States run(const VectorXd& times) const override;

 private:
  static VectorXd initial_acceleration(const System& s) {
    const VectorXd f = s.F * LoadFactors(s)(0) - apply_damping(s, s.v0) - s.K * s.u0;
    if (f.isZero(0)) return f;  // at rest and unloaded: spares the factor of M
    return Cholesky(s.M).solve(f);
  }
  // b = M (4/h^2 u + 4/h v + a) + C (2/h u + v) + F s
  void right_hand_side(const State& x, const VectorXd& s, VectorXd& w, VectorXd& z, VectorXd& b) const;

  const System& system_;
  double h_;
  Shifted A_;
  MassProduct M_;
  MatrixXd MR_;
  VectorXd a0_;
  LoadFactors factors_;
};

void Newmark::right_hand_side(const State& x, const VectorXd& s, VectorXd& w, VectorXd& z, VectorXd& b) const {
  const auto [alpha, beta] = system_.damping;
  w.noalias() = (4 / (h_ * h_)) * x.u + (4 / h_) * x.v + x.a;
  if (alpha != 0 || beta != 0) z.noalias() = (2 / h_) * x.u + x.v;
  if (alpha != 0) w.noalias() += alpha * z;
  M_(w, b);
  if (alpha != 0 && MR_.cols() > 0) {
    const Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 6, 1> rigid = alpha * (MR_.transpose() * z);
    b.noalias() -= MR_ * rigid;
  }
  if (beta != 0) b.noalias() += system_.K.transpose() * (beta * z).eval();
  if (!s.isZero(0)) b.noalias() += system_.F * s;
}

// Cubic Hermite polynomial of displacement between two states, at fraction x of the step h; and its derivative.
void interpolate(const State& from, const VectorXd& u1, const VectorXd& v1, double x, double h, States& out, Index k) {
  const double h00 = (1 + 2 * x) * (1 - x) * (1 - x), h10 = x * (1 - x) * (1 - x), h01 = x * x * (3 - 2 * x),
               h11 = x * x * (x - 1), d00 = 6 * x * (x - 1), d10 = (1 - x) * (1 - 3 * x), d11 = x * (3 * x - 2);
  out.u.col(k) = h00 * from.u + h10 * h * from.v + h01 * u1 + h11 * h * v1;
  out.v.col(k) = (d00 / h) * (from.u - u1) + d10 * from.v + d11 * v1;
}

States Newmark::run(const VectorXd& times) const {
  const Index n = system_.u0.size();
  States out{MatrixXd(n, times.size()), MatrixXd(n, times.size()), {}, Status::ok, 0};
  State x{system_.u0, system_.v0, a0_};
  VectorXd w(n), z(n), b(n), u1(n), v1(n);
  Index k = 0;
  const double slack = 1e-9 * h_;  // output times that are a step's end up to rounding need no further step
  for (; k < times.size() && times[k] <= slack; ++k) out.u.col(k) = x.u, out.v.col(k) = x.v;
  for (long i = 0; k < times.size(); ++i) {
    const double t0 = static_cast<double>(i) * h_, t1 = static_cast<double>(i + 1) * h_;
    right_hand_side(x, factors_(t1), w, z, b);
    A_.solve(b, u1);
    u1 *= h_ * h_ / 4;
    v1.noalias() = (2 / h_) * (u1 - x.u) - x.v;
    for (; k < times.size() && times[k] <= t1 + slack; ++k)
      interpolate(x, u1, v1, std::min(1.0, (times[k] - t0) / h_), h_, out, k);
    x.a = (4 / (h_ * h_)) * (u1 - x.u) - (4 / h_) * x.v - x.a;
    x.u.swap(u1);
    x.v.swap(v1);
    ++out.work.steps, ++out.work.solves, ++out.work.load_evaluations;
    if (out.work.steps % 64 == 0 && !x.u.allFinite()) break;
  }
  while (out.n_valid < k && out.u.col(out.n_valid).allFinite() && out.v.col(out.n_valid).allFinite()) ++out.n_valid;
  if (out.n_valid < times.size()) out.status = Status::not_finite;
  out.work.factorisations = 1;
  return out;
}

}  // namespace

std::unique_ptr<Stepper> newmark(const System& system, double h) {
  if (!(h > 0)) throw std::invalid_argument("newmark: the time step must be positive");
  return std::make_unique<Newmark>(system, h);
}

}  // namespace mb
