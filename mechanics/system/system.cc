#include "mechanics/system/system.h"

#include <fmt/format.h>

#include <limits>
#include <stdexcept>

#include "mechanics/system/stored_energy.h"

namespace mb {

void require_consistent(const System& system) {
  const Index n = system.M.rows();
  const auto is_square = [n](const SparseMatrix& A) { return A.rows() == n && A.cols() == n; };
  const ModalDamping& modal = system.modal_damping;
  const bool masses = is_square(system.M) && (system.lumped_mass.rows() == 0 || is_square(system.lumped_mass));
  const bool loads =
      system.F.cols() == static_cast<Index>(system.s.size()) && (system.s.empty() || system.F.rows() == n);
  const bool rigid = system.R.cols() == 0 || (system.R.rows() == n && system.R.cols() <= n);
  const bool ratios = modal.W.cols() == modal.d.size() && (modal.d.size() == 0 || modal.W.rows() == n);
  const bool turning = system.follows.empty() || system.follows.size() == system.s.size();
  const bool states = system.u0.size() == n && system.v0.size() == n;
  const auto refuse = [n](const char* which) {
    throw std::invalid_argument(fmt::format("system of {} unknowns: sizes of {} disagree", n, which));
  };
  if (!masses || !is_square(system.K)) refuse("M, lumped mass and K");
  if (system.viscous.rows() != 0 && !is_square(system.viscous)) refuse("M and V");
  if (!loads) refuse("F and s");
  if (!turning) refuse("F and follows");
  if (!rigid) refuse("R and M");
  if (!ratios) refuse("W and d of modal damping");
  if (!states) refuse("u0, v0 and M");
}

bool is_damped(const System& system) {
  return system.damping.alpha != 0 || system.damping.beta != 0 || (system.modal_damping.d.array() != 0).any() ||
         system.viscous.nonZeros() > 0;
}

VectorXd apply_damping(const System& system, const VectorXd& v) {
  VectorXd Cv = VectorXd::Zero(v.size());
  if (system.damping.alpha != 0) {
    VectorXd w = v;
    if (system.R.cols() > 0) w.noalias() -= system.R * (system.R.transpose() * (system.M * v)).eval();
    Cv += system.damping.alpha * (system.M * w);
  }
  if (system.damping.beta != 0) Cv += system.damping.beta * (system.K * v);
  const auto& [W, d] = system.modal_damping;
  if (d.size() > 0) Cv += W * d.cwiseProduct(W.transpose() * v);
  if (system.viscous.rows() > 0) Cv += system.viscous * v;
  return Cv;
}

System with_lumped_mass(const System& system) {
  if (system.lumped_mass.rows() == 0) throw std::invalid_argument("the system has no lumped mass");
  System lumped = system;
  lumped.M = system.lumped_mass;
  if (lumped.R.cols() > 0) {
    const MatrixXd gram = lumped.R.transpose() * (lumped.M * lumped.R);
    lumped.R = gram.llt().matrixU().solve<Eigen::OnTheRight>(lumped.R);
  }
  return lumped;
}

System with_consistent_mass(const System& system) {
  System consistent = system;
  consistent.lumped_mass.resize(0, 0);
  return consistent;
}

LoadFactors::LoadFactors(const System& system) : s_(static_cast<Index>(system.s.size())) {
  for (const History& history : system.s) histories_.push_back(evaluator(history));
}

const VectorXd& LoadFactors::operator()(double t) const {
  for (size_t l = 0; l < histories_.size(); ++l) s_[static_cast<Index>(l)] = histories_[l](t);
  return s_;
}

double kinetic_energy(const System& system, const VectorXd& v) { return 0.5 * v.dot(system.M * v); }
double strain_energy(const System& system, const VectorXd& u) {
  return system.stored_energy ? system.stored_energy->energy(u) : 0.5 * u.dot(system.K * u);
}

void require_linear(const System& system, const char* integrator) {
  if (system.stored_energy)
    throw std::invalid_argument(
        fmt::format("{}: for linear systems; bodies of finite kinematics take newmark or "
                    "sundials",
                    integrator));
}

void blank_rest(States& states) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Index n_left = states.u.cols() - states.n_valid;
  states.u.rightCols(n_left).setConstant(nan);
  states.v.rightCols(n_left).setConstant(nan);
}

States Stepper::averages(const VectorXd&, double) const {
  throw std::invalid_argument("this integrator has no exact averages over time: only closed forms have");
}

Work operator+(const Work& a, const Work& b) {
  return {a.steps + b.steps, a.rejected + b.rejected, a.factorisations + b.factorisations, a.solves + b.solves,
          a.load_evaluations + b.load_evaluations};
}

const char* to_string(Status status) {
  switch (status) {
    case Status::ok:
      return "ok";
    case Status::not_finite:
      return "not_finite";
    case Status::no_convergence:
      return "no_convergence";
    case Status::too_many_steps:
      return "too_many_steps";
    case Status::unstable:
      return "unstable";
    case Status::inverted:
      return "inverted";
  }
  return "unknown";
}

}  // namespace mb
