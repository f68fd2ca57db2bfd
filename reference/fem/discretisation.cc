#include "reference/fem/discretisation.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <algorithm>
#include <bit>
#include <stdexcept>

#include "mechanics/geometry/overloaded.h"

namespace mb::fem {

namespace {

using Mesh = dealii::Triangulation<3>;
using Point = dealii::Point<3>;

constexpr dealii::types::manifold_id curved = 0;

int refinements(int splits) { return std::bit_width(static_cast<unsigned>(splits)) - 1; }

void make(Mesh& mesh, const Box& box, const std::vector<int>& cells) {
  const Vector3d h = 0.5 * box.size;
  dealii::GridGenerator::subdivided_hyper_rectangle(mesh, std::vector<unsigned>(cells.begin(), cells.end()),
                                                    Point(-h[0], -h[1], -h[2]), Point(h[0], h[1], h[2]));
}

// Five blocks in the disc, each edge split, extruded along z.
void make(Mesh& mesh, const Cylinder& cylinder, const std::vector<int>& cells) {
  dealii::Triangulation<2> disc, flat;
  dealii::GridGenerator::hyper_ball(disc, dealii::Point<2>(), cylinder.radius);
  disc.refine_global(static_cast<unsigned>(refinements(cells[0])));
  dealii::GridGenerator::flatten_triangulation(disc, flat);
  dealii::GridGenerator::extrude_triangulation(flat, static_cast<unsigned>(cells[1]) + 1, cylinder.length, mesh);
  dealii::GridTools::shift(Point(0, 0, -0.5 * cylinder.length), mesh);
}

void make(Mesh& mesh, const Sphere& sphere, const std::vector<int>& cells) {
  dealii::GridGenerator::hyper_ball(mesh, Point(), sphere.radius);
  mesh.refine_global(static_cast<unsigned>(refinements(cells[0])));
}

// Gives every boundary face the index of the named face that all its vertices lie on.
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
    const auto name = std::find_if(faces.begin(), faces.end(), [&](const auto& f) { return lies_on(quad, f); });
    if (name == faces.end()) throw std::logic_error("a boundary face lies on no face of the shape");
    quad->set_boundary_id(static_cast<unsigned>(name - faces.begin()));
  }
}

// Curved faces follow the shape, everything else is blended from them by the mapping.
void attach_manifold(Mesh& mesh, const Shape& shape, const std::vector<std::string>& faces) {
  if (std::holds_alternative<Box>(shape)) return;
  mesh.reset_all_manifolds();
  mesh.set_all_manifold_ids(dealii::numbers::flat_manifold_id);
  for (const auto& quad : mesh.active_face_iterators())
    if (quad->at_boundary() && !is_plane(shape, faces[quad->boundary_id()])) quad->set_all_manifold_ids(curved);
  if (std::holds_alternative<Cylinder>(shape))
    mesh.set_manifold(curved, dealii::CylindricalManifold<3>(2));
  else
    mesh.set_manifold(curved, dealii::SphericalManifold<3>());
}

}  // namespace

Discretisation::Discretisation(const Shape& shape_, const Resolution& resolution)
    : shape(shape_),
      faces(face_names(shape_)),
      mapping(static_cast<unsigned>(resolution.degree)),
      element(static_cast<unsigned>(resolution.degree)),
      nodes(mesh) {
  std::visit([&](const auto& s) { make(mesh, s, resolution.cells); }, shape);
  name_boundary(mesh, shape, faces);
  attach_manifold(mesh, shape, faces);
  nodes.distribute_dofs(element);
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
