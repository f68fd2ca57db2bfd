#include "mechanics/system/exact.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "mechanics/system/modal_form.h"
#include "mechanics/system/oscillator.h"

namespace mb {
namespace {

// Every load on [start, end), between breakpoints of any of them: one segment a load, all from the same start.
struct Piece {
  double start, end;
  std::vector<Segment> loads;
};

std::vector<Piece> merged(const std::vector<Segments>& chains, double duration) {
  std::vector<double> ends = {duration};
  for (const auto& chain : chains)
    for (const auto& segment : chain.pieces)
      if (segment.end < duration) ends.push_back(segment.end);
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());

  std::vector<Piece> pieces;
  std::vector<std::size_t> current(chains.size(), 0);
  double start = 0;
  for (const double end : ends) {
    Piece piece{start, end, {}};
    for (std::size_t l = 0; l < chains.size(); ++l) {
      while (chains[l].pieces[current[l]].end <= start) ++current[l];
      piece.loads.push_back(rebased(chains[l].pieces[current[l]], start, end));
    }
    pieces.push_back(std::move(piece));
    start = end;
  }
  return pieces;
}

// What the integrator knows before it is asked for times.
struct Modal {
  std::vector<Roots> modes;
  MatrixXd f;       // Phi^T F, n_modes x n_loads
  VectorXd q0, v0;  // Phi^T M u0, Phi^T M v0
  MatrixXd Phi;     // 0 x 0 for the identity
  std::vector<Piece> pieces;

  Index n_modes() const { return static_cast<Index>(modes.size()); }
  Index n_loads() const { return f.cols(); }
};

// All modes over a time tau in a piece, from local time tau0 on:
//
//   q+ = C q + S v + A0 + tau0 A1 + sum_w (a_w X_w + b_w Y_w)
//   v+ = C'q + S'v + B0 + tau0 B1 + sum_w (a_w X'_w + b_w Y'_w)
//
// with A0 = P p0 + R p1, A1 = P p1, B0 = S p0 + P p1, B1 = S p1 for the line p0 + p1 tau of modal forces, and a_w, b_w
// the amplitudes of wave w as seen from tau0. Made once for a step that is repeated. A workspace: columns are reused.
class Transition {
 public:
  explicit Transition(const Modal& modal) : modal_(modal), table_(modal.n_modes(), 8 + 4 * modal.n_loads()) {}

  void make(const Piece& piece, double tau) {
    waves_.clear();
    for (std::size_t l = 0; l < piece.loads.size(); ++l)
      if (piece.loads[l].a != 0 || piece.loads[l].b != 0) waves_.push_back(l);
    for (Index i = 0; i < modal_.n_modes(); ++i) fill(i, piece, tau);
  }

  // From column `from` of q and v at local time tau0 to column `to`.
  void apply(MatrixXd& q, MatrixXd& v, Index from, Index to, const Piece& piece, double tau0) const {
    const auto T = [this](Index column) { return table_.col(column).array(); };
    const auto q0 = q.col(from).array(), v0 = v.col(from).array();
    auto q1 = q.col(to).array(), v1 = v.col(to).array();
    q1 = T(0) * q0 + T(1) * v0 + T(4) + tau0 * T(5);
    v1 = T(2) * q0 + T(3) * v0 + T(6) + tau0 * T(7);
    Index column = 8;
    for (const auto l : waves_) {
      const Segment seen = rebased(piece.loads[l], piece.start + tau0, piece.end);
      q1 += seen.a * T(column) + seen.b * T(column + 1);
      v1 += seen.a * T(column + 2) + seen.b * T(column + 3);
      column += 4;
    }
  }

 private:
  void fill(Index i, const Piece& piece, double tau) {
    const Roots& mode = modal_.modes[static_cast<std::size_t>(i)];
    const Response x = response(mode, tau);
    double p0 = 0, p1 = 0;
    for (Index l = 0; l < modal_.n_loads(); ++l) {
      const Segment& load = piece.loads[static_cast<std::size_t>(l)];
      p0 += modal_.f(i, l) * load.c0;
      p1 += modal_.f(i, l) * load.c1;
    }
    table_.row(i).head<8>() << x.C, x.S, x.C_dot, x.S_dot, p0 * x.P + p1 * x.R, p1 * x.P, p0 * x.S + p1 * x.P, p1 * x.S;
    Index column = 8;
    for (const auto l : waves_) {
      const HarmonicResponse y = harmonic_response(mode, x, piece.loads[l].omega, tau);
      const double f = modal_.f(i, static_cast<Index>(l));
      table_.row(i).segment<4>(column) << f * y.q_cos, f * y.q_sin, f * y.v_cos, f * y.v_sin;
      column += 4;
    }
  }

