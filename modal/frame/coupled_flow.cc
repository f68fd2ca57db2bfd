#include "modal/frame/coupled_flow.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "modal/frame/frame_loads.h"

namespace mb {

namespace {

constexpr double order_gain = 32;  // [-] 2^5: by how much half a step lessens its error
constexpr int deepest = 40;        // halvings of the longest step
constexpr long most_steps = 2'000'000;

// Of rotation and deformation.
double internal_energy(const FloatingBody& body, const BodyState& state) {
  const Spin now = spin(body, state);
  double twice = (state.Q * now.Omega).dot(state.L) + now.rate.dot(state.p);
  for (Index i = 0; i < body.n_modes(); ++i) twice += body.modes[static_cast<size_t>(i)].k * state.q[i] * state.q[i];
  return twice / 2;
}

double distance(const FloatingBody& body, const BodyState& a, const BodyState& b, double energy) {
  double modes = (a.p - b.p).squaredNorm();
  for (Index i = 0; i < body.n_modes(); ++i)
    modes += body.modes[static_cast<size_t>(i)].k * std::pow(a.q[i] - b.q[i], 2);
  if (!(energy > 0)) return (a.Q.coeffs() - b.Q.coeffs()).norm();  // neither moves
  return std::sqrt(modes / (2 * energy) + (a.Q.coeffs() - b.Q.coeffs()).squaredNorm());
}

}  // namespace

CoupledFlow::CoupledFlow(const FloatingBody& body, double h) : body_(body), h_(h) {
  const Index r = body.n_modes();
  for (VectorXd* x : {&damping_, &C_, &S_, &C_dot_, &S_dot_, &P_, &R_}) x->resize(r);
  for (Index i = 0; i < r; ++i) {
    const Roots& mode = body.modes[static_cast<size_t>(i)];
    const Response x = response(mode, h / 2);
    damping_[i] = 2 * mode.h;
    C_[i] = x.C, S_[i] = x.S, C_dot_[i] = x.C_dot, S_dot_[i] = x.S_dot, P_[i] = x.P, R_[i] = x.R;
  }
}

CoupledFlow::Slope CoupledFlow::drive(const BodyState& y, double t, double start) const {
  const Spin now = spin(body_, y);
  const Eigen::Quaterniond turn = y.Q * Eigen::Quaterniond(0, now.Omega.x(), now.Omega.y(), now.Omega.z());
  const Vector3d none = Vector3d::Zero();
  Slope all{-now.carried, now.force, turn.coeffs() / 2, none, none, none};
  if (body_.loads) {
    const FrameForce load = body_.loads->at(t, start, y.Q, y.q);
    all.p += load.modal;
    all.c = y.v;
    all.v = y.Q * load.force / body_.mass + body_.gravity;
    all.L = y.Q * load.torque;
  }
  all.p -= damping_.cwiseProduct(all.q);
  return all;
}

// Through the start and where constant forces would lead; frame: at_start without what drives the modes.
CoupledFlow::Lines CoupledFlow::lines(const BodyState& y, double t, const Slope& at_start, const Slope& frame) const {
  const VectorXd none = VectorXd::Zero(body_.n_modes());
  Lines from{t, at_start.q, at_start.p + damping_.cwiseProduct(at_start.q), none, none};
  if (h_ == 0) return from;
  const Slope at_end = drive(add(flow(flow(y, from), from), frame, h_), t + h_, t);
  from.g_rate = (at_end.q - from.g) / h_;
  from.f_rate = (at_end.p + damping_.cwiseProduct(at_end.q) - from.f) / h_;
  return from;
}

CoupledFlow::Slope CoupledFlow::slope(const BodyState& y, double t, const Lines& lines) const {
  Slope rest = drive(y, t, lines.t);
  const Lines now = lines.later(t - lines.t);
  rest.p -= now.f - damping_.cwiseProduct(now.g);
  rest.q -= now.g;
  return rest;
}

// With r = q' = pi + g:  r' = -lambda q - c r + f + g'.
BodyState CoupledFlow::flow(const BodyState& y, const Lines& lines) const {
  BodyState next = y;
  const VectorXd r = y.p + lines.g, f = lines.f + lines.g_rate;
  next.q = C_.cwiseProduct(y.q) + S_.cwiseProduct(r) + P_.cwiseProduct(f) + R_.cwiseProduct(lines.f_rate);
  next.p = C_dot_.cwiseProduct(y.q) + S_dot_.cwiseProduct(r) + S_.cwiseProduct(f) + P_.cwiseProduct(lines.f_rate);
  next.p -= lines.g + (h_ / 2) * lines.g_rate;
  return next;
}

CoupledFlow::Slope CoupledFlow::flow(const Slope& x) const {
  return {C_.cwiseProduct(x.q) + S_.cwiseProduct(x.p),
          C_dot_.cwiseProduct(x.q) + S_dot_.cwiseProduct(x.p),
          x.Q,
          x.c,
          x.v,
          x.L};
}

BodyState CoupledFlow::add(BodyState y, const Slope& x, double part) {
  y.q += part * x.q;
  y.p += part * x.p;
  y.Q.coeffs() += part * x.Q;
  y.Q.normalize();
  y.c += part * x.c;
  y.v += part * x.v;
  y.L += part * x.L;
  return y;
}

// k1 + 2 k2 + 2 k3 + k4
CoupledFlow::Slope CoupledFlow::weighted(const Slope& k1, const Slope& k2, const Slope& k3, const Slope& k4) {
  return {k1.q + 2 * (k2.q + k3.q) + k4.q, k1.p + 2 * (k2.p + k3.p) + k4.p, k1.Q + 2 * (k2.Q + k3.Q) + k4.Q,
          k1.c + 2 * (k2.c + k3.c) + k4.c, k1.v + 2 * (k2.v + k3.v) + k4.v, k1.L + 2 * (k2.L + k3.L) + k4.L};
}

BodyState CoupledFlow::advance(BodyState state, double t) const {
  const Slope at_start = drive(state, t, t);
  Slope k1 = at_start;  // less the lines nothing is left of what drives the modes
  k1.q.setZero(), k1.p.setZero();
  const Lines first = lines(state, t, at_start, k1), second = first.later(h_ / 2);
  const double middle = t + h_ / 2, end = t + h_;
  const BodyState half = flow(state, first), whole = flow(half, second);
  const Slope k2 = slope(add(half, k1, h_ / 2), middle, first), k3 = slope(add(half, k2, h_ / 2), middle, first),
              k2_on = flow(k2), k3_on = flow(k3);
  const Slope k4 = slope(add(whole, k3_on, h_), end, first);
  return add(whole, weighted(k1, k2_on, k3_on, k4), h_ / 6);
}

CoupledFlight::CoupledFlight(const FloatingBody& body, const BodyState& start, double t0, double tolerance)
    : body_(body), tolerance_(tolerance), end_(t0), last_(start) {
  if (!(tolerance > 0)) throw std::invalid_argument("coupled flight: the tolerance must be positive");
  double fastest = angular_velocity(body, start).norm();
  for (const Roots& mode : body.modes) fastest = std::max(fastest, mode.omega);
  longest_ = fastest > 0 ? 16 * pi / fastest : 1;
  if (body.loads) longest_ = std::min(longest_, body.loads->longest_step);
  level_ = 4;
}

const CoupledFlow& CoupledFlight::flow(int level) const {
  return flows_.try_emplace(level, body_, std::ldexp(longest_, -level)).first->second;
}

double CoupledFlight::longest_until_jump() const {
  return body_.loads ? body_.loads->next_jump(end_) - end_ : std::numeric_limits<double>::infinity();
}

// Two half steps stand where the whole one agrees.
void CoupledFlight::extend() const {
  const double energy = internal_energy(body_, last_), until_jump = longest_until_jump();
  for (;;) {
    if (level_ > deepest || n_steps_ >= most_steps || !is_finite(last_)) {
      failed_ = true;
      return;
    }
    const double regular = std::ldexp(longest_, -level_), h = std::min(regular, until_jump);
    std::optional<CoupledFlow> shorter;
    if (h < regular) shorter.emplace(body_, h / 2);
    const CoupledFlow& half = shorter ? *shorter : flow(level_ + 1);
    const BodyState whole = (h < regular ? CoupledFlow(body_, h) : flow(level_)).advance(last_, end_);
    BodyState middle = half.advance(last_, end_), end = half.advance(middle, end_ + h / 2);
    n_steps_ += 3;
    const double error = distance(body_, whole, end, std::max(energy, internal_energy(body_, end))) / 15;
    if (!(error <= tolerance_)) {
      ++level_;
      continue;
    }
    nodes_.push_back({end_, std::move(last_)});
    nodes_.push_back({end_ + h / 2, std::move(middle)});
    last_ = std::move(end);
    end_ = h < until_jump ? end_ + h : body_.loads->next_jump(end_);
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
  return t == node.t ? node.state : CoupledFlow(body_, t - node.t).advance(node.state, node.t);
}

}  // namespace mb
