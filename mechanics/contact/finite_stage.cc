#include "mechanics/contact/finite_stage.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mb {

namespace {

using Eigen::Matrix3d;

constexpr double slow = 0.3;            // [-] rate of convergence
constexpr double turned_little = 0.02;  // [rad]
constexpr double rounding = 1e-14;
constexpr int max_iterations = 30, max_renewals = 10, max_halvings = 6;

// Of the error, after an iteration that changed v by so much. The rate of an earlier stage may be far from this one's:
// what it foretells is not yet seen, the change itself is.
double left(double change, double rate, bool measured) {
  const double foretold = rate < 1 ? change * rate / (1 - rate) : change / rounding;
  return measured ? foretold : std::max(change, foretold);
}

// [m/s] What rounding leaves of v, and of (u - a)/gamma.
double unresolved(const VectorXd& v, const VectorXd& a, double gamma) {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  return std::max(rounding * v.lpNorm<Eigen::Infinity>(), epsilon * a.lpNorm<Eigen::Infinity>() / gamma);
}

void turn_by(const Matrix3d& Q, Eigen::Ref<VectorXd> x) {
  for (Index i = 0; i < x.size(); i += 3) x.segment<3>(i) = (Q * x.segment<3>(i)).eval();
}

}  // namespace

void TurnedInverse::turn_back(VectorXd& x) const {
  for (const auto& [first, n, Q] : turned_by_) turn_by(Q.transpose(), x.segment(first, n));
}
void TurnedInverse::turn_forth(Eigen::Ref<VectorXd> x) const {
  for (const auto& [first, n, Q] : turned_by_) turn_by(Q, x.segment(first, n));
}

bool TurnedInverse::make(const VectorXd& u, double gamma) {
  const auto [alpha, beta] = system_->damping;
  SparseMatrix A = 0 * system_->K;
  if (!system_->stored_energy->add_tangent(u, gamma * gamma, gamma, A)) return false;
  A += (1 + gamma * alpha) * system_->M;
  A.makeCompressed();
  gamma_ = gamma;
  made_at_ = system_->stored_energy->turns(u);
  turned_by_.clear();
  correct(u);
  if (factor_) {
    try {
      factor_->refactor(A);
    } catch (...) {
      factor_.reset();  // it is lost
      throw;
    }
  } else {
    factor_.emplace(A);
  }
  return true;
}

void TurnedInverse::correct(const VectorXd& u) {
  if (system_->damping.alpha != 0) R_ = force_->rigid(u);
}

bool TurnedInverse::turn(const VectorXd& u) {
  std::vector<Turn> now = system_->stored_energy->turns(u);
  double off = 0;
  for (size_t i = 0; i < now.size(); ++i) {
    now[i].Q *= made_at_[i].Q.transpose();
    const Matrix3d known = turned_by_.empty() ? Matrix3d(Matrix3d::Identity()) : turned_by_[i].Q;
    off = std::max(off, (now[i].Q - known).norm());
  }
  if (off < turned_little * std::sqrt(2.0)) return false;
  turned_by_ = now;
  correct(u);
  return true;
}

void TurnedInverse::solve(const VectorXd& b, VectorXd& x) const {
  VectorXd rigid;
  const double part = gamma_ * system_->damping.alpha;
  if (R_.cols() > 0) rigid = part / (1 + part) * (R_ * (R_.transpose() * b));
  turned_ = b;
  turn_back(turned_);
  x.resize(b.size());
  factor_->solve(turned_.data(), x.data());
  turn_forth(x);
  if (R_.cols() > 0) x += rigid;
}

MatrixXd TurnedInverse::columns(const std::vector<Index>& which, Index n) const {
  MatrixXd B = MatrixXd::Zero(n, static_cast<Index>(which.size()));
  const double part = gamma_ * system_->damping.alpha;
  for (size_t k = 0; k < which.size(); ++k) {
    const Index j = which[k];
    const auto turn =
        std::ranges::find_if(turned_by_, [&](const Turn& t) { return j >= t.first && j < t.first + t.n; });
    if (turn == turned_by_.end()) {
      B(j, static_cast<Index>(k)) = 1;
      continue;
    }
    const Index axis = (j - turn->first) % 3;
    B.col(static_cast<Index>(k)).segment<3>(j - axis) = turn->Q.row(axis).transpose();
  }
  MatrixXd X = factor_->solve(B);
  for (Index k = 0; k < X.cols(); ++k) {
    turn_forth(X.col(k));
    if (R_.cols() > 0) X.col(k) += part / (1 + part) * (R_ * R_.row(which[static_cast<size_t>(k)]).transpose());
  }
  return X;
}

