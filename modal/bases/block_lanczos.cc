#include "modal/bases/block_lanczos.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "mechanics/algebra/dense_eigen.h"

namespace mb {
namespace {

constexpr int max_restarts = 100;
constexpr double vanished = 1e-12;  // [-] of a column: what orthogonalisation may leave of one that depends on others

// Basis, and its images under M: products with M are dearer than memory.
class Space {
 public:
  Space(const BlockProduct& M, const MatrixXd& known, Index n_vectors)
      : multiply_(M), n_known_(known.cols()), size_(n_known_) {
    V_.resize(known.rows(), n_known_ + n_vectors);
    MV_.resize(known.rows(), n_known_ + n_vectors);
    if (n_known_ > 0) {
      V_.leftCols(n_known_) = known;
      MV_.leftCols(n_known_) = M(known);
    }
  }

  Index size() const { return size_ - n_known_; }
  Index room() const { return V_.cols() - size_; }
  auto basis() const { return V_.middleCols(n_known_, size()); }

  void append(const MatrixXd& W, const MatrixXd& MW) {
    V_.middleCols(size_, W.cols()) = W;
    MV_.middleCols(size_, W.cols()) = MW;
    size_ += W.cols();
  }

  // Replaces the basis by its combinations S.
  void contract(const MatrixXd& S) {
    V_.middleCols(n_known_, S.cols()) = (V_.middleCols(n_known_, size()) * S).eval();
    MV_.middleCols(n_known_, S.cols()) = (MV_.middleCols(n_known_, size()) * S).eval();
    size_ = n_known_ + S.cols();
  }

  struct Block {
    MatrixXd Q, MQ;  // M-orthonormal, M-orthogonal to the basis; fewer columns than W where W depends on it
    MatrixXd C, B;   // W = basis C + Q B
  };
  // n_before: where in the basis W mainly lies, from there to its end. Taking these parts out first and then all of
  // them is as good as all of them twice ("twice is enough", Parlett 1998, sect. 6.9).
  Block orthogonalised(MatrixXd W, Index n_before) const {
    Block block{{}, {}, MatrixXd::Zero(size_, W.cols()), MatrixXd::Identity(W.cols(), W.cols())};
    remove(W, n_known_ + n_before, block);
    for (int pass = 0; pass < max_passes; ++pass) {
      remove(W, 0, block);
      block.MQ = multiply_(W);
      const double condition = normalise(W, block);
      normalise(W, block);         // only rounding is left to mend
      if (condition < 1e4) break;  // else it was blown up by as much: once more
    }
    block.Q = std::move(W);
    block.C = block.C.bottomRows(size()).eval();
    drop_dependent(block);
    return block;
  }

 private:
  static constexpr int max_passes = 4;

  void remove(MatrixXd& W, Index from, Block& block) const {
    const Index count = size_ - from;
    if (count == 0) return;
    const MatrixXd c = MV_.middleCols(from, count).transpose() * W;
    W.noalias() -= V_.middleCols(from, count) * c;
    block.C.bottomRows(count) += c * block.B;
  }

  // W <- W U D^-1/2 with W^T M W = U D U^T, MQ and B alike; returns the ratio of the largest to the smallest D^1/2.
  static double normalise(MatrixXd& W, Block& block) {
    const MatrixXd gram = W.transpose() * block.MQ;
    if (!gram.allFinite()) throw std::runtime_error("block Lanczos: the operator gave what is not finite");
    const EigenPairs eigen = symmetric_eigen(gram);
    const double largest = eigen.values.maxCoeff();
    if (!(largest > 0)) {  // nothing is left of W
      block.B.setZero();
      return 1;
    }
    const VectorXd length = eigen.values.cwiseMax(1e-15 * largest).cwiseSqrt();  // rounding may be negative
    const MatrixXd& U = eigen.vectors;
    const MatrixXd S = U * length.cwiseInverse().asDiagonal();
    W = (W * S).eval();
    block.MQ = (block.MQ * S).eval();
    block.B = (length.asDiagonal() * U.transpose() * block.B).eval();
    return length.maxCoeff() / length.minCoeff();
  }

  static void drop_dependent(Block& block) {
    const double size = std::sqrt((block.C.colwise().squaredNorm() + block.B.colwise().squaredNorm()).maxCoeff());
    std::vector<Index> kept;
    for (Index i = 0; i < block.B.rows(); ++i)
      if (block.B.row(i).norm() > vanished * size) kept.push_back(i);
    if (static_cast<Index>(kept.size()) == block.B.rows()) return;
    block.Q = block.Q(Eigen::all, kept).eval();
    block.MQ = block.MQ(Eigen::all, kept).eval();
    block.B = block.B(kept, Eigen::all).eval();
  }

  const BlockProduct& multiply_;
  Index n_known_, size_;
  MatrixXd V_, MV_;
};

class BlockLanczos {
 public:
  BlockLanczos(const BlockOperator& T, const BlockProduct& M, const MatrixXd& known, const MatrixXd& start,
               const Krylov& krylov)
      : T_(T), tolerance_(krylov.tolerance), space_(M, known, krylov.n_vectors) {
    H_ = MatrixXd::Zero(krylov.n_vectors, krylov.n_vectors);
    next_ = space_.orthogonalised(start, 0);
    if (exhausted()) throw std::invalid_argument("block Lanczos: the start lies in what is known");
  }

