#include "reference/fem/discretisation.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>

#include "cases/scene/resolution.h"
#include "reference/fem/box_mesh.h"
#include "reference/fem/superquadric_mesh.h"

namespace mb::fem {

namespace {

using Mesh = dealii::Triangulation<3>;
using Point = dealii::Point<3>;

constexpr dealii::types::manifold_id curved = 0;

// Four faces bent to a circle: between its ends on the circle a point is moved along the face's normal, x or y, until
// it lies on the circle too,
//
//   (x, y) -> (sqrt(R^2 - y^2), y)
//
// At a vertex of the block the circle leaves no angle for a corner: 180 degrees, Jacobian 0. The polynomials through
// these points keep a corner, since their slopes approach the circle's from below; through points at equal angles the
// slopes of cubics and quartics exceed it, and the Jacobian would change its sign.
class BentSquare final : public dealii::Manifold<3> {
 public:
  explicit BentSquare(double radius) : radius_(radius) {}
  std::unique_ptr<dealii::Manifold<3>> clone() const override { return std::make_unique<BentSquare>(radius_); }
  Point get_new_point(const dealii::ArrayView<const Point>& points,
                      const dealii::ArrayView<const double>& weights) const override {
    Point p;
    for (size_t i = 0; i < points.size(); ++i) p += weights[i] * points[i];
    const unsigned normal = std::abs(p[0]) > std::abs(p[1]) ? 0 : 1;
    const double along = p[1 - normal];
    p[normal] = std::copysign(std::sqrt(radius_ * radius_ - along * along), p[normal]);
    return p;
  }

