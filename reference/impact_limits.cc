#include "reference/impact_limits.h"

#include <fmt/format.h>

#include <limits>
#include <stdexcept>

#include "mechanics/geometry/signed_distance.h"

namespace mb {

namespace {

constexpr double looks_away = -0.1;  // [-] cosine: as contact_surface.h has it
constexpr double negligible = 1e-3;  // [-] depth by the contact's displacement
constexpr double no_limit = std::numeric_limits<double>::infinity();

// All of the boundary but the points that the contact has: these come in the same order.
ContactPoints unwatched(const ContactPoints& all, const Contact& contact) {
  const Matrix3Xd& X = contact.points.X;
  std::vector<Index> left, place(static_cast<size_t>(all.X.cols()), -1);
  Index n_found = 0;
  for (Index i = 0; i < all.X.cols(); ++i) {
    if (n_found < X.cols() && all.X.col(i) == X.col(n_found)) {
      ++n_found;
      continue;
    }
    place[static_cast<size_t>(i)] = static_cast<Index>(left.size());
    left.push_back(i);
  }
  if (n_found < X.cols()) throw std::logic_error("points of a contact are not among those of the boundary");
  std::vector<Eigen::Triplet<double>> entries;
  for (Index j = 0; j < all.U.outerSize(); ++j)
    for (SparseMatrix::InnerIterator it(all.U, j); it; ++it)
      if (const Index at = place[static_cast<size_t>(it.row() / 3)]; at >= 0)
        entries.emplace_back(3 * at + it.row() % 3, j, it.value());
  ContactPoints rest{all.X(Eigen::all, left), all.w(left),
                     SparseMatrix(3 * static_cast<Index>(left.size()), all.U.cols())};
  rest.U.setFromTriplets(entries.begin(), entries.end());
  return rest;
}

// Distances change by no more than their points move: most need not be found again.
class GapsInPassing {
 public:
  GapsInPassing(const RigidSurface& surface, Index n) : surface_(surface), X_(3, n), gap_(VectorXd::Zero(n)) {
    X_.setConstant(no_limit);
  }
  // Of point i at x; its true value where it is negative, else any that is not.
  double operator()(Index i, const Vector3d& x) {
    if (const double least = gap_[i] - (x - X_.col(i)).norm(); least > 0) return least;
    X_.col(i) = x;
    return gap_[i] = gap_value(surface_, x);
  }

 private:
  const RigidSurface& surface_;
  Matrix3Xd X_;
  VectorXd gap_;
};

}  // namespace

MatrixXd rotation_rows(const System& system, const Matrix3Xd& points, const MatrixXd& rigid) {
  if (rigid.rows() != 3 * points.cols() || rigid.cols() != system.R.cols())
    throw std::invalid_argument("rotation: rigid modes and points differ in number");
  const Matrix3Xd X = points.colwise() - Vector3d(points.rowwise().mean());
  const Eigen::Matrix3d J = X.squaredNorm() * Eigen::Matrix3d::Identity() - X * X.transpose();
  MatrixXd moments = MatrixXd::Zero(3, rigid.cols());
  for (Index k = 0; k < rigid.cols(); ++k)
    for (Index i = 0; i < X.cols(); ++i) moments.col(k) += X.col(i).cross(Vector3d(rigid.col(k).segment<3>(3 * i)));
  return J.ldlt().solve(moments) * MatrixXd(system.M * system.R).transpose();
}

std::optional<Fault> large_rotation(const Body& body, const MatrixXd& theta, const VectorXd& t) {
  const VectorXd angle = theta.colwise().norm();
  Index first = 0;
  while (first < angle.size() && angle[first] <= most_rotation) ++first;  // what is not a number stops it, too
  if (first == angle.size()) return {};
  return Fault{
      t[first],
      fmt::format("body '{}' turns by {:.2g} rad, from t = {:.4g} s on by more than the {} rad that full order with "
                  "linear kinematics carries: its axes do not turn",
                  body.name, angle.maxCoeff(), t[first], most_rotation)};
}

std::optional<Fault> unwatched_overlap(const Body& body, const Boundary& boundary, const Contact& contact,
                                       const std::string& obstacle, const Displaced& states) {
  const ContactPoints rest = unwatched(boundary.points, contact);
  const Index n = rest.X.cols();
  GapsInPassing gaps(contact.surface, n);
  VectorXd d;
  for (Index k = 0; n > 0 && k < states.u.cols(); ++k) {
    d = rest.U * states.u.col(k);
    for (Index i = 0; i < n; ++i) {
      const Vector3d x = rest.X.col(i) + d.segment<3>(3 * i);
      const double value = gaps(i, x);
      if (value >= -negligible * contact.scale.displacement) continue;
      // Beside an edge that presses lie points of faces that do not: they look elsewhere.
      const Distance own = signed_distance(body.shape, boundary.frame.to_frame(rest.X.col(i)));
      const Vector3d outward = boundary.frame.orientation * own.gradient;
      if (outward.dot(gap(contact.surface, x).normal) >= looks_away) continue;
      return Fault{
          states.t[k],
          fmt::format("body '{}' is {:.3g} m within obstacle '{}' at t = {:.4g} s with a part of its boundary that was "
                      "too far from it at the first touch to be watched in full order",
                      body.name, -value, obstacle, states.t[k])};
    }
  }
  return {};
}

}  // namespace mb
