#include "modal/polygons/tree.h"

// CGAL's own assertions would descend the tree again: no build shall cost more tests than another.
#define CGAL_NDEBUG
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace mb {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;

// A leaf: the number of its triangle, with the triangle for CGAL to sort by.
struct Leaf {
  using Id = Index;
  using Point = Kernel::Point_3;
  using Datum = Kernel::Triangle_3;
  Leaf(Id i, const Datum& corners) : number(i), triangle(corners) {}
  explicit Leaf(std::vector<Leaf>::const_iterator other) : Leaf(*other) {}  // as CGAL inserts
  Id number;
  Datum triangle;
  Datum datum() const { return triangle; }
  Point reference_point() const { return triangle.vertex(0); }
  Id id() const { return number; }
};
using Boxes = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Leaf>>;

Leaf leaf(const TriangleMesh& mesh, Index i) {
  const auto corner = [&](int k) {
    const Vector3d v = mesh.vertices.col(mesh.triangles(k, i));
    return Kernel::Point_3(v[0], v[1], v[2]);
  };
  return {i, {corner(0), corner(1), corner(2)}};
}

double squared_distance(const CGAL::Bbox_3& box, const Vector3d& x) {
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    const double beyond = std::max({box.min(k) - x[k], x[k] - box.max(k), 0.0});
    sum += beyond * beyond;
  }
  return sum;
}

// One point's way down the tree, in the form CGAL asks for. Of equal distances the lowest triangle counts, as with
// brute force; boxes are given the rounding of a triangle's distance, so that no tie is lost.
class Descent {
 public:
  using Priority = double;

  Descent(const Polygons& polygons, const Vector3d& x, double within)
      : polygons_(polygons),
        x_(x),
        slack_(1e-14 * (polygons.extent() + x.cwiseAbs().maxCoeff())),
        bound_(up_to(within)) {}

  bool go_further() const { return true; }
  void intersection(const Vector3d& x, const Leaf& at) {
    ++n_triangles;
    const NearestOnTriangle next = polygons_.nearest(at.number, x);
    const double d2 = next.squared_distance;
    if (of < 0 || d2 < best.squared_distance || (d2 == best.squared_distance && at.number < of)) {
      best = next;
      of = at.number;
      bound_ = std::min(bound_, up_to(std::sqrt(d2)));
    }
  }
  template <class Node>
  std::pair<bool, double> do_intersect_with_priority(const Vector3d& x, const Node& node) {
    ++n_boxes;
    const double d2 = squared_distance(node.bbox(), x);
    return {d2 <= bound_, -d2};
  }
  template <class Node>
  bool do_intersect(const Vector3d& x, const Node& node) {
    return do_intersect_with_priority(x, node).first;
  }
  double value(double within) const {
    if (of < 0 || best.squared_distance > within * within) return std::numeric_limits<double>::infinity();
    return polygons_.signed_distance(of, x_, best);
  }

  NearestOnTriangle best{};
  Index of = -1;
  long n_boxes = 0, n_triangles = 0;

 private:
  double up_to(double distance) const { return (distance + slack_) * (distance + slack_); }

  const Polygons& polygons_;
  Vector3d x_;
  double slack_, bound_;
};

}  // namespace

struct PolygonTree::Tree {
  explicit Tree(const Polygons& all) : polygons(all) {
    std::vector<Leaf> leaves;
    leaves.reserve(static_cast<size_t>(all.size()));
    for (Index i = 0; i < all.size(); ++i) leaves.push_back(leaf(all.mesh(), i));
    boxes.do_not_accelerate_distance_queries();  // its search tree of points is of no use to our descent
    boxes.insert(leaves.cbegin(), leaves.cend());
    boxes.build();
  }
  const Polygons& polygons;
  Boxes boxes;
};

PolygonTree::PolygonTree(const Polygons& polygons) : tree_(std::make_unique<const Tree>(polygons)) {}
PolygonTree::~PolygonTree() = default;
PolygonTree::PolygonTree(PolygonTree&&) noexcept = default;
PolygonTree& PolygonTree::operator=(PolygonTree&&) noexcept = default;

PointDistances PolygonTree::distances(const Matrix3Xd& points, double within) const {
  require_finite_points(points);
  if (!(within >= 0)) throw std::invalid_argument("tree: the distance to search within is negative or NaN");
  PointDistances found{VectorXd(points.cols())};
  for (Index j = 0; j < points.cols(); ++j) {
    const Vector3d x = points.col(j);
    Descent descent(tree_->polygons, x, within);
    tree_->boxes.traversal_with_priority(x, descent);
    found.value[j] = descent.value(within);
    found.n_boxes += descent.n_boxes;
    found.n_triangles += descent.n_triangles;
  }
  return found;
}

long PolygonTree::bytes() const {
  using Node = std::remove_cvref_t<decltype(*std::declval<const Boxes&>().root_node())>;
  const long n = tree_->polygons.size();
  return (n - 1) * static_cast<long>(sizeof(Node)) + n * static_cast<long>(sizeof(Leaf));
}

}  // namespace mb
