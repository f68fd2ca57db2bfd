// For tests of methods: a box that is pulled at both ends along z and bent, damped, and starts with a deformation and a
// motion; observed at its degrees of freedom.
#pragma once

#include <memory>
#include <utility>

#include "cases/contract/method.h"
#include "mechanics/algebra/box_test_system.h"
#include "mechanics/system/exact.h"

namespace mb::testing {

inline const Vector3d beam_size(0.09, 0.1, 0.3);  // [m]
inline const Material gelatine{2e4, 0.45, 1100};  // [Pa], [-], [kg/m^3]
inline constexpr double beam_duration = 0.5;      // [s] about five periods of the first mode
inline constexpr double beam_shift = -0.01 * 2e4 / (1100 * 0.3 * 0.3);

// clamped: at z = 0.
inline BoxSystem beam(bool clamped) {
  BoxMesh mesh{.cells = {2, 3, 5}, .size = beam_size, .E = 2e4, .nu = 0.45, .rho = 1100};
  if (clamped) mesh.fixed = [](const Vector3d& x, int) { return x[2] == 0; };
  BoxSystem box = box_system(mesh);
  System& system = box.system;
  system.damping = {.alpha = 1.5, .beta = 1e-4};
  system.F = MatrixXd::Zero(system.M.rows(), 2);
  for (size_t i = 0; i < box.dof.size(); ++i) {
    if (box.dof[i] < 0) continue;
    const Vector3d x = box.nodes.col(static_cast<Index>(i / 3));
    if (i % 3 == 2) system.F(box.dof[i], 0) = 1e-3 * (x[2] / beam_size[2] - 0.5);
    if (i % 3 == 0) system.F(box.dof[i], 1) = 1e-3 * x[2] / beam_size[2];
    system.u0(box.dof[i]) = 1e-3 * x[2] * x[1];
    system.v0(box.dof[i]) = i % 3 == 0 ? 0.1 : 0;
  }
  system.s = {Pulse{.duration = 0.2}, Ramp{.duration = 0.1}};
  return box;
}

class WholeBody : public FullModel {
 public:
  WholeBody(BoxSystem box, bool clamped) : box_(std::move(box)), clamped_(clamped) {}
  const System& system() const override { return box_.system; }
  SparseMatrix displacement_at(const Matrix3Xd&) const override { return identity(); }
  SparseMatrix strain_at(const Matrix3Xd&) const override { return 2 * identity(); }
  // Monomials in coordinates about the centre, scaled; clamped: those with a factor z.
  MatrixXd polynomials(int degree) const override {
    std::vector<VectorXd> columns;
    for (int p = 0; p <= degree; ++p)
      for (int q = 0; p + q <= degree; ++q)
        for (int r = clamped_ ? 1 : 0; p + q + r <= degree; ++r)
          for (int component = 0; component < 3; ++component) columns.push_back(monomial({p, q, r}, component));
    MatrixXd Y(system().M.rows(), static_cast<Index>(columns.size()));
    for (size_t j = 0; j < columns.size(); ++j) Y.col(static_cast<Index>(j)) = columns[j];
    return Y;
  }
  Index n_cells() const override { return 30; }
  double mesh_volume() const override { return beam_size.prod(); }

 private:
  SparseMatrix identity() const { return SparseMatrix(VectorXd::Ones(system().M.rows()).asDiagonal()); }
  VectorXd monomial(const std::array<int, 3>& power, int component) const {
    VectorXd column = VectorXd::Zero(system().M.rows());
    for (Index node = 0; node < box_.nodes.cols(); ++node) {
      const Index dof = box_.dof[static_cast<size_t>(3 * node + component)];
      if (dof < 0) continue;
      column(dof) = 1;
      for (int a = 0; a < 3; ++a) {
        const double origin = clamped_ && a == 2 ? 0 : 0.5;
        column(dof) *= std::pow(box_.nodes(a, node) / beam_size[a] - origin, power[static_cast<size_t>(a)]);
      }
    }
    return column;
  }

  BoxSystem box_;
  bool clamped_;
};

inline Model model_of(const BoxSystem& box, bool clamped) {
  auto scene = std::make_shared<Scene>();
  scene->duration = beam_duration;
  Body body;
  body.name = "beam";
  body.shape = Box{beam_size};
  body.material = gelatine;
  body.damping = box.system.damping;
  body.resolution = {1, {2, 3, 5}};
  scene->bodies.push_back(std::move(body));
  const auto full = std::make_shared<WholeBody>(box, clamped);
  BodyModel modelled{full, {}, full->displacement_at({}), full->strain_at({})};
  Model model;
  model.scene = scene;
  model.bodies.push_back(std::move(modelled));
  return model;
}
inline Model beam_model(bool clamped) { return model_of(beam(clamped), clamped); }

inline const Integrator closed_form{"exact", "closed form",
                                    [](const System& system, const Settings& settings, double end) {
                                      return exact(system, end, settings.load_tolerance);
                                    },
                                    Integrator::Knob::none};

inline VectorXd beam_times() { return VectorXd::LinSpaced(101, 0, beam_duration); }

inline Trajectory simulate(const Method& method, const Model& model, int n_modes, const Sampling& sampling) {
  return method.prepare(model, Settings{.modes = n_modes}, closed_form)->simulate(sampling);
}

// Relative M norm over all times.
inline double error(const System& system, const MatrixXd& u, const MatrixXd& truth) {
  const auto squared = [&](const MatrixXd& x) { return x.cwiseProduct(system.M * x).sum(); };
  return std::sqrt(squared(u - truth) / squared(truth));
}

}  // namespace mb::testing
