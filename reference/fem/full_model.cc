#include "reference/full_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "cases/contract/physical_shift.h"
#include "cases/contract/touchdown.h"
#include "mechanics/system/static_response.h"
#include "reference/fem/assembly.h"
#include "reference/fem/contact_surface.h"
#include "reference/fem/discretisation.h"
#include "reference/fem/evaluation.h"
#include "reference/fem/finite_strain.h"
#include "reference/fem/stress_stiffness.h"
#include "reference/fem/supports.h"
#include "reference/theory/theory_model.h"

namespace mb {

namespace {

// Within a multiplet any basis will do, and which one a solver finds is chance: ratios that differ there say nothing.
void require_one_ratio_a_multiplet(const Modes& found, const std::vector<double>& ratios) {
  for (size_t i = 1; i < ratios.size(); ++i) {
    const double omega = found.omega[found.n_rigid + static_cast<Index>(i)];
    const double below = found.omega[found.n_rigid + static_cast<Index>(i) - 1];
    if (ratios[i] == ratios[i - 1] || !are_one_multiplet(below * below, omega * omega, found.lambda_max)) continue;
    throw std::invalid_argument(
        fmt::format("damping ratios {} and {} of the elastic modes {} and {}, which have one frequency ({:.6g} Hz): "
                    "state one ratio for both",
                    ratios[i - 1], ratios[i], i, i + 1, omega / (2 * pi)));
  }
}

// C phi_i = 2 zeta_i omega_i M phi_i for the modes whose ratios are stated, by what Rayleigh damping leaves to add.
ModalDamping ratios_as_damping(const System& s, const Body& body, const ModeSolver& modes) {
  const std::vector<double>& ratios = body.damping_ratios;
  if (!modes) throw std::invalid_argument("damping ratios of single modes: full order needs a solver for its modes");
  if (!std::all_of(ratios.begin(), ratios.end(), [](double zeta) { return zeta >= 0 && zeta <= 1e9; }))
    throw std::invalid_argument("damping ratios must lie in [0, 1e9]");
  const Index n_ratios = static_cast<Index>(ratios.size());
  const Modes found = modes(s, body, static_cast<int>(n_ratios));
  const Index n = found.size() - found.n_rigid;
  if (n < n_ratios) throw std::invalid_argument(fmt::format("{} damping ratios, but only {} modes", n_ratios, n));
  require_one_ratio_a_multiplet(found, ratios);
  ModalDamping damping{s.M * found.Phi.rightCols(n), VectorXd(n)};
  for (Index i = 0; i < n; ++i) {
    const double omega = found.omega[found.n_rigid + i], zeta = ratios[static_cast<size_t>(std::min(i, n_ratios - 1))];
    damping.d[i] = 2 * zeta * omega - s.damping.alpha - s.damping.beta * omega * omega;
  }
  return damping;
}

// c w w^T for each dashpot, w^T u its patch's mean of u . n.
void add_dashpots(const Body& body, const fem::Discretisation& mesh, const SparseMatrix& T, ModalDamping& damping) {
  const Index n_before = damping.d.size(), n = static_cast<Index>(body.dashpots.size());
  damping.W.conservativeResize(T.cols(), n_before + n);
  damping.d.conservativeResize(n_before + n);
  for (Index i = 0; i < n; ++i) {
    const Dashpot& dashpot = body.dashpots[static_cast<size_t>(i)];
    const VectorXd weighted = fem::patch_load(mesh, dashpot.patch, dashpot.direction, 0);
    const double area = weighted.dot(fem::translation(mesh, dashpot.direction));  // [m^2] int w dA
    damping.W.col(n_before + i) = T.transpose() * weighted / area;
    damping.d[n_before + i] = dashpot.damping;
  }
}

// [m] body frame, one a contact.
std::vector<Vector3d> first_touches(const Scene& scene, const Body& body) {
  std::vector<Vector3d> X;
  for (const TouchedAt& at : touched_at(scene, body)) X.push_back(at.X);
  return X;
}

std::vector<Vector3d> foci(const Scene& scene, const Body& body, const Resolution& resolution) {
  return resolution.graded > 0 ? first_touches(scene, body) : std::vector<Vector3d>{};
}

class DealiiModel final : public FullModel {
 public:
  DealiiModel(const Scene& scene, const Body& body, const Resolution& resolution, const ModeSolver& modes)
      : mesh_(body.shape, resolution, foci(scene, body, resolution)),
        supports_(fem::condense(mesh_, body.supports)),
        material_(body.material) {
    const fem::Matrices full = fem::assemble(mesh_, body.material);
    const SparseMatrix& T = supports_.T;
    const bool all_free = T.rows() == T.cols();  // nothing held, nothing hanging: T = 1
    system_.M = all_free ? full.M : SparseMatrix(T.transpose() * full.M * T);
    system_.K = all_free ? full.K : SparseMatrix(T.transpose() * full.K * T);
    system_.lumped_mass = T.transpose() * fem::lumped_mass(mesh_, body.material.density).asDiagonal() * T;
    system_.damping = body.damping;
    system_.R = fem::free_rigid_modes(mesh_, supports_, system_.M);
    apply_loads(scene, body, full.M);
    system_.u0 = system_.v0 = VectorXd::Zero(T.cols());
    if (body.supports.empty() && !body.twist.velocity.isZero(0))
      system_.v0 = translation(body.pose.orientation.conjugate() * body.twist.velocity);
    mesh_volume_ = full.mesh_volume;
    if (!body.damping_ratios.empty())
      system_.modal_damping = ratios_as_damping(system_, body, modes);
    else
      system_.modal_damping.W = MatrixXd(T.cols(), 0);
    add_dashpots(body, mesh_, T, system_.modal_damping);
    if (body.kinematics == Kinematics::finite) {
      if (!body.damping_ratios.empty())
        throw std::invalid_argument("body '" + body.name +
                                    "': damping ratios of single modes are of linear kinematics");
      system_.stored_energy = std::make_shared<fem::FiniteStrain>(mesh_, supports_, body.material, system_);
    }
    if (body.settled) system_.u0 = bent_by_weight(body);
  }

