#include "mechanics/system/modal_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mechanics/system/transition.h"

namespace mb {
namespace {

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
  Run(const ModalMotion& motion, const VectorXd& times)
      : motion_(motion),
        times_(times),
        start_(times.size()),
        direct_(motion, Transition::Of::state),
        step_(motion, Transition::Of::state) {
    q_.resize(motion.n_modes(), times.size() + 2);
    v_.resize(motion.n_modes(), times.size() + 2);
    q_.col(start_) = motion.q0;
    v_.col(start_) = motion.v0;
    Index done = 0;
    for (const auto& piece : motion.pieces) {
      const bool is_last = &piece == &motion.pieces.back();
      Index count = 0;
      while (done + count < times.size() && (is_last || times[done + count] < piece.end)) ++count;
      sample(piece, done, count);
      done += count;
      work_.load_evaluations += motion.n_loads();
      if (done == times.size()) break;
      pass(piece);
    }
  }

  ModalStates states() && {
    q_.conservativeResize(Eigen::NoChange, times_.size());  // shrinks in place: no second copy of a long run
    v_.conservativeResize(Eigen::NoChange, times_.size());
    return {std::move(q_), std::move(v_), work_};
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
        step_.apply(q_, v_, first + j - 1, q_, v_, first + j, piece, times_[first + j - 1] - piece.start);
      } else {
        direct_.make(piece, times_[first + j] - piece.start);
        direct_.apply(q_, v_, start_, q_, v_, first + j, piece, 0);
      }
    }
    work_.steps += count * motion_.n_modes();
  }

  void pass(const Piece& piece) {
    const Index end = 2 * times_.size() + 1 - start_;  // the other one of the two
    direct_.make(piece, piece.end - piece.start);
    direct_.apply(q_, v_, start_, q_, v_, end, piece, 0);
    start_ = end;
    work_.steps += motion_.n_modes();
  }

  const ModalMotion& motion_;
  const VectorXd& times_;
  MatrixXd q_, v_;
  Index start_;
  Transition direct_, step_;
  Work work_;
};

// Integrals over windows, each from the state at its start on, piece by piece. Most windows lie inside one piece: the
// transition made for the width then serves all of them.
class Windows {
 public:
  explicit Windows(const ModalMotion& motion)
      : motion_(motion),
        whole_(motion, Transition::Of::integral),
        part_(motion, Transition::Of::integral),
        advance_(motion, Transition::Of::state),
        q_(motion.n_modes(), 3),
        v_(motion.n_modes(), 3) {}

  // Column j of states: q and v at `start`, which become their integrals over [start, start + length].
  void integrate(ModalStates& states, Index j, double start, double length) {
    while (!is_last(first_) && motion_.pieces[first_].end <= start) ++first_;
    if (is_last(first_) || start + length <= motion_.pieces[first_].end) {
      const Piece& piece = motion_.pieces[first_];
      if (!(made_for_ == first_ && made_ == length)) whole_.make(piece, length);
      made_for_ = first_, made_ = length;
      whole_.apply(states.q, states.v, j, q_, v_, sum, piece, start - piece.start);
      count(states.work);
    } else {
      across(states, j, start, start + length);
    }
    states.q.col(j) = q_.col(sum);
    states.v.col(j) = v_.col(sum);
  }

 private:
  static constexpr Index now = 0, addend = 1, sum = 2;  // columns of the workspace
  static constexpr auto nothing = std::numeric_limits<std::size_t>::max();

  bool is_last(std::size_t piece) const { return piece + 1 == motion_.pieces.size(); }
  void count(Work& work) const {
    work.steps += motion_.n_modes();
    work.load_evaluations += motion_.n_loads();
  }

  void across(ModalStates& states, Index j, double start, double end) {
    q_.col(now) = states.q.col(j), v_.col(now) = states.v.col(j);
    q_.col(sum).setZero(), v_.col(sum).setZero();
    for (std::size_t p = first_; start < end; ++p) {
      const Piece& piece = motion_.pieces[p];
      const double stop = is_last(p) ? end : std::min(end, piece.end), tau = stop - start;
      part_.make(piece, tau);
      part_.apply(q_, v_, now, q_, v_, addend, piece, start - piece.start);
      q_.col(sum) += q_.col(addend), v_.col(sum) += v_.col(addend);
      advance_.make(piece, tau);
      advance_.apply(q_, v_, now, q_, v_, addend, piece, start - piece.start);
      q_.col(now) = q_.col(addend), v_.col(now) = v_.col(addend);
      start = stop;
      count(states.work);
    }
  }

  const ModalMotion& motion_;
  Transition whole_, part_, advance_;
  MatrixXd q_, v_;
  std::size_t first_ = 0, made_for_ = nothing;
  double made_ = 0;
};

}  // namespace

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

ModalStates states(const ModalMotion& motion, const VectorXd& times) { return Run(motion, times).states(); }

ModalStates means(const ModalMotion& motion, const VectorXd& times, double width) {
  const VectorXd before = (width / 2 - times.array()).max(0);  // [s] the share of a window at rest
  ModalStates result = states(motion, (times.array() - width / 2).max(0));
  Windows windows(motion);
  for (Index j = 0; j < times.size(); ++j) {
    windows.integrate(result, j, std::max(times[j] - width / 2, 0.0), width - before[j]);
    result.q.col(j) = (result.q.col(j) + before[j] * motion.q0) / width;
    result.v.col(j) /= width;
  }
  return result;
}

}  // namespace mb
