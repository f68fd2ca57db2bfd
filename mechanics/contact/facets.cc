#include "mechanics/contact/facets.h"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace mb {

namespace {

constexpr double skin = 0.5;         // [-] of the least radius of a patch
constexpr int most_iterations = 30;  // of a foot; a few suffice
constexpr double settled = 1e-12;    // [-] change of xi
constexpr double rim = 1e-9;         // [-] of xi: nearer to an edge than that is at it

// Rows a: coefficients of L_a by ascending powers.
MatrixXd lagrange(const VectorXd& places) {
  const Index n = places.size();
  MatrixXd vandermonde(n, n);
  for (Index i = 0; i < n; ++i)
    for (Index k = 0; k < n; ++k) vandermonde(i, k) = std::pow(places[i], static_cast<double>(k));
  return vandermonde.inverse().transpose();
}

void require_consistent(const Facets& f) {
  const Index n = f.places.size();
  if (n < 2 || n > 5 || f.nodes.rows() != n * n || f.nodes.cols() == 0 || f.U.rows() != 3 * f.X.cols() ||
      f.nodes.minCoeff() < 0 || f.nodes.maxCoeff() >= f.X.cols())
    throw std::invalid_argument("facets: patches, nodes and displacements differ in size, or there are none");
}

}  // namespace

FootSearch::FootSearch(const Facets& facets, Index n_points)
    : facets_(facets), x_(facets.X), reference_(facets.X), memory_(static_cast<size_t>(n_points)) {
  require_consistent(facets);
  coefficients_ = lagrange(facets.places);
  double most = 0;
  for (int i = 0; i <= 64; ++i) most = std::max(most, basis(i / 64.0).L.lpNorm<1>());
  lebesgue_ = 1.05 * most * most;  // between the samples it is larger by less
  renew();
  skin_ = skin * radii_.minCoeff();
}

FootSearch::Basis FootSearch::basis(double xi) const {
  const Index n = coefficients_.rows();
  Values p(n), p1(n), p2(n);
  double power = 1, lower = 0, lowest = 0;  // xi^k, xi^(k-1), xi^(k-2)
  for (Index k = 0; k < n; ++k) {
    p[k] = power, p1[k] = static_cast<double>(k) * lower, p2[k] = static_cast<double>(k * (k - 1)) * lowest;
    lowest = lower, lower = power, power *= xi;
  }
  return {coefficients_.lazyProduct(p), coefficients_.lazyProduct(p1), coefficients_.lazyProduct(p2)};
}

FootSearch::Surface FootSearch::surface(int patch, const Eigen::Vector2d& xi) const {
  const Basis a = basis(xi[0]), b = basis(xi[1]);
  const Index n = facets_.places.size();
  Surface s{};
  for (Vector3d* v : {&s.S, &s.S1, &s.S2, &s.S11, &s.S12, &s.S22}) v->setZero();
  for (Index j = 0; j < n; ++j) {
    Vector3d along = Vector3d::Zero(), along1 = along, along2 = along;
    for (Index i = 0; i < n; ++i) {
      const auto x = x_.col(facets_.nodes(i + n * j, patch));
      along += a.L[i] * x, along1 += a.L1[i] * x, along2 += a.L2[i] * x;
    }
    s.S += b.L[j] * along, s.S1 += b.L[j] * along1, s.S11 += b.L[j] * along2;
    s.S2 += b.L1[j] * along, s.S12 += b.L1[j] * along1, s.S22 += b.L2[j] * along;
  }
  return s;
}

// Newton's method for |x - S|^2 / 2, a coordinate resting at its bound where it would leave; Gauss and Newton's Hessian
// where the full one is not positive definite.
Eigen::Vector2d FootSearch::descend(int patch, const Vector3d& x, Eigen::Vector2d xi) const {
  for (int k = 0; k < most_iterations; ++k) {
    const Surface s = surface(patch, xi);
    const Vector3d d = s.S - x;
    Eigen::Vector2d g(d.dot(s.S1), d.dot(s.S2));
    Eigen::Matrix2d H;
    H << s.S1.dot(s.S1), s.S1.dot(s.S2), s.S1.dot(s.S2), s.S2.dot(s.S2);
    Eigen::Matrix2d full;
    full << d.dot(s.S11), d.dot(s.S12), d.dot(s.S12), d.dot(s.S22);
    full += H;
    if (full.determinant() > 0.1 * H.determinant() && full.trace() > 0) H = full;
    for (int i = 0; i < 2; ++i)
      if ((xi[i] <= 0 && g[i] > 0) || (xi[i] >= 1 && g[i] < 0)) {
        g[i] = 0;
        H(0, 1) = H(1, 0) = 0;
      }
    const Eigen::Vector2d next = (xi - H.inverse() * g).cwiseMax(0).cwiseMin(1);
    const double change = (next - xi).cwiseAbs().maxCoeff();
    xi = next;
    if (change <= settled) break;
  }
  return xi;
}

