#include "cases/contract/model.h"

#include <stdexcept>

namespace mb {

ContactPoints FullModel::contact_points(const RigidSurface&, double) const {
  throw std::logic_error("this model of a body cannot touch anything");
}
Facets FullModel::facets(const RigidSurface&, double) const { throw std::logic_error("this model cannot touch"); }
VectorXd FullModel::translation(const Vector3d&) const {
  throw std::logic_error("this model of a body cannot be moved as a whole");
}
ContactPoints FullModel::boundary() const { throw std::logic_error("this model of a body cannot touch anything"); }
SparseMatrix FullModel::stress_stiffness(const VectorXd&) const {
  throw std::logic_error("this model of a body has no stresses in space");
}
VectorXd FullModel::places() const { throw std::logic_error("this model of a body has no nodes in space"); }

Index EvaluationPoints::size() const { return volume.points.cols() + surface.points.cols() + probes.cols(); }

Matrix3Xd EvaluationPoints::all() const {
  Matrix3Xd x(3, size());
  x << volume.points, surface.points, probes;
  return x;
}

Index EvaluationPoints::n_strained() const { return volume.points.cols() + probes.cols(); }

Matrix3Xd EvaluationPoints::strained() const {
  Matrix3Xd x(3, n_strained());
  x << volume.points, probes;
  return x;
}

Index EvaluationPoints::strained(Index p) const {
  if (p < volume.points.cols()) return p;
  const Index n_surface = surface.points.cols();
  return p < volume.points.cols() + n_surface ? -1 : p - n_surface;
}

EvaluationPoints evaluation_points(const Scene& scene, const Body& body) {
  std::vector<Vector3d> probes;
  for (const Probe& probe : scene.probes)
    if (probe.body == body.name) probes.push_back(probe.point);
  EvaluationPoints points{volume_quadrature(body.shape), surface_quadrature(body.shape),
                          Matrix3Xd(3, static_cast<Index>(probes.size()))};
  for (size_t i = 0; i < probes.size(); ++i) points.probes.col(static_cast<Index>(i)) = probes[i];
  return points;
}

}  // namespace mb
