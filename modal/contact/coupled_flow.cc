#include "modal/contact/coupled_flow.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace mb {

namespace {

constexpr double order_gain = 32;  // [-] 2^5: by how much half a step lessens its error
constexpr int deepest = 40;        // halvings of the longest step
constexpr long most_steps = 2'000'000;

// Of rotation and deformation; of a state without either 1, and no error there is.
double internal_energy(const FloatingBody& body, const BodyState& state) {
  const Spin now = spin(body, state);
  double twice = (state.Q * now.Omega).dot(state.L) + now.rate.dot(state.p);
  for (Index i = 0; i < body.n_modes(); ++i) twice += body.modes[static_cast<size_t>(i)].k * state.q[i] * state.q[i];
  return twice > 0 ? twice / 2 : 1;
}

double distance(const FloatingBody& body, const BodyState& a, const BodyState& b, double energy) {
  double modes = (a.p - b.p).squaredNorm();
  for (Index i = 0; i < body.n_modes(); ++i)
    modes += body.modes[static_cast<size_t>(i)].k * std::pow(a.q[i] - b.q[i], 2);
  return std::sqrt(modes / (2 * energy) + (a.Q.coeffs() - b.Q.coeffs()).squaredNorm());
}

}  // namespace

CoupledFlow::CoupledFlow(const FloatingBody& body, double h) : body_(body), h_(h) {
  const Index r = body.n_modes();
  for (VectorXd* x : {&damping_, &C_, &S_, &C_dot_, &S_dot_, &P_}) x->resize(r);
  for (Index i = 0; i < r; ++i) {
    const Roots& mode = body.modes[static_cast<size_t>(i)];
    const Response x = response(mode, h / 2);
    damping_[i] = 2 * mode.h;
    C_[i] = x.C, S_[i] = x.S, C_dot_[i] = x.C_dot, S_dot_[i] = x.S_dot, P_[i] = x.P;
  }
}

// q' = pi - C^T Omega,   pi' = -lambda q - c pi + c C^T Omega + force
CoupledFlow::Slope CoupledFlow::slope(const BodyState& y, const VectorXd& b) const {
  Spin now = spin(body_, y);
  const Eigen::Quaterniond turn = y.Q * Eigen::Quaterniond(0, now.Omega.x(), now.Omega.y(), now.Omega.z());
  return {-now.carried, now.force + damping_.cwiseProduct(now.carried) - b, turn.coeffs() / 2};
}

BodyState CoupledFlow::flow(const BodyState& y, const VectorXd& b) const {
  BodyState next = y;
  next.q = C_.cwiseProduct(y.q) + S_.cwiseProduct(y.p) + P_.cwiseProduct(b);
  next.p = C_dot_.cwiseProduct(y.q) + S_dot_.cwiseProduct(y.p) + S_.cwiseProduct(b);
  return next;
}

CoupledFlow::Slope CoupledFlow::flow(const Slope& x) const {
  return {C_.cwiseProduct(x.q) + S_.cwiseProduct(x.p), C_dot_.cwiseProduct(x.q) + S_dot_.cwiseProduct(x.p), x.Q};
}

BodyState CoupledFlow::add(BodyState y, const Slope& x, double part) {
  y.q += part * x.q;
  y.p += part * x.p;
  y.Q.coeffs() += part * x.Q;
  y.Q.normalize();
  return y;
}

BodyState CoupledFlow::advance(BodyState state) const {
  const Spin at_start = spin(body_, state);
  const VectorXd b = at_start.force + damping_.cwiseProduct(at_start.carried);
  const BodyState half = flow(state, b);
  const Slope k1 = flow(slope(state, b)), k2 = slope(add(half, k1, h_ / 2), b), k3 = slope(add(half, k2, h_ / 2), b),
              k3_on = flow(k3);
  const BodyState whole = flow(half, b);
  const Slope k4 = slope(add(whole, k3_on, h_), b), k1_on = flow(k1), k2_on = flow(k2);
  return add(whole,
             {k1_on.q + 2 * (k2_on.q + k3_on.q) + k4.q, k1_on.p + 2 * (k2_on.p + k3_on.p) + k4.p,
              k1_on.Q + 2 * (k2_on.Q + k3_on.Q) + k4.Q},
             h_ / 6);
}

CoupledFlight::CoupledFlight(const FloatingBody& body, const BodyState& start, double t0, double tolerance)
    : body_(body), tolerance_(tolerance), end_(t0), last_(start) {
  if (!(tolerance > 0)) throw std::invalid_argument("coupled flight: the tolerance must be positive");
  double fastest = angular_velocity(body, start).norm();
  for (const Roots& mode : body.modes) fastest = std::max(fastest, mode.omega);
  longest_ = fastest > 0 ? 16 * pi / fastest : 1;
  level_ = 4;
}

const CoupledFlow& CoupledFlight::flow(int level) const {
  return flows_.try_emplace(level, body_, std::ldexp(longest_, -level)).first->second;
}

// Two half steps stand where the whole one agrees.
void CoupledFlight::extend() const {
  const double energy = internal_energy(body_, last_);
  for (;;) {
    if (level_ > deepest || n_steps_ >= most_steps || !is_finite(last_)) {
      failed_ = true;
      return;
    }
    const double h = std::ldexp(longest_, -level_);
    const BodyState whole = flow(level_).advance(last_);
    BodyState middle = flow(level_ + 1).advance(last_), end = flow(level_ + 1).advance(middle);
    n_steps_ += 3;
    const double error = distance(body_, whole, end, energy) / 15;
    if (!(error <= tolerance_)) {
      ++level_;
      continue;
    }
    nodes_.push_back({end_, std::move(last_)});
    nodes_.push_back({end_ + h / 2, std::move(middle)});
    last_ = std::move(end);
    end_ += h;
    if (level_ > 0 && error * 2 * order_gain < tolerance_) --level_;
    return;
  }
}

BodyState CoupledFlight::at(double t) const {
  while (t >= end_ && !failed_) extend();
  if (t >= end_) return last_;
  const auto after = std::upper_bound(nodes_.begin(), nodes_.end(), t, [](double x, const Node& n) { return x < n.t; });
  if (after == nodes_.begin()) return nodes_.empty() ? last_ : nodes_.front().state;
  const Node& node = *std::prev(after);
  return t == node.t ? node.state : CoupledFlow(body_, t - node.t).advance(node.state);
}

}  // namespace mb