  const System& system() const override { return system_; }
  SparseMatrix displacement_at(const Matrix3Xd& points) const override {
    return fem::displacement_at(mesh_, points) * supports_.T;
  }
  SparseMatrix strain_at(const Matrix3Xd& points) const override { return fem::strain_at(mesh_, points) * supports_.T; }
  MatrixXd polynomials(int degree) const override { return fem::polynomials(mesh_, supports_, degree); }
  ContactPoints contact_points(const RigidSurface& surface, double reach) const override {
    ContactPoints points = fem::contact_points(mesh_, surface, reach);
    points.U = SparseMatrix(points.U * supports_.T);
    return points;
  }
  Facets facets(const RigidSurface& surface, double reach) const override {
    Facets all = fem::facets(mesh_, surface, reach);
    all.U = SparseMatrix(all.U * supports_.T);
    return all;
  }
  VectorXd translation(const Vector3d& direction) const override {
    return fem::translation(mesh_, direction)(supports_.kept);
  }
  ContactPoints boundary() const override {
    ContactPoints points = fem::boundary(mesh_);
    points.U = SparseMatrix(points.U * supports_.T);
    return points;
  }
  SparseMatrix stress_stiffness(const VectorXd& u) const override {
    const SparseMatrix G = fem::stress_stiffness(mesh_, material_, supports_.T * u);
    return supports_.T.transpose() * G * supports_.T;
  }
  VectorXd places() const override { return mesh_.node_positions().reshaped()(supports_.kept); }
  Index n_cells() const override { return mesh_.mesh.n_active_cells(); }
  double mesh_volume() const override { return mesh_volume_; }