// The foot of last time first: most others lie farther away than it, whatever is on them.
void FootSearch::look(Memory& memory, const Vector3d& x) const {
  const int before = memory.epoch >= 0 ? memory.foot.patch : -1;
  double least = std::numeric_limits<double>::infinity();
  const auto try_patch = [&](int patch, const Eigen::Vector2d& from) {
    const Eigen::Vector2d xi = descend(patch, x, from);
    const double distance = (surface(patch, xi).S - x).norm();
    if (distance < least) least = distance, memory.foot.patch = patch, memory.foot.xi = xi;
  };
  if (before >= 0) try_patch(before, memory.foot.xi);
  for (const int patch : memory.candidates)
    if (patch != before && (centres_.col(patch) - x).norm() - radii_[patch] - moved_ < least)
      try_patch(patch, {0.5, 0.5});
  const Surface s = surface(memory.foot.patch, memory.foot.xi);
  const Vector3d across = s.S1.cross(s.S2).normalized(), d = x - s.S;
  const double side = d.dot(across) < 0 ? -1 : 1;
  const bool inside = memory.foot.xi.minCoeff() > rim && memory.foot.xi.maxCoeff() < 1 - rim;
  memory.foot.gap = inside ? d.dot(across) : side * d.norm();
  memory.foot.normal = inside || d.norm() < 1e-9 * skin_ ? across : Vector3d(side * d.normalized());
}

// Every patch that may hold the foot of points within the skin of x, the surface moving within it, too.
void FootSearch::collect(Memory& memory, const Vector3d& x) const {
  const Eigen::RowVectorXd away = (centres_.colwise() - x).colwise().norm();
  const double reach = (away.transpose() + radii_).minCoeff() + 4 * skin_;  // some foot lies no farther
  memory.candidates.clear();
  for (Index p = 0; p < away.size(); ++p)
    if (away[p] - radii_[p] <= reach) memory.candidates.push_back(static_cast<int>(p));
  memory.x = x;
}

void FootSearch::renew() {
  reference_ = x_;
  moved_ = 0;
  ++epoch_;
  const Index n = facets_.nodes.cols(), per = facets_.nodes.rows();
  centres_.resize(3, n);
  radii_.resize(n);
  for (Index p = 0; p < n; ++p) {
    Vector3d centre = Vector3d::Zero();
    for (Index a = 0; a < per; ++a) centre += x_.col(facets_.nodes(a, p)) / static_cast<double>(per);
    double radius = 0;
    for (Index a = 0; a < per; ++a) radius = std::max(radius, (x_.col(facets_.nodes(a, p)) - centre).norm());
    centres_.col(p) = centre;
    radii_[p] = lebesgue_ * radius;
  }
}

void FootSearch::move_to(const VectorXd& u) {
  x_ = facets_.X + u.reshaped(3, facets_.X.cols()).matrix();
  moved_ = lebesgue_ * std::sqrt((x_ - reference_).colwise().squaredNorm().maxCoeff());
  if (moved_ > skin_ / 2) renew();
}

FootSearch::Near FootSearch::operator()(Index point, const Vector3d& x, double depth) {
  Memory& memory = memory_[static_cast<size_t>(point)];
  const bool current = memory.epoch == epoch_;
  const double way = current ? (x - memory.x).norm() + moved_ : 0;
  if (current && memory.gap - way > depth) return {memory.gap - way, nullptr};
  const bool listed = current && way <= skin_;
  if (!listed) collect(memory, x);
  look(memory, x);
  if (!listed) memory.epoch = epoch_, memory.gap = memory.foot.gap - moved_;
  if (!(memory.foot.gap < depth)) return {memory.foot.gap, nullptr};
  const Basis a = basis(memory.foot.xi[0]), b = basis(memory.foot.xi[1]);
  memory.foot.N = (a.L * b.L.transpose()).reshaped();
  return {memory.foot.gap, &memory.foot};
}

}  // namespace mb
