#include "modal/frame/frame_loads.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mb {

namespace {

constexpr double steps_at_least = 100;  // in the whole duration

bool follows(const System& system, size_t load) { return !system.follows.empty() && system.follows[load]; }

// sum over nodes of a x b, both of unknowns in threes.
Vector3d moment(const Eigen::Ref<const VectorXd>& a, const Eigen::Ref<const VectorXd>& b) {
  Vector3d sum = Vector3d::Zero();
  for (Index i = 0; i < a.size(); i += 3) sum += Vector3d(a.segment<3>(i)).cross(Vector3d(b.segment<3>(i)));
  return sum;
}

}  // namespace

VectorXd FrameLoads::amplitudes(double t, double since, const Eigen::Quaterniond& Q) const {
  const double seen = std::min(t, std::nextafter(next_jump(since), since));
  const Eigen::Matrix3d R = Q.toRotationMatrix();
  VectorXd a(n_patterns());
  Index p = 0;
  for (size_t l = 0; l < s.size(); ++l) {
    const double factor = s[l](seen);
    if (follows[l]) {
      a[p++] = factor;
      continue;
    }
    a.segment<9>(p) = factor * R.transpose().reshaped();  // column l, row k: R_lk
    p += 9;
  }
  return a;
}

FrameForce FrameLoads::at(double t, double since, const Eigen::Quaterniond& Q, const VectorXd& q) const {
  const VectorXd a = amplitudes(t, since, Q);
  const VectorXd turned = dT * q;  // 3 m
  return {f * a, (T + turned.reshaped(3, n_patterns()).matrix()) * a, P * a};
}

double FrameLoads::next_jump(double t) const {
  const auto next = std::ranges::upper_bound(jumps, t);
  return next == jumps.end() ? std::numeric_limits<double>::infinity() : *next;
}

MatrixXd load_patterns(const System& system) {
  const Index n = system.F.rows();
  MatrixXd G(n, 0);
  for (Index l = 0; l < system.F.cols(); ++l) {
    if (follows(system, static_cast<size_t>(l))) {
      G.conservativeResize(n, G.cols() + 1);
      G.rightCols(1) = system.F.col(l);
      continue;
    }
    G.conservativeResize(n, G.cols() + 9);
    auto nine = G.rightCols(9);
    nine.setZero();
    for (Index of = 0; of < 3; ++of)
      for (Index along = 0; along < 3; ++along)
        nine.col(3 * of + along)(Eigen::seqN(along, n / 3, 3)) = system.F.col(l)(Eigen::seqN(of, n / 3, 3));
  }
  return G;
}

FrameLoads frame_loads(const System& system, const VectorXd& X, const MatrixXd& Phi, double duration) {
  const MatrixXd G = load_patterns(system);
  const Index m = G.cols(), r = Phi.cols();
  FrameLoads loads{{}, {}, {}, duration / steps_at_least, Matrix3Xd(3, m), Matrix3Xd(3, m), MatrixXd(3 * m, r), {}};
  for (size_t l = 0; l < system.s.size(); ++l) {
    loads.s.push_back(evaluator(system.s[l]));
    loads.follows.push_back(follows(system, l));
    const std::vector<double> jumps = breakpoints(system.s[l], duration);
    loads.jumps.insert(loads.jumps.end(), jumps.begin(), jumps.end());
  }
  std::ranges::sort(loads.jumps);
  for (Index a = 0; a < m; ++a) {
    loads.f.col(a) = G.col(a).reshaped(3, X.size() / 3).rowwise().sum();
    loads.T.col(a) = moment(X, G.col(a));
    for (Index i = 0; i < r; ++i) loads.dT.block<3, 1>(3 * a, i) = moment(Phi.col(i), G.col(a));
  }
  loads.P = Phi.transpose() * G;
  return loads;
}

}  // namespace mb