 private:
  // K u = weight, of no rigid motion that the supports leave: what of the weight would bring such about stays.
  VectorXd bent_by_weight(const Body& body) const {
    const VectorXd weight = system_.F.rowwise().sum();
    return inertia_relief(system_, shifted_factor(system_, physical_shift(body)), weight);
  }
  void apply_loads(const Scene& scene, const Body& body, const SparseMatrix& M_full) {
    const std::optional<Drive> drive = fem::common_drive(body.supports);
    const Index n_loads = static_cast<Index>(scene.loads.size());
    const Vector3d gravity = body.pose.orientation.conjugate() * scene.gravity;
    const bool weighs = !gravity.isZero(0);
    MatrixXd F = MatrixXd::Zero(mesh_.n_dofs(), n_loads + (drive ? 1 : 0) + (weighs ? 1 : 0));
    for (Index l = 0; l < n_loads; ++l) {
      const Load& load = scene.loads[static_cast<size_t>(l)];
      for (const Traction& t : load.tractions)
        if (t.body == body.name) F.col(l) += fem::patch_load(mesh_, t.patch, t.traction, t.pressure);
      system_.s.push_back(load.history);
    }
    if (drive) {
      F.col(n_loads) = -(M_full * fem::translation(mesh_, drive->direction));
      system_.s.push_back(drive->acceleration);
    }
    if (weighs) {
      F.rightCols(1) = M_full * fem::translation(mesh_, gravity);
      system_.s.push_back(Step{});
    }
    system_.F = supports_.T.transpose() * F;
    if (std::ranges::none_of(scene.loads, &Load::follows)) return;
    for (const Load& load : scene.loads) system_.follows.push_back(load.follows);
    system_.follows.resize(system_.s.size(), false);
  }

  fem::Discretisation mesh_;
  fem::Supports supports_;
  Material material_;
  System system_;
  double mesh_volume_ = 0;
};

bool touches(const Scene& scene, const Body& body) {
  return std::ranges::any_of(scene.contacts,
                             [&](const auto& c) { return c.body == body.name || c.obstacle == body.name; });
}

// Of body i, where the whole scene has one resolution.
Resolution mesh_of(const Scene& scene, size_t i, const Resolution& resolution) {
  Resolution mesh = of_body(resolution, i);
  if (!touches(scene, scene.bodies[i])) mesh.graded = 0;
  return mesh;
}

}  // namespace

std::shared_ptr<const FullModel> full_model(const Scene& scene, const Body& body, const Resolution& resolution,
                                            const ModeSolver& modes) {
  if (body.theory != Theory::solid) return theory_model(scene, body, resolution);
  return std::make_shared<DealiiModel>(scene, body, resolution, modes);
}

Model build_model(std::shared_ptr<const Scene> scene, const Resolution* resolution, const ModeSolver& modes) {
  Model model{scene, {}};
  for (size_t i = 0; i < scene->bodies.size(); ++i) {
    const Body& body = scene->bodies[i];
    const Resolution mesh = resolution ? mesh_of(*scene, i, *resolution) : body.resolution;
    const auto full = full_model(*scene, body, mesh, modes);
    const EvaluationPoints points = evaluation_points(*scene, body);
    model.bodies.push_back({full, points, full->displacement_at(points.all()), full->strain_at(points.strained())});
  }
  return model;
}

double missing_volume(const Scene& scene, const Resolution& resolution) {
  double missing = 0;
  for (size_t i = 0; i < scene.bodies.size(); ++i) {
    const Body& body = scene.bodies[i];
    if (body.theory != Theory::solid) continue;  // its modes are of the shape itself
    const Resolution mesh = mesh_of(scene, i, resolution);
    missing += std::abs(1 - fem::mesh_volume({body.shape, mesh, foci(scene, body, mesh)}) / volume(body.shape));
  }
  return missing;
}

}  // namespace mb
