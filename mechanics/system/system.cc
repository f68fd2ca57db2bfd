#include "mechanics/system/system.h"

namespace mb {

VectorXd apply_damping(const System& system, const VectorXd& v) {
  VectorXd Cv = VectorXd::Zero(v.size());
  if (system.damping.alpha != 0) {
    VectorXd w = v;
    if (system.R.cols() > 0) w.noalias() -= system.R * (system.R.transpose() * (system.M * v)).eval();
    Cv += system.damping.alpha * (system.M * w);
  }
  if (system.damping.beta != 0) Cv += system.damping.beta * (system.K * v);
  return Cv;
}

LoadFactors::LoadFactors(const System& system) : s_(static_cast<Index>(system.s.size())) {
  for (const History& history : system.s) histories_.push_back(evaluator(history));
}

const VectorXd& LoadFactors::operator()(double t) const {
  for (size_t l = 0; l < histories_.size(); ++l) s_[static_cast<Index>(l)] = histories_[l](t);
  return s_;
}

double kinetic_energy(const System& system, const VectorXd& v) { return 0.5 * v.dot(system.M * v); }
double strain_energy(const System& system, const VectorXd& u) { return 0.5 * u.dot(system.K * u); }

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
  }
  return "unknown";
}

}  // namespace mb
