#include "mechanics/system/joined.h"

#include <algorithm>
#include <stdexcept>

#include "mechanics/system/joined_energy.h"

namespace mb {

namespace {

// [n] of every system, and all of them.
Index size_of(const std::vector<System>& systems) {
  Index n = 0;
  for (const System& s : systems) n += s.M.rows();
  return n;
}

template <class Part>
SparseMatrix diagonal(const std::vector<System>& systems, const Part& part) {
  std::vector<Eigen::Triplet<double>> entries;
  Index first = 0;
  for (const System& s : systems) {
    const SparseMatrix A = part(s);
    for (Index j = 0; j < A.outerSize(); ++j)
      for (SparseMatrix::InnerIterator it(A, j); it; ++it)
        entries.emplace_back(first + it.row(), first + j, it.value());
    first += s.M.rows();
  }
  SparseMatrix all(first, first);
  all.setFromTriplets(entries.begin(), entries.end());
  return all;
}

// Columns of every system below and beside each other.
template <class Part>
MatrixXd staircase(const std::vector<System>& systems, const Part& part) {
  Index columns = 0;
  for (const System& s : systems) columns += part(s).cols();
  MatrixXd all = MatrixXd::Zero(size_of(systems), columns);
  Index first = 0, column = 0;
  for (const System& s : systems) {
    const MatrixXd A = part(s);
    if (A.cols() > 0) all.block(first, column, A.rows(), A.cols()) = A;
    first += s.M.rows(), column += A.cols();
  }
  return all;
}

VectorXd damped_by(const System& s) {
  VectorXd d = VectorXd::Constant(s.R.cols(), -s.damping.alpha);
  d.conservativeResize(s.R.cols() + s.modal_damping.d.size());
  d.tail(s.modal_damping.d.size()) = s.modal_damping.d;
  return d;
}

template <class Part>
VectorXd stacked(const std::vector<System>& systems, const Part& part) {
  std::vector<double> all;
  for (const System& s : systems) {
    const VectorXd x = part(s);
    all.insert(all.end(), x.begin(), x.end());
  }
  return Eigen::Map<const VectorXd>(all.data(), std::ssize(all));
}

void join_energies(const std::vector<System>& systems, System& all) {
  const double alpha = systems.front().damping.alpha;
  if (std::ranges::any_of(systems, [&](const System& s) { return s.damping.alpha != alpha; }))
    throw std::invalid_argument("joined: bodies of finite deformation whose 'alpha' is not that of the others");
  all.stored_energy = std::make_shared<JoinedEnergy>(systems);
}

}  // namespace

System joined(const std::vector<System>& systems) {
  if (systems.empty()) throw std::invalid_argument("joined: there is no system");
  for (const System& s : systems) require_consistent(s);
  System all;
  all.M = diagonal(systems, [](const System& s) { return s.M; });
  all.K = diagonal(systems, [](const System& s) { return s.K; });
  if (std::ranges::all_of(systems, [](const System& s) { return s.lumped_mass.rows() > 0; }))
    all.lumped_mass = diagonal(systems, [](const System& s) { return s.lumped_mass; });
  all.R = staircase(systems, [](const System& s) { return s.R; });
  all.F = staircase(systems, [](const System& s) { return s.F; });
  const bool turning = std::ranges::any_of(systems, [](const System& s) { return !s.follows.empty(); });
  for (const System& s : systems) {
    all.s.insert(all.s.end(), s.s.begin(), s.s.end());
    if (turning) all.follows.insert(all.follows.end(), s.follows.begin(), s.follows.end());
    if (turning) all.follows.resize(all.s.size(), false);
  }
  all.u0 = stacked(systems, [](const System& s) { return s.u0; });
  all.v0 = stacked(systems, [](const System& s) { return s.v0; });
  all.damping = systems.front().damping;
  const auto alike = [&](const System& s) {
    return s.damping.alpha == all.damping.alpha && s.damping.beta == all.damping.beta;
  };
  const bool finite = std::ranges::any_of(systems, [](const System& s) { return s.stored_energy != nullptr; });
  if (finite) join_energies(systems, all);
  const bool same = finite || std::ranges::all_of(systems, alike);
  if (!same) {
    all.damping = {};
    all.viscous =
        diagonal(systems, [](const System& s) -> SparseMatrix { return s.damping.alpha * s.M + s.damping.beta * s.K; });
  }
  all.modal_damping.W = staircase(systems, [&](const System& s) -> MatrixXd {
    const Index n_rigid = same ? 0 : s.R.cols();
    MatrixXd W(s.M.rows(), n_rigid + s.modal_damping.W.cols());
    if (n_rigid > 0) W.leftCols(n_rigid) = s.M * s.R;
    if (s.modal_damping.W.cols() > 0) W.rightCols(s.modal_damping.W.cols()) = s.modal_damping.W;
    return W;
  });
  all.modal_damping.d = stacked(systems, [&](const System& s) { return same ? s.modal_damping.d : damped_by(s); });
  return all;
}

}  // namespace mb
