#include "modal/frame/spin.h"

#include <cmath>
#include <optional>
#include <stdexcept>

#include "mechanics/algebra/dense_eigen.h"
#include "mechanics/system/static_response.h"

namespace mb {

namespace {

constexpr std::array<std::array<int, 2>, 6> pairs{{{0, 0}, {1, 1}, {2, 2}, {1, 2}, {2, 0}, {0, 1}}};

// J of what has the second moments S, in the order of the pairs:  tr(S) 1 - S.
Eigen::Matrix3d inertia_of(const Eigen::Vector<double, 6>& S) {
  Eigen::Matrix3d J;
  J << S[1] + S[2], -S[5], -S[4], -S[5], S[0] + S[2], -S[3], -S[4], -S[3], S[0] + S[1];
  return J;
}

// Omega.J Omega/2 = sum over pairs of S times these.
Eigen::Vector<double, 6> weights_of(const Vector3d& w) {
  return {(w.y() * w.y() + w.z() * w.z()) / 2,
          (w.z() * w.z() + w.x() * w.x()) / 2,
          (w.x() * w.x() + w.y() * w.y()) / 2,
          -w.y() * w.z(),
          -w.z() * w.x(),
          -w.x() * w.y()};
}

}  // namespace

SpinCoupling spin_coupling(const Matrix3Xd& X, const VectorXd& masses, const MatrixXd& Phi) {
  const Index m = X.cols(), r = Phi.cols();
  if (masses.size() != m || Phi.rows() != 3 * m)
    throw std::invalid_argument("spin coupling: points, masses and shapes differ in number");
  std::array<MatrixXd, 3> phi, weighted;
  for (Index a = 0; a < 3; ++a) {
    phi[static_cast<size_t>(a)] = Phi(Eigen::seqN(a, m, 3), Eigen::all);
    weighted[static_cast<size_t>(a)] = masses.asDiagonal() * phi[static_cast<size_t>(a)];
  }
  SpinCoupling coupling{MatrixXd(6, r), {}, {}};
  for (size_t k = 0; k < 6; ++k) {
    const auto a = static_cast<size_t>(pairs[k][0]), b = static_cast<size_t>(pairs[k][1]);
    coupling.A.row(static_cast<Index>(k)) =
        X.row(static_cast<Index>(a)) * weighted[b] + X.row(static_cast<Index>(b)) * weighted[a];
    const MatrixXd B = phi[a].transpose() * weighted[b];
    coupling.H[k] = B + B.transpose();
    if (k >= 3) coupling.D[k - 3] = B - B.transpose();
  }
  return coupling;
}

SpinCoupling spin_coupling(const FullModel& full, const MatrixXd& Phi, bool stiffened, double shift) {
  const System& system = full.system();
  const Index n = system.u0.size(), r = Phi.cols();
  // Fields over the mesh are products of polynomials there: M integrates them.
  const MatrixXd places = full.places();
  const auto along = [&](const auto& field, Index component, Index towards) {  // n x columns of field's component
    MatrixXd out = MatrixXd::Zero(n, field.cols());
    out(Eigen::seqN(towards, n / 3, 3), Eigen::all) = field(Eigen::seqN(component, n / 3, 3), Eigen::all);
    return out;
  };
  SpinCoupling coupling{MatrixXd(6, r), {}, {}};
  std::optional<ShiftedFactor> factor;
  if (stiffened) factor.emplace(shifted_factor(system, shift));
  const VectorXd compliance = (Phi.transpose() * (system.K * Phi)).diagonal().cwiseSqrt().cwiseInverse();
  for (size_t k = 0; k < 6; ++k) {
    const Index a = pairs[k][0], b = pairs[k][1];
    const VectorXd force = system.M * (along(places, b, a) + along(places, a, b)).col(0);
    coupling.A.row(static_cast<Index>(k)) = force.transpose() * Phi;
    const MatrixXd B = along(Phi, a, a).transpose() * (system.M * along(Phi, b, a));
    coupling.H[k] = B + B.transpose();
    if (k >= 3) coupling.D[k - 3] = B - B.transpose();
    if (!stiffened) continue;
    const VectorXd u = inertia_relief(system, *factor, force);
    const MatrixXd G = Phi.transpose() * (full.stress_stiffness(u) * Phi), G_scaled = G * compliance.asDiagonal();
    coupling.H[k] -= G;
    coupling.s += spectral_norm(compliance.asDiagonal() * G_scaled) / 2;
    coupling.g += spectral_norm(G_scaled) / 2;
  }
  return coupling;
}

namespace {

Spin rigid_spin(const FloatingBody& body, const BodyState& state) {
  const VectorXd nothing = VectorXd::Zero(body.n_modes());
  return {body.inertia.ldlt().solve(state.Q.conjugate() * state.L), state.p, nothing, nothing};
}

}  // namespace

Spin spin(const FloatingBody& body, const BodyState& state) {
  if (!body.coupling) return rigid_spin(body, state);
  const SpinCoupling& of = *body.coupling;
  const Index r = body.n_modes();
  MatrixXd HQ(r, 6), C(3, r);  // columns H q; C e_j = sum_i q_i D_ij
  Eigen::Vector<double, 6> S = of.A * state.q;
  for (size_t k = 0; k < 6; ++k) {
    HQ.col(static_cast<Index>(k)).noalias() = of.H[k] * state.q;
    S[static_cast<Index>(k)] += HQ.col(static_cast<Index>(k)).dot(state.q) / 2;
  }
  for (size_t c = 0; c < 3; ++c) C.row(static_cast<Index>(c)).noalias() = -(of.D[c] * state.q).transpose();
  const Eigen::Matrix3d J = body.inertia + inertia_of(S);
  const Vector3d Lambda = state.Q.conjugate() * state.L;
  Spin now;
  now.Omega = Eigen::Matrix3d(J - C * C.transpose()).ldlt().solve(Lambda - C * state.p);
  now.carried.noalias() = C.transpose() * now.Omega;
  now.rate = state.p - now.carried;
  const Eigen::Vector<double, 6> w = weights_of(now.Omega);
  now.force.noalias() = of.A.transpose() * w;
  now.force.noalias() += HQ * w;
  for (size_t c = 0; c < 3; ++c) now.force.noalias() += now.Omega[static_cast<Index>(c)] * (of.D[c] * now.rate);
  return now;
}

Vector3d angular_velocity(const FloatingBody& body, const BodyState& state) {
  if (!body.free) return Vector3d::Zero();
  if (body.coupling) return state.Q * spin(body, state).Omega;
  if (state.L.isZero(0)) return Vector3d::Zero();
  return state.Q * body.inertia.ldlt().solve(state.Q.conjugate() * state.L);
}

VectorXd rates(const FloatingBody& body, const BodyState& state) {
  return body.coupling ? spin(body, state).rate : state.p;
}

double mechanical_energy(const FloatingBody& body, const BodyState& state) {
  double energy = -body.weight.dot(state.q);
  for (Index i = 0; i < body.n_modes(); ++i)
    energy += 0.5 * body.modes[static_cast<size_t>(i)].k * state.q[i] * state.q[i];
  if (!body.free) return energy + 0.5 * state.p.squaredNorm();
  if (body.coupling) {
    const Spin now = spin(body, state);
    energy += 0.5 * (state.Q * now.Omega).dot(state.L) + 0.5 * now.rate.dot(state.p);
  } else {
    energy += 0.5 * angular_velocity(body, state).dot(state.L) + 0.5 * state.p.squaredNorm();
  }
  return energy + 0.5 * body.mass * state.v.squaredNorm() - body.mass * body.gravity.dot(state.c);
}

}  // namespace mb