 private:
  double radius_;  // [m]
};

int refinements(int splits) { return std::bit_width(static_cast<unsigned>(splits)) - 1; }

bool is_one_block(const Shape& shape, const Resolution& resolution) {
  return std::holds_alternative<Cylinder>(shape) && resolution.cells[0] == 0;
}

// The shape, if such a mesh of it can be made.
const Shape& meshable(const Shape& shape, const Resolution& resolution) {
  const auto& cells = resolution.cells;
  bool possible = resolution.degree >= 1 && resolution.degree <= 4 && resolution.graded >= 0 &&
                  resolution.graded <= 12 && cells.size() == n_cell_entries(shape);
  if (!std::holds_alternative<Box>(shape)) possible = possible && resolution.bias.empty() && resolution.distorted == 0;
  for (size_t i = 0; possible && i < cells.size(); ++i) {
    const int least = i == 0 && std::holds_alternative<Cylinder>(shape) ? 0 : 1;
    possible = cells[i] >= least && cells[i] <= 1024;
  }
  if (possible && !std::holds_alternative<Box>(shape) && cells[0] > 0)
    possible = std::has_single_bit(static_cast<unsigned>(cells[0]));
  if (!possible) throw std::invalid_argument("no mesh " + to_string(resolution) + " of such a shape");
  return shape;
}

void make(Mesh& mesh, const Box& box, const Resolution& resolution) { make_box(mesh, box, resolution); }

// Five blocks in the disc, each edge split, or one square in it; extruded along z.
void make(Mesh& mesh, const Cylinder& cylinder, const Resolution& resolution) {
  const std::vector<int>& cells = resolution.cells;
  if (cells[0] == 0) {
    const double edge = std::sqrt(2.0) * cylinder.radius;
    return make_box(mesh, Box{{edge, edge, cylinder.length}}, {1, {1, 1, cells[1]}});
  }
  dealii::Triangulation<2> disc, flat;
  dealii::GridGenerator::hyper_ball(disc, dealii::Point<2>(), cylinder.radius);
  disc.refine_global(static_cast<unsigned>(refinements(cells[0])));
  dealii::GridGenerator::flatten_triangulation(disc, flat);
  dealii::GridGenerator::extrude_triangulation(flat, static_cast<unsigned>(cells[1]) + 1, cylinder.length, mesh);
  dealii::GridTools::shift(Point(0, 0, -0.5 * cylinder.length), mesh);
}

void make(Mesh& mesh, const Sphere& sphere, const Resolution& resolution) {
  dealii::GridGenerator::hyper_ball(mesh, Point(), sphere.radius);
  mesh.refine_global(static_cast<unsigned>(refinements(resolution.cells[0])));
}

void make(Mesh& mesh, const Superquadric& body, const Resolution& resolution) {
  make_superquadric(mesh, {body, 0}, refinements(resolution.cells[0]));
}
void make(Mesh& mesh, const TaperedSuperquadric& body, const Resolution& resolution) {
  make_superquadric(mesh, body, refinements(resolution.cells[0]));
}

// Gives every boundary face the index of the named face that all its vertices lie on; of two such the plane one: the
// ends of a cylinder of one block have their vertices on its side as well.
void name_boundary(Mesh& mesh, const Shape& shape, const std::vector<std::string>& faces) {
  const double tolerance = 1e-9 * extent(shape);  // vertices are placed to rounding
  const auto lies_on = [&](const auto& quad, const std::string& name) {
    for (unsigned v = 0; v < 4; ++v) {
      const Point& p = quad->vertex(v);
      if (std::abs(face_distance(shape, name, Vector3d(p[0], p[1], p[2]))) > tolerance) return false;
    }
    return true;
  };
  for (const auto& quad : mesh.active_face_iterators()) {
    if (!quad->at_boundary()) continue;
    const auto plane = [&](const auto& f) { return is_plane(shape, f) && lies_on(quad, f); };
    auto name = std::find_if(faces.begin(), faces.end(), plane);
    if (name == faces.end())
      name = std::find_if(faces.begin(), faces.end(), [&](const auto& f) { return lies_on(quad, f); });
    if (name == faces.end()) throw std::logic_error("a boundary face lies on no face of the shape");
    quad->set_boundary_id(static_cast<unsigned>(name - faces.begin()));
  }
}

// Curved faces follow the shape, everything else is blended from them by the mapping.
void attach_manifold(Mesh& mesh, const Shape& shape, bool one_block, const std::vector<std::string>& faces) {
  if (std::holds_alternative<Box>(shape)) return;
  mesh.reset_all_manifolds();
  mesh.set_all_manifold_ids(dealii::numbers::flat_manifold_id);
  for (const auto& quad : mesh.active_face_iterators())
    if (quad->at_boundary() && !is_plane(shape, faces[quad->boundary_id()])) quad->set_all_manifold_ids(curved);
  if (one_block)
    mesh.set_manifold(curved, BentSquare(std::get<Cylinder>(shape).radius));
  else if (std::holds_alternative<Cylinder>(shape))
    mesh.set_manifold(curved, dealii::CylindricalManifold<3>(2));
  else if (std::holds_alternative<Sphere>(shape))
    mesh.set_manifold(curved, dealii::SphericalManifold<3>());
  else if (const auto* straight = std::get_if<Superquadric>(&shape))
    mesh.set_manifold(curved, SuperquadricManifold({*straight, 0}));
  else
    mesh.set_manifold(curved, SuperquadricManifold(std::get<TaperedSuperquadric>(shape)));
}

// Halves the cells near the foci as often as the resolution says.
void grade(Mesh& mesh, const Shape& shape, const Resolution& resolution, const std::vector<Vector3d>& foci) {
  if (resolution.graded == 0) return;
  if (foci.empty()) throw std::invalid_argument("mesh " + to_string(resolution) + " without a point to grade it to");
  for (const Vector3d& x : foci)
    if (!contains(shape, x, 1e-6 * extent(shape)))
      throw std::invalid_argument(
          fmt::format("mesh graded to the point ({:.6g}, {:.6g}, {:.6g}) m outside the body", x[0], x[1], x[2]));
  for (int level = 0; level < resolution.graded; ++level) {
    refine_near(mesh, foci);
    const double n_dofs = 3 * std::pow(resolution.degree, 3) * mesh.n_active_cells();
    if (n_dofs > most_dofs)
      throw std::invalid_argument(fmt::format("mesh {} has {:.2g} degrees of freedom after {} gradings: at most {:.0f}",
                                              to_string(resolution), n_dofs, level + 1, most_dofs));
  }
}

}  // namespace

Discretisation::Discretisation(const Shape& shape_, const Resolution& resolution, const std::vector<Vector3d>& foci)
    : shape(meshable(shape_, resolution)),
      faces(face_names(shape_)),
      mapping(static_cast<unsigned>(resolution.degree)),
      element(static_cast<unsigned>(resolution.degree)),
      nodes(mesh) {
  std::visit([&](const auto& s) { make(mesh, s, resolution); }, shape);
  name_boundary(mesh, shape, faces);
  attach_manifold(mesh, shape, is_one_block(shape, resolution), faces);
  grade(mesh, shape, resolution, foci);
  nodes.distribute_dofs(element);
  hanging = hanging_nodes(nodes);
  map_conforming(nodes, hanging, mapping);
  if (resolution.graded > 0 || resolution.distorted > 0) require_sound_cells(nodes, mapping);
}

Matrix3Xd Discretisation::node_positions() const {
  std::vector<Point> points(nodes.n_dofs());
  dealii::DoFTools::map_dofs_to_support_points(mapping, nodes, points);
  Matrix3Xd x(3, n_nodes());
  for (Index a = 0; a < n_nodes(); ++a) {
    const Point& p = points[static_cast<size_t>(a)];
    x.col(a) << p[0], p[1], p[2];
  }
  return x;
}

int Discretisation::boundary_id(const std::string& face) const {
  return static_cast<int>(std::find(faces.begin(), faces.end(), face) - faces.begin());
}

}  // namespace mb::fem
