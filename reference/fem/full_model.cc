#include "reference/full_model.h"

#include "reference/fem/assembly.h"
#include "reference/fem/discretisation.h"
#include "reference/fem/evaluation.h"
#include "reference/fem/supports.h"

namespace mb {

namespace {

class DealiiModel final : public FullModel {
 public:
  DealiiModel(const Scene& scene, const Body& body, const Resolution& resolution)
      : mesh_(body.shape, resolution), supports_(fem::condense(mesh_, body.supports)) {
    const fem::Matrices full = fem::assemble(mesh_, body.material);
    const SparseMatrix& T = supports_.T;
    const bool unsupported = body.supports.empty();
    system_.M = unsupported ? full.M : SparseMatrix(T.transpose() * full.M * T);
    system_.K = unsupported ? full.K : SparseMatrix(T.transpose() * full.K * T);
    system_.damping = body.damping;
    system_.R = fem::free_rigid_modes(mesh_, supports_, system_.M);
    system_.F = T.transpose() * loads(scene, body);
    for (const Load& load : scene.loads) system_.s.push_back(load.history);
    system_.u0 = system_.v0 = VectorXd::Zero(T.cols());
    mesh_volume_ = full.mesh_volume;
  }

  const System& system() const override { return system_; }
  SparseMatrix displacement_at(const Matrix3Xd& points) const override {
    return fem::displacement_at(mesh_, points) * supports_.T;
  }
  SparseMatrix strain_at(const Matrix3Xd& points) const override { return fem::strain_at(mesh_, points) * supports_.T; }
  Index n_cells() const override { return mesh_.mesh.n_active_cells(); }
  double mesh_volume() const override { return mesh_volume_; }

 private:
  MatrixXd loads(const Scene& scene, const Body& body) const {
    MatrixXd F = MatrixXd::Zero(mesh_.n_dofs(), static_cast<Index>(scene.loads.size()));
    for (size_t l = 0; l < scene.loads.size(); ++l)
      for (const Traction& traction : scene.loads[l].tractions)
        if (traction.body == body.name)
          F.col(static_cast<Index>(l)) += fem::patch_load(mesh_, traction.patch, traction.traction);
    return F;
  }

  fem::Discretisation mesh_;
  fem::Supports supports_;
  System system_;
  double mesh_volume_ = 0;
};

}  // namespace

std::shared_ptr<const FullModel> full_model(const Scene& scene, const Body& body, const Resolution& resolution) {
  return std::make_shared<DealiiModel>(scene, body, resolution);
}

Model build_model(std::shared_ptr<const Scene> scene, const Resolution* resolution) {
  Model model{scene, {}};
  for (const Body& body : scene->bodies) {
    const auto full = full_model(*scene, body, resolution ? *resolution : body.resolution);
    const EvaluationPoints points = evaluation_points(*scene, body);
    model.bodies.push_back({full, points, full->displacement_at(points.all()), full->strain_at(points.volume.points)});
  }
  return model;
}

}  // namespace mb