  const Modal& modal_;
  MatrixXd table_;
  std::vector<std::size_t> waves_;
};

bool equally_spaced(const VectorXd& times, Index first, Index count) {
  if (count < 4) return false;  // two transitions are made for them: the first and the step
  const double last = times[first + count - 1], step = (last - times[first]) / static_cast<double>(count - 1);
  for (Index j = 0; j < count; ++j)  // a shift of a few ulp of t is within what rounding of omega t costs anyway
    if (std::abs(times[first + j] - times[first] - static_cast<double>(j) * step) >
        4 * std::numeric_limits<double>::epsilon() * last)
      return false;
  return step > 0;
}

// One run. Columns 0 ... n-1 of q, v are the outputs, the last two the start and the end of the current piece.
class Run {
 public:
  Run(const Modal& modal, const VectorXd& times)
      : modal_(modal), times_(times), start_(times.size()), direct_(modal), step_(modal) {
    q_.resize(modal.n_modes(), times.size() + 2);
    v_.resize(modal.n_modes(), times.size() + 2);
    q_.col(start_) = modal.q0;
    v_.col(start_) = modal.v0;
    Index done = 0;
    for (const auto& piece : modal.pieces) {
      const bool is_last = &piece == &modal.pieces.back();
      Index count = 0;
      while (done + count < times.size() && (is_last || times[done + count] < piece.end)) ++count;
      sample(piece, done, count);
      done += count;
      work_.load_evaluations += modal.n_loads();
      if (done == times.size()) break;
      pass(piece);
    }
  }

  States states() && {
    const Index n_times = times_.size();
    States states;
    if (modal_.Phi.size() > 0) {
      states.u = modal_.Phi * q_.leftCols(n_times);
      states.v = modal_.Phi * v_.leftCols(n_times);
    } else {
      q_.conservativeResize(Eigen::NoChange, n_times);  // shrinks in place: no second copy of a long run
      v_.conservativeResize(Eigen::NoChange, n_times);
      states.u = std::move(q_);
      states.v = std::move(v_);
    }
    states.work = work_;
    while (states.n_valid < n_times && states.u.col(states.n_valid).allFinite() &&
           states.v.col(states.n_valid).allFinite())
      ++states.n_valid;
    if (states.n_valid < n_times) states.status = Status::not_finite;
    return states;
  }

 private:
  // Equal steps repeat one transition, which adds up rounding; every 256th output starts afresh from the piece's
  // start, which holds the accumulated error below 256 x 2 eps = 1.2e-13.
  void sample(const Piece& piece, Index first, Index count) {
    constexpr Index refresh = 256;
    const bool steps = equally_spaced(times_, first, count);
    if (steps) step_.make(piece, (times_[first + count - 1] - times_[first]) / static_cast<double>(count - 1));
    for (Index j = 0; j < count; ++j) {
      if (steps && j % refresh != 0) {
        step_.apply(q_, v_, first + j - 1, first + j, piece, times_[first + j - 1] - piece.start);
      } else {
        direct_.make(piece, times_[first + j] - piece.start);
        direct_.apply(q_, v_, start_, first + j, piece, 0);
      }
    }
    work_.steps += count * modal_.n_modes();
  }

  void pass(const Piece& piece) {
    const Index end = 2 * times_.size() + 1 - start_;  // the other one of the two
    direct_.make(piece, piece.end - piece.start);
    direct_.apply(q_, v_, start_, end, piece, 0);
    start_ = end;
    work_.steps += modal_.n_modes();
  }

  const Modal& modal_;
  const VectorXd& times_;
  MatrixXd q_, v_;
  Index start_;
  Transition direct_, step_;
  Work work_;
};

class Exact final : public Stepper {
 public:
  Exact(Modal modal, double duration, double load_error)
      : modal_(std::move(modal)), duration_(duration), load_error_(load_error) {}

  States run(const VectorXd& times) const override {
    for (Index j = 0; j < times.size(); ++j) {
      const double before = j > 0 ? times[j - 1] : 0;
      if (!(times[j] >= before && times[j] <= duration_ * (1 + 1e-12)))  // t = n dt may exceed the duration by an ulp
        throw std::invalid_argument("times must ascend from 0 to the duration");
    }
    return Run(modal_, times).states();
  }
  double load_error() const override { return load_error_; }

 private:
  Modal modal_;
  double duration_, load_error_;
};

}  // namespace

std::unique_ptr<Stepper> exact(const System& system, double duration, double load_tolerance) {
  auto form = modal_form(system);
  std::vector<Segments> chains;
  double load_error = 0;
  for (const auto& history : system.s) {
    chains.push_back(segments(history, duration, load_tolerance));
    load_error = std::max(load_error, chains.back().load_error);
  }
  if (!(duration > 0 && std::isfinite(duration))) throw std::invalid_argument("the duration must be positive");

  Modal modal;
  for (Index i = 0; i < form.lambda.size(); ++i) modal.modes.push_back(roots({form.lambda[i], form.c[i]}));
  const bool identity = form.Phi.size() == 0;
  modal.f = identity ? system.F : MatrixXd(form.Phi.transpose() * system.F);
  modal.q0 = identity ? system.u0 : VectorXd(form.Phi.transpose() * (system.M * system.u0));
  modal.v0 = identity ? system.v0 : VectorXd(form.Phi.transpose() * (system.M * system.v0));
  modal.Phi = std::move(form.Phi);
  modal.pieces = merged(chains, duration);
  return std::make_unique<Exact>(std::move(modal), duration, load_error);
}

}  // namespace mb
