#include "mechanics/system/joined_energy.h"

#include <algorithm>

namespace mb {

JoinedEnergy::JoinedEnergy(const std::vector<System>& systems) {
  Index first = 0;
  for (const System& s : systems) {
    parts_.push_back({s.stored_energy, s.K, s.damping.beta, s.R, first, s.M.rows()});
    first += s.M.rows();
  }
}

double JoinedEnergy::energy(const VectorXd& u) const {
  double W = 0;
  for (const Part& p : parts_) {
    const VectorXd own = u.segment(p.first, p.n);
    W += p.finite ? p.finite->energy(own) : 0.5 * own.dot(p.K * own);
  }
  return W;
}

bool JoinedEnergy::force(const VectorXd& u, const VectorXd& v, VectorXd& f) const {
  f.resize(u.size());
  VectorXd of_part;
  for (const Part& p : parts_) {
    const VectorXd u_p = u.segment(p.first, p.n), v_p = v.segment(p.first, p.n);
    if (!p.finite)
      of_part = p.K * (u_p + p.beta * v_p);
    else if (!p.finite->force(u_p, v_p, of_part))
      return false;
    f.segment(p.first, p.n) = of_part;
  }
  return true;
}

// Columns of a part hold its own entries alone, one after another.
bool JoinedEnergy::add_tangent(const VectorXd& u, double by_u, double by_v, SparseMatrix& A) const {
  for (const Part& p : parts_) {
    SparseMatrix own = p.K;
    if (p.finite) {
      std::fill_n(own.valuePtr(), own.nonZeros(), 0.0);
      if (!p.finite->add_tangent(u.segment(p.first, p.n), by_u, by_v, own)) return false;
    } else {
      own *= by_u + p.beta * by_v;
    }
    Eigen::Map<VectorXd>(A.valuePtr() + A.outerIndexPtr()[p.first], own.nonZeros()) +=
        Eigen::Map<const VectorXd>(own.valuePtr(), own.nonZeros());
  }
  return true;
}

std::vector<Turn> JoinedEnergy::turns(const VectorXd& u) const {
  std::vector<Turn> all;
  for (const Part& p : parts_) {
    if (!p.finite) continue;
    for (Turn turn : p.finite->turns(u.segment(p.first, p.n))) {
      turn.first += p.first;
      all.push_back(turn);
    }
  }
  return all;
}

MatrixXd JoinedEnergy::rigid_motions(const VectorXd& u) const {
  Index columns = 0;
  for (const Part& p : parts_) columns += p.R.cols();
  MatrixXd all = MatrixXd::Zero(u.size(), columns);
  Index column = 0;
  for (const Part& p : parts_) {
    const MatrixXd own = p.finite ? p.finite->rigid_motions(u.segment(p.first, p.n)) : p.R;
    if (own.cols() > 0) all.block(p.first, column, p.n, own.cols()) = own;
    column += own.cols();
  }
  return all;
}

}  // namespace mb
