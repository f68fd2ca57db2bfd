#include "modal/bases/mesh_radius.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mechanics/algebra/cholesky.h"
#include "mechanics/algebra/dense_eigen.h"
#include "mechanics/algebra/noise.h"
#include "mechanics/system/system.h"
#include "modal/bases/arpack.h"

namespace mb {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// phi of the largest eigenvalue of M^-1 A, phi^T M phi = 1. A x: symmetric.
VectorXd largest_mode(const SparseMatrix& M, const Cholesky& mass,
                      const std::function<VectorXd(const VectorXd& x)>& A) {
  const auto n = static_cast<int>(M.rows());
  VectorXd phi;
  if (n < 12) {
    MatrixXd dense(n, n);
    for (Index j = 0; j < n; ++j) dense.col(j) = A(VectorXd::Unit(n, j));
    phi = generalized_eigen(dense, MatrixXd(M)).value().vectors.col(n - 1);
  } else {
    const Operator apply = [&](const VectorXd& x, const VectorXd&) { return mass.solve(A(x)); };
    const InnerProduct inner_product = [&](const VectorXd& x) -> VectorXd { return M * x; };
    phi = largest_ritz(apply, inner_product, 1, std::min(n, 40), 1e-7, uniform_noise(n, 3)).vectors.col(0);
  }
  return phi / std::sqrt(phi.dot(M * phi));
}

// Which part of C is taken by the mean of both rates.
enum class Implicit { none, of_mass, all };

Implicit implicit_part(const System& system, const std::string& integrator) {
  if (integrator == "symplectic-euler" || system.stored_energy) return Implicit::none;
  return system.lumped_mass.rows() > 0 ? Implicit::of_mass : Implicit::all;
}

struct Damped {
  VectorXd lagging, implicit;  // C_l x, C_i x
};

// The pencil of the header. system: its mass is the one stepped with.
class Growth {
 public:
  Growth(const System& system, Implicit part, double h) : system_(system), part_(part), h_(h), mass_(system.M) {}

  double radius(int most_rounds) const {
    double mu = 1;
    for (int i = 0; i < most_rounds; ++i) {
      const auto against = [&](const VectorXd& x) { return against_mass(x, mu); };
      const double next = of_mode(largest_mode(system_.M, mass_, against));
      if (!(next > mu * (1 + 1e-10))) return mu;  // rises not at all, or by rounding of Lanczos
      mu = next;
    }
    return nan;
  }

 private:
  Damped damped(const VectorXd& x) const {
    VectorXd all = apply_damping(system_, x), none = VectorXd::Zero(x.size());
    if (part_ == Implicit::none) return {std::move(all), std::move(none)};
    if (part_ == Implicit::all) return {std::move(none), std::move(all)};
    VectorXd by_mass = system_.M * x;
    by_mass -= system_.M * (system_.R * (system_.R.transpose() * by_mass));
    by_mass *= system_.damping.alpha;
    return {all - by_mass, by_mass};
  }
  // What stands against M: the largest eigenvalue passes 1 where the step is unstable.
  VectorXd against_mass(const VectorXd& x, double mu) const {
    const auto [lagging, implicit] = damped(x);
    return (mu * h_ * h_ / ((1 + mu) * (1 + mu))) * (system_.K * x) + (h_ / (1 + mu)) * lagging -
           (h_ / 2 * (mu - 1) / (mu + 1)) * implicit;
  }
  // The larger root of (1 + h c_i/2) mu^2 + (2 - h c_l - h^2 k) mu + 1 - h c_l - h c_i/2; NaN where there is none.
  double of_mode(const VectorXd& phi) const {
    const auto [lagging, implicit] = damped(phi);
    const double c = h_ * phi.dot(lagging), c_i = h_ / 2 * phi.dot(implicit), k = h_ * h_ * phi.dot(system_.K * phi);
    const double half = (c + k) / 2 - 1;
    return (half + std::sqrt(half * half - (1 + c_i) * (1 - c - c_i))) / (1 + c_i);
  }

  const System& system_;
  Implicit part_;
  double h_;
  Cholesky mass_;
};

double radius_of(const SteppedMode& mode, const Scheme& scheme, double h) {
  return spectral_radius(scheme.amplification(mode.omega * h, mode.zeta));
}

double radius_of_explicit_euler(const System& system, double h) {
  const Scheme& euler = scheme("explicit-euler");
  double largest = radius_of(highest_mode(system), euler, h);
  const MatrixXd& W = system.modal_damping.W;
  if (W.cols() == 0 && system.viscous.rows() == 0) return largest;
  const Cholesky mass(system.M);
  const auto along = [&](const VectorXd& phi) {  // phi^T M phi = 1
    const double omega = std::sqrt(phi.dot(system.K * phi));
    const double zeta = std::max(0., phi.dot(apply_damping(system, phi)) / (2 * omega));
    largest = std::max(largest, radius_of({omega, zeta, {}, {}}, euler, h));
  };
  for (Index j = 0; j < W.cols(); ++j) {
    const VectorXd phi = mass.solve(VectorXd(W.col(j)));
    along(phi / std::sqrt(phi.dot(system.M * phi)));
  }
  if (system.viscous.rows() > 0)
    along(largest_mode(system.M, mass, [&](const VectorXd& x) { return apply_damping(system, x); }));
  return largest;
}

// s of the header.
std::optional<double> sign_of_damping(const Scheme& scheme) {
  if (scheme.name == "symplectic-euler" || scheme.name == "central-difference, lagged damping") return -1;
  if (scheme.name == "central-difference") return 0;
  if (scheme.name == "symplectic-euler, implicit damping") return 1;
  return {};
}

}  // namespace

double mesh_radius(const System& system, const std::string& integrator, double h, int most_rounds) {
  const System seen = system.lumped_mass.rows() > 0 ? with_lumped_mass(system) : system;
  if (integrator == "explicit-euler") return radius_of_explicit_euler(seen, h);
  if (integrator != "symplectic-euler" && integrator != "central-difference") return nan;
  return Growth(seen, implicit_part(system, integrator), h).radius(most_rounds);
}

std::optional<MeshLimit> mesh_limit(const System& system, const Scheme& scheme, int most_rounds) {
  const auto sign = sign_of_damping(scheme);
  if (!sign) return {};
  const Cholesky mass(system.M);
  MeshLimit limit{0, highest_mode(system)};
  const auto limit_of = [&](const SteppedMode& mode) {
    return 2 / (mode.omega * (std::hypot(1, *sign * mode.zeta) - *sign * mode.zeta));
  };
  limit.dt = limit_of(limit.mode);
  for (int i = 0; i < most_rounds; ++i) {
    const double h = limit.dt;
    const VectorXd phi = largest_mode(system.M, mass, [&](const VectorXd& x) -> VectorXd {
      return h * h * (system.K * x) - 2 * *sign * h * apply_damping(system, x);
    });
    const double omega = std::sqrt(phi.dot(system.K * phi));
    const SteppedMode mode{omega, phi.dot(apply_damping(system, phi)) / (2 * omega), phi, system.M * phi};
    if (!(limit_of(mode) < h * (1 - 1e-10))) return limit;
    limit = {limit_of(mode), mode};
  }
  return {};
}

}  // namespace mb
