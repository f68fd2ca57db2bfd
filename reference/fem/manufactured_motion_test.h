// For tests, a manufactured solution of the dynamic reference, in space and time: a body moves by
//
//   u = f(x) sin(omega t),   b = rho u'' + alpha rho u' - div(sigma(u) + beta sigma(u'))
//
// f as in manufactured_test.h, b [N/m^3] the body force that keeps it so. Nothing is of unit size. Integrals are taken
// cell by cell, p + 2 points a direction, whatever the shape of the cells. A box is held on all its faces, where f
// vanishes. Any other body is free, alpha = 0, and the tractions that f has on its surface come in by parts:
//
//   int b . v + int ((sigma(u) + beta sigma(u')) n) . v dA = int rho u'' . v + int (sigma(u) + beta sigma(u')) : grad v
#pragma once

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <functional>

#include "mechanics/algebra/cholesky.h"
#include "reference/fem/supports.h"
#include "reference/full_model.h"
#include "reference/manufactured_test.h"
#include "reference/static_answer.h"

namespace mb::testing {

inline const Vector3d manufactured_size{0.3, 0.2, 0.4};  // [m] of f's waves
inline constexpr double manufactured_omega =
    87;  // [rad/s] below the first mode: 300 1/s of the box, 113 1/s of a cylinder of its length
inline constexpr double manufactured_end = 0.113;  // [s] a period and a half

class ManufacturedMotion {
 public:
  explicit ManufacturedMotion(const Resolution& mesh, const Shape& shape = Box{manufactured_size})
      : damping_{std::holds_alternative<Box>(shape) ? 3.7 : 0, 2.3e-4},
        scene_(scene_of(shape, mesh)),
        mesh_(shape, mesh) {
    const Body& body = scene_.bodies[0];
    T_ = fem::condense(mesh_, body.supports).T;
    system_ = full_model(scene_, body, mesh)->system();
    const bool is_box = std::holds_alternative<Box>(shape);
    VectorXd inertia = VectorXd::Zero(mesh_.n_dofs()), elastic = inertia;
    for_each_point([&](const Point& p) {
      const Field f = field(manufactured_size, waves_, p.x);
      const Vector3d force = p.w * stuff_.density * f.u, source = -p.w * divergence(f);
      const Eigen::Matrix3d flux = p.w * stress(f);
      for (size_t a = 0; a < p.nodes.size(); ++a) {
        const auto i = static_cast<Index>(a);
        inertia.segment<3>(3 * p.nodes[a]) += p.N[i] * force;
        elastic.segment<3>(3 * p.nodes[a]) += is_box ? Vector3d(p.N[i] * source) : flux * p.dN.row(i).transpose();
      }
    });
    load(T_.transpose() * inertia, T_.transpose() * elastic);
  }
  const System& system() const { return system_; }

  struct Errors {
    double displacement, strain;  // [-] L2, relative to the amplitude
  };
  Errors errors(const VectorXd& u, double t) const {
    const VectorXd full = T_ * u;
    const double sine = std::sin(manufactured_omega * t);
    double of_u = 0, of_e = 0, size_u = 0, size_e = 0;
    for_each_point([&](const Point& p) {
      Vector3d here = Vector3d::Zero();
      Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();
      for (size_t a = 0; a < p.nodes.size(); ++a) {
        const Vector3d node = full.segment<3>(3 * p.nodes[a]);
        here += p.N[static_cast<Index>(a)] * node;
        gradient += node * p.dN.row(static_cast<Index>(a));
      }
      const Field f = field(manufactured_size, waves_, p.x);
      const Eigen::Matrix3d e = (gradient + gradient.transpose()) / 2,
                            exact = (f.gradient + f.gradient.transpose()) / 2;
      of_u += p.w * (here - sine * f.u).squaredNorm(), size_u += p.w * f.u.squaredNorm();
      of_e += p.w * (e - sine * exact).squaredNorm(), size_e += p.w * exact.squaredNorm();
    });
    return {std::sqrt(of_u / size_u), std::sqrt(of_e / size_e)};
  }

