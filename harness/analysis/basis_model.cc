#include "harness/analysis/basis_model.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <stdexcept>

#include "mechanics/algebra/dense_eigen.h"
#include "mechanics/rigid/inertia.h"
#include "modal/methods/projection.h"

namespace mb {

namespace {

// In q of u = sqrt(m) Phi q.
System in_metres(const System& full, const Basis& basis, double mass) {
  const Modes& modes = basis.modes;
  System reduced = project(full, modes);
  for (Index i = modes.size() - basis.n_shapes; i < modes.size(); ++i) reduced.M.coeffRef(i, i) = basis.mass_of_shapes;
  const double root = std::sqrt(mass);
  const Index n_elastic = modes.size() - modes.n_rigid;
  const VectorXd lambda = modes.omega.tail(n_elastic).array().square();
  reduced.u0.tail(n_elastic) = (modes.Phi.rightCols(n_elastic).transpose() * (full.K * full.u0)).cwiseQuotient(lambda);
  reduced.M *= mass, reduced.K *= mass;
  reduced.R /= root, reduced.u0 /= root, reduced.v0 /= root;
  reduced.F *= root;
  reduced.modal_damping.W *= root;
  return reduced;
}

class BasisModel final : public FullModel {
 public:
  BasisModel(std::shared_ptr<const FullModel> full, const Basis& basis, double mass)
      : full_(std::move(full)),
        V_(std::sqrt(mass) * basis.modes.Phi),
        mass_(mass),
        system_(in_metres(full_->system(), basis, mass)) {}

  const System& system() const override { return system_; }
  SparseMatrix displacement_at(const Matrix3Xd& points) const override { return seen(full_->displacement_at(points)); }
  SparseMatrix strain_at(const Matrix3Xd& points) const override { return seen(full_->strain_at(points)); }
  MatrixXd polynomials(int) const override { throw std::logic_error("a body in a basis has no polynomials"); }
  ContactPoints contact_points(const RigidSurface& surface, double reach) const override {
    return seen(full_->contact_points(surface, reach));
  }
  ContactPoints boundary() const override { return seen(full_->boundary()); }
  Facets facets(const RigidSurface& surface, double reach) const override {
    Facets all = full_->facets(surface, reach);
    all.U = seen(all.U);
    return all;
  }
  VectorXd translation(const Vector3d& direction) const override {
    return V_.transpose() * (full_->system().M * full_->translation(direction)) / mass_;
  }
  VectorXd places() const override { return {}; }  // its unknowns have none: no momentum is looked for
  Index n_cells() const override { return full_->n_cells(); }
  double mesh_volume() const override { return full_->mesh_volume(); }

  SparseMatrix seen(const SparseMatrix& of_mesh) const { return MatrixXd(of_mesh * V_).sparseView(); }

 private:
  ContactPoints seen(ContactPoints all) const {
    all.U = seen(all.U);
    return all;
  }

  std::shared_ptr<const FullModel> full_;
  MatrixXd V_;
  double mass_;  // [kg] of the shape
  System system_;
};

}  // namespace

Basis with_shapes(const Modes& modes, const MatrixXd& Psi, const System& system, double mass_of_shapes) {
  const Index n = modes.size(), n_s = Psi.cols();
  if (!(mass_of_shapes > 0)) throw std::invalid_argument("static shapes need some mass");
  if (n_s == 0) return {modes};
  const MatrixXd M = Psi.transpose() * (system.M * Psi), K = Psi.transpose() * (system.K * Psi);
  const auto eigen = generalized_eigen(M, K);  // ascending in mu, descending in omega
  if (!eigen || !(eigen->values.minCoeff() > 0))
    throw std::invalid_argument("static shapes have no modes of their own");
  const VectorXd omega = eigen->values.cwiseSqrt().cwiseInverse().reverse();
  Modes all = modes;
  all.omega.conservativeResize(n + n_s);
  all.omega.tail(n_s) = omega;
  all.Phi.conservativeResize(Eigen::NoChange, n + n_s);
  all.Phi.rightCols(n_s) = Psi * eigen->vectors.rowwise().reverse() * omega.asDiagonal();
  all.residual.conservativeResize(n + n_s);
  all.residual.tail(n_s).setConstant(std::nan(""));  // they are none of the body
  return {std::move(all), n_s, mass_of_shapes};
}

Model in_bases(const Model& model, std::span<const Basis> bases) {
  if (bases.size() != model.bodies.size()) throw std::invalid_argument("bases: of every body its own");
  Model reduced{model.scene, {}};
  for (size_t i = 0; i < bases.size(); ++i) {
    const Body& body = model.scene->bodies.at(i);
    const BodyModel& mesh = model.bodies[i];
    const double mass = mass_properties(body.shape, body.material.density).mass;
    auto in_basis = std::make_shared<const BasisModel>(mesh.full, bases[i], mass);
    SparseMatrix displacement = in_basis->seen(mesh.displacement), strain = in_basis->seen(mesh.strain);
    reduced.bodies.push_back({std::move(in_basis), mesh.points, std::move(displacement), std::move(strain)});
  }
  return reduced;
}

}  // namespace mb