  bool exhausted() const { return next_.Q.cols() == 0; }  // the basis is invariant: its Ritz pairs are exact
  bool full() const { return space_.room() < next_.Q.cols(); }
  Index size() const { return space_.size(); }
  Index block() const { return next_.Q.cols(); }

  void step() {
    const Index first = size(), width = block();
    space_.append(next_.Q, next_.MQ);
    // T is self-adjoint: of the basis, T X can only lie in this block and the one before; after a restart, anywhere.
    next_ = space_.orthogonalised(T_(next_.MQ), std::max<Index>(0, first - before_));
    H_.block(0, first, first + width, width) = next_.C;
    H_.block(first, 0, width, first + width) = next_.C.transpose();
    before_ = last_ = width;
    n_columns_ += width;
  }

  // Ritz pairs, the largest first, and how many from the first on have converged.
  Index ritz() {
    const EigenPairs eigen = symmetric_eigen(H_.topLeftCorner(size(), size()));
    theta_ = eigen.values.reverse();
    y_ = eigen.vectors.rowwise().reverse();
    n_converged_ = 0;
    while (n_converged_ < size() && residual(n_converged_) <= bound(n_converged_)) ++n_converged_;
    return n_converged_;
  }
  const VectorXd& theta() const { return theta_; }

  void restart() {
    const Index most = size() + space_.room() - 2 * last_;
    const Index keep = std::min(most, std::max(n_converged_ + 2 * last_, size() / 2));
    space_.contract(y_.leftCols(keep));
    H_.setZero();
    H_.diagonal().head(keep) = theta_.head(keep);
    before_ = keep;
  }

  // x = V y, refined for nothing: T x / theta = x + Q B y_last / theta.
  LargestPairs converged() const {
    const VectorXd theta = theta_.head(n_converged_);
    MatrixXd X = space_.basis() * y_.leftCols(n_converged_);
    if (!exhausted())
      X.noalias() +=
          next_.Q * (next_.B * y_.leftCols(n_converged_).bottomRows(last_) * theta.cwiseInverse().asDiagonal());
    return {theta, std::move(X), n_columns_};
  }

 private:
  // Of an eigenvalue far below the largest, the rounding of T x may be all that is left.
  double bound(Index i) const {
    constexpr double eps = std::numeric_limits<double>::epsilon();
    return std::max(tolerance_ * theta_(i), 64 * eps * theta_(0));
  }
  double residual(Index i) const { return exhausted() ? 0 : (next_.B * y_.col(i).tail(last_)).norm(); }

  const BlockOperator& T_;
  double tolerance_;
  Space space_;
  Space::Block next_;
  MatrixXd H_, y_;
  VectorXd theta_;
  Index before_ = 0, last_ = 0;  // columns which the next block can lie in besides its own; of the last block
  Index n_converged_ = 0;
  long n_columns_ = 0;
};

void check_sizes(const MatrixXd& known, const MatrixXd& start, const Krylov& krylov) {
  const Index n = start.rows(), block = start.cols();
  if (block < 1 || (known.cols() > 0 && known.rows() != n) || krylov.n_vectors <= 2 * block ||
      krylov.n_vectors > n - known.cols() || !(krylov.tolerance > 0) || !start.allFinite())
    throw std::invalid_argument(fmt::format("block Lanczos: start {} x {}, {} x {} known, {} vectors, tolerance {}", n,
                                            block, known.rows(), known.cols(), krylov.n_vectors, krylov.tolerance));
}

}  // namespace

LargestPairs largest_pairs(const BlockOperator& T, const BlockProduct& M, const MatrixXd& known, const MatrixXd& start,
                           const std::function<Index(const VectorXd& theta)>& missing, const Krylov& krylov) {
  check_sizes(known, start, krylov);
  BlockLanczos lanczos(T, M, known, start, krylov);
  Index next_look = 4 * start.cols();
  for (int n_restarts = 0; n_restarts <= max_restarts; ++n_restarts) {
    for (bool last = false; !last;) {
      lanczos.step();
      last = lanczos.exhausted() || lanczos.full();
      if (!last && lanczos.size() < next_look) continue;
      const Index n_converged = lanczos.ritz();
      const Index n_missing = missing(lanczos.theta().head(n_converged));
      if (n_missing <= 0 || lanczos.exhausted()) return lanczos.converged();
      // A look costs as much as a step: a third of the way there, were it as long for each of them as it was so far.
      next_look = lanczos.size() + n_missing * lanczos.size() / (3 * std::max<Index>(n_converged, n_missing));
    }
    lanczos.restart();
    next_look = 0;
  }
  throw std::runtime_error(
      fmt::format("block Lanczos: no convergence in {} restarts of {} vectors", max_restarts, krylov.n_vectors));
}

}  // namespace mb