 private:
  struct Point {
    Vector3d x;
    double w;                  // [m^3]
    std::vector<Index> nodes;  // of its cell
    VectorXd N;
    MatrixXd dN;  // nodes x 3
  };

  Scene scene_of(const Shape& shape, const Resolution& mesh) const {
    Scene scene = one_body(shape, stuff_, mesh);
    scene.bodies[0].damping = damping_;
    if (std::holds_alternative<Box>(shape))
      for (const char* name : {"x-min", "x-max", "y-min", "y-max", "z-min", "z-max"})
        scene.bodies[0].supports.push_back(support(Support::Kind::fixed, face(name)));
    return scene;
  }

  double lambda() const {  // [Pa] Lame's first
    return 2 * shear_modulus(stuff_) * stuff_.poissons_ratio / (1 - 2 * stuff_.poissons_ratio);
  }

  Eigen::Matrix3d stress(const Field& f) const {  // [Pa]
    return lambda() * f.gradient.trace() * Eigen::Matrix3d::Identity() +
           shear_modulus(stuff_) * (f.gradient + f.gradient.transpose());
  }

  // div sigma of the linear field, [N/m^3]
  Vector3d divergence(const Field& f) const {
    const double mu = shear_modulus(stuff_);
    Vector3d sum = Vector3d::Zero();
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const auto& second = f.second[static_cast<size_t>(j)];
        sum[i] += (lambda() + mu) * second(i, j);
        sum[j] += mu * second(i, i);
      }
    return sum;
  }

  void load(const VectorXd& inertia, const VectorXd& elastic) {
    const double omega = manufactured_omega;
    system_.F.resize(inertia.size(), 2);
    system_.F << elastic - omega * omega * inertia, omega * (damping_.alpha * inertia + damping_.beta * elastic);
    system_.s = {Harmonic{omega}, Harmonic{.omega = omega, .phase = pi / 2}};
    // Starts in the mesh's own answer, f's projection by energy, with mass where none holds the body: no mode rings.
    const double shift = system_.R.cols() > 0 ? omega * omega : 0;
    system_.u0 = VectorXd::Zero(inertia.size());
    system_.v0 =
        omega * Cholesky(SparseMatrix(system_.K + shift * system_.M)).solve(VectorXd(elastic + shift * inertia));
  }

  void for_each_point(const std::function<void(const Point&)>& visit) const {
    const dealii::QGauss<3> rule(mesh_.element.degree + 2);
    dealii::FEValues<3> values(mesh_.mapping, mesh_.element, rule,
                               dealii::update_values | dealii::update_gradients | dealii::update_JxW_values |
                                   dealii::update_quadrature_points);
    const unsigned n = values.dofs_per_cell;
    std::vector<dealii::types::global_dof_index> ids(n);
    Point p{{}, 0, std::vector<Index>(n), VectorXd(n), MatrixXd(n, 3)};
    for (const auto& cell : mesh_.nodes.active_cell_iterators()) {
      values.reinit(cell);
      cell->get_dof_indices(ids);
      p.nodes.assign(ids.begin(), ids.end());
      for (unsigned q = 0; q < rule.size(); ++q) {
        p.w = values.JxW(q);
        for (unsigned k = 0; k < 3; ++k) p.x[k] = values.quadrature_point(q)[k];
        for (unsigned a = 0; a < n; ++a) {
          p.N[a] = values.shape_value(a, q);
          for (unsigned k = 0; k < 3; ++k) p.dN(a, k) = values.shape_grad(a, q)[k];
        }
        visit(p);
      }
    }
  }

  const Material stuff_{7.1e5, 0.31, 1300};
  const Waves waves_{{{1.2e-4, -0.9e-4, 2e-4}, {1, 1, 1}}, {{-0.4e-4, 0.6e-4, 0.5e-4}, {1, 1, 2}}};
  const Rayleigh damping_;
  const Scene scene_;
  const fem::Discretisation mesh_;
  SparseMatrix T_;
  System system_;
};

inline VectorXd at_the_end(const Stepper& stepper) {
  const States states = stepper.run(VectorXd::Constant(1, manufactured_end));
  EXPECT_EQ(states.status, Status::ok);
  return states.u.col(0);
}

}  // namespace mb::testing
