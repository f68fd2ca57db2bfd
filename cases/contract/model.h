// What is asked: a scene with its bodies discretised, and the points where answers are compared.
#pragma once

#include <memory>
#include <vector>

#include "cases/scene/scene.h"
#include "mechanics/contact/contact.h"
#include "mechanics/system/system.h"

namespace mb {

// Fixed quadrature in the exact shape, the same for every mesh: volume, then surface, then the scene's probes.
struct EvaluationPoints {
  Quadrature volume, surface;
  Matrix3Xd probes;            // [m] 3 x number of probes of this body
  Matrix3Xd all() const;       // 3 x (volume + surface + probes)
  Matrix3Xd strained() const;  // 3 x (volume + probes): where strains are compared
  Index size() const;
  Index n_strained() const;
  Index strained(Index p) const;  // the place in strained() of point p of all(); -1 for those of the surface
};
EvaluationPoints evaluation_points(const Scene& scene, const Body& body);

// A discretised body: stated here, implemented in reference; a mesh never leaves reference. A body evaluates a point in
// the polynomial of its nearest cell, the lowest index on ties, points slightly outside the mesh included.
class FullModel {
 public:
  virtual ~FullModel() = default;
  virtual const System& system() const = 0;
  virtual SparseMatrix displacement_at(const Matrix3Xd& points) const = 0;  // 3 p x n: xyz of point 0, of point 1, ...
  virtual SparseMatrix strain_at(const Matrix3Xd& points) const = 0;  // 6 p x n: Voigt xx yy zz yz xz xy, engineering
  // n x k: polynomials in x, y, z of at most that degree (>= 0) for each component which every support admits, at the
  // degrees of freedom; of full rank, columns of comparable size. A free body: 3, 12, 30 columns for degree 0, 1, 2.
  virtual MatrixXd polynomials(int degree) const = 0;
  // Points of the boundary that may touch an obstacle, which stands in the body's axes as at the first touch: faces
  // within `reach` [m] of it that look at it; infinity: all of the boundary. Throws std::invalid_argument where there
  // is none. Throws std::logic_error of a model that cannot touch, likewise `facets` and
  // `translation`.
  virtual ContactPoints contact_points(const RigidSurface& surface, double reach) const;
  virtual Facets facets(const RigidSurface& surface, double reach) const;  // the same faces, as another body meets them
  // Unknowns that move a body without supports by `direction` [m]: n.
  virtual VectorXd translation(const Vector3d& direction) const;
  // All points of the boundary, in the order of the above. Throws as it does.
  virtual ContactPoints boundary() const;
  // [m] n: places of the unknowns of a body without supports, xyz of node 0, of node 1, ... Throws as above.
  virtual VectorXd places() const;
  // [N/m] n x n, symmetric: what the stress of u [m] does to forces when displacements turn it. Throws as above.
  virtual SparseMatrix stress_stiffness(const VectorXd& u) const;
  virtual Index n_cells() const = 0;
  virtual double mesh_volume() const = 0;  // [m^3]
};

struct BodyModel {
  std::shared_ptr<const FullModel> full;
  EvaluationPoints points;
  SparseMatrix displacement;  // 3 p x n at points.all()
  SparseMatrix strain;        // 6 p x n at points.strained()
};

struct Model {
  std::shared_ptr<const Scene> scene;
  std::vector<BodyModel> bodies;  // in the scene's order
};

}  // namespace mb