FiniteStage::FiniteStage(const System& system, const FiniteForce& force, const ContactForces* contact)
    : system_(system), force_(force), contact_(contact) {}

// At rest where the tangent at u is not positive definite, which steps that are short enough do not meet.
bool FiniteStage::renew(Kept& kept, const VectorXd& u, Outcome& outcome) {
  if (kept.contact) kept.contact->forget();
  kept.rate = 1;
  ++outcome.factorisations;
  try {
    return kept.inverse.make(u, kept.gamma);
  } catch (const std::runtime_error&) {
    ++outcome.factorisations;
    if (!kept.inverse.make(VectorXd::Zero(u.size()), kept.gamma)) return false;
    kept.inverse.turn(u);
    return true;
  }
}

FiniteStage::Kept* FiniteStage::tangent_at(const VectorXd& u, double gamma, Outcome& outcome) {
  const auto known = std::ranges::find_if(kept_, [&](const Kept& k) { return std::abs(gamma / k.gamma - 1) <= 1e-12; });
  if (known != kept_.end()) {
    kept_.splice(kept_.begin(), kept_, known);
    Kept& kept = kept_.front();
    if (kept.inverse.turn(u) && kept.contact) kept.contact->forget();
    return &kept;
  }
  if (kept_.size() == most) {
    kept_.splice(kept_.begin(), kept_, std::prev(kept_.end()));
    kept_.front().gamma = gamma;
  } else {
    kept_.push_front({gamma, TurnedInverse(system_, force_), {}, 1});
    if (contact_) kept_.front().contact.emplace(*contact_, system_.u0.size());
  }
  if (renew(kept_.front(), u, outcome)) return &kept_.front();
  kept_.pop_front();
  return nullptr;
}

// r = M v - b + gamma r(u, v), of the step without contact
bool FiniteStage::residual(double t, const VectorXd& b, const VectorXd& a, double gamma, const VectorXd& v) {
  u_.noalias() = a + gamma * v;
  if (!force_.resistance(t, u_, v, f_)) return false;
  r_.resize(v.size());
  force_.mass(v, r_);
  r_ += gamma * f_ - b;
  return true;
}

// next_ = v - A^-1 r and what contact adds: false where contact finds no balance.
bool FiniteStage::iterate(Kept& kept, const VectorXd& a, double contact_tolerance, const VectorXd& v,
                          Outcome& outcome) {
  ++outcome.iterations;
  ++outcome.solves;
  kept.inverse.solve(r_, next_);
  next_ = v - next_;
  if (!kept.contact) return std::isfinite(next_.sum());
  const auto contact = kept.contact->solve(kept.inverse, a, kept.gamma, contact_tolerance, next_);
  outcome.solves += contact.solves;
  return contact.converged && std::isfinite(next_.sum());
}

FiniteStage::Outcome FiniteStage::solve(double t, const VectorXd& b, const VectorXd& a, double gamma, double tolerance,
                                        double contact_tolerance, VectorXd& v) {
  constexpr double unknown = std::numeric_limits<double>::infinity();
  Outcome outcome;
  if (!residual(t, b, a, gamma, v)) return outcome.inverted = true, outcome;
  Kept* kept = tangent_at(u_, gamma, outcome);
  if (!kept) return outcome.inverted = true, outcome;
  double before = unknown;
  for (int renewals = 0; outcome.iterations < max_iterations;) {
    if (!iterate(*kept, a, contact_tolerance, v, outcome)) return outcome;
    const double change = (next_ - v).lpNorm<Eigen::Infinity>();
    const bool measured = std::isfinite(before);
    if (measured) kept->rate = change / before;
    if (left(change, kept->rate, measured) <= tolerance || change <= unresolved(next_, a, gamma)) {
      v = next_;
      outcome.converged = true;
      return outcome;
    }
    // Less of the way where all of it inverts.
    before = change;
    for (int halving = 0; !residual(t, b, a, gamma, next_); ++halving) {
      if (halving == max_halvings) return outcome.inverted = true, outcome;
      next_ = 0.5 * (v + next_);
      before = unknown;
    }
    v = next_;
    if (!measured || kept->rate <= slow) continue;
    if (renewals++ == max_renewals) return outcome;
    if (!renew(*kept, u_, outcome)) return kept_.pop_front(), outcome.inverted = true, outcome;
    before = unknown;
  }
  return outcome;
}

}  // namespace mb
