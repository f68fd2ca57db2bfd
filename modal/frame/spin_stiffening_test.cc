// The stiffening that rotation brings, on meshes.
#include <gtest/gtest.h>

#include <cmath>

#include "cases/scene/one_body.h"
#include "mechanics/geometry/shape.h"
#include "modal/bases/eigenmodes.h"
#include "modal/contact/floating_bodies_test.h"
#include "modal/frame/spin.h"
#include "reference/full_model.h"

namespace mb {
namespace {

struct Rod {
  Rod(const Vector3d& size, const Resolution& mesh, int r)
      : scene(one_body(Box{size}, {2e11, 0.3, 7800}, mesh)),
        full(full_model(scene, scene.bodies[0], mesh)),
        shift(physical_shift(scene.bodies[0])),
        modes(lowest_modes(full->system(), r, shift)) {}
  MatrixXd Phi() const { return modes.Phi.rightCols(modes.size() - modes.n_rigid); }
  Scene scene;
  std::shared_ptr<const FullModel> full;
  double shift;
  Modes modes;
};

TEST(SpinStiffening, WithoutItTheMeshsIntegralsAreThoseOfAnyQuadrature) {
  const Rod rod({0.3, 0.1, 0.05}, {2, {4, 2, 1}}, 8);
  const MatrixXd Phi = rod.Phi();
  const SpinCoupling of_mesh = spin_coupling(*rod.full, Phi, false, rod.shift);
  const Quadrature volume = volume_quadrature(Box{{0.3, 0.1, 0.05}});
  const MatrixXd at = rod.full->displacement_at(volume.points) * Phi;
  const SpinCoupling of_points = spin_coupling(volume.points, 7800 * volume.weights, at);
  // Fields with kinks where cells meet, by Gauss points over the whole box.
  const auto near = [](const MatrixXd& a, const MatrixXd& b) { return (a - b).norm() < 0.03 * b.norm() + 1e-4; };
  EXPECT_TRUE(near(of_mesh.A, of_points.A));
  for (size_t k = 0; k < 6; ++k) EXPECT_TRUE(near(of_mesh.H[k], of_points.H[k])) << k;
  for (size_t k = 0; k < 3; ++k) EXPECT_TRUE(near(of_mesh.D[k], of_points.D[k])) << k;
  EXPECT_EQ(of_mesh.s, 0);
  const MatrixXd sum = of_mesh.H[0] + of_mesh.H[1] + of_mesh.H[2];  // 2 Phi^T M Phi
  EXPECT_LT((sum - 2 * MatrixXd::Identity(sum.rows(), sum.cols())).norm(), 1e-9);
}

// A rod that spins about its middle pulls with N = rho A Omega^2 (l^2/4 - x^2)/2, which stiffens bending by int N w'^2
// (Southwell & Gough 1921): of the lowest mode of a free rod, cosh and cos with beta l = 4.7300.
TEST(SpinStiffening, OfASlenderRodIsItsTensions) {
  const double l = 0.6;
  const Rod rod({l, 0.02, 0.012}, {2, {24, 1, 1}}, 2);
  const MatrixXd Phi = rod.Phi();
  const SpinCoupling soft = spin_coupling(*rod.full, Phi, false, rod.shift),
                     stiff = spin_coupling(*rod.full, Phi, true, rod.shift);
  const double bl = 4.730040745, k = (std::cosh(bl) - std::cos(bl)) / (std::sinh(bl) - std::sin(bl));
  double pulled = 0, norm = 0;
  const int n = 20000;
  for (int i = 0; i < n; ++i) {
    const double s = (i + 0.5) / n, x = (s - 0.5) * l, b = bl * s;
    const double w = std::cosh(b) + std::cos(b) - k * (std::sinh(b) + std::sin(b));
    const double slope = bl / l * (std::sinh(b) - std::sin(b) - k * (std::cosh(b) + std::cos(b)));
    norm += w * w;
    pulled += (l * l / 4 - x * x) / 2 * slope * slope;
  }
  const double a = pulled / norm;  // 3.05, against the 1 of the softening in the plane of rotation
  // The lowest mode bends along z, the thin way; spin about z (out of the plane of rotation) and about y (in it).
  const auto by = [&](const SpinCoupling& of, int axis) {  // sum w_ab H_ab of mode 0 for Omega = e_axis
    double sum = 0;
    for (int j = 0; j < 3; ++j)
      if (j != axis) sum += of.H[static_cast<size_t>(j)](0, 0) / 2;
    return sum;
  };
  EXPECT_NEAR(by(soft, 2), 0, 5e-3);  // rotation of sections: (h/l)^2
  EXPECT_NEAR(by(soft, 1), 1, 5e-3);
  EXPECT_NEAR(by(soft, 2) - by(stiff, 2), a, 0.01 * a);  // Timoshenko's part
  EXPECT_NEAR(by(soft, 1) - by(stiff, 1), a, 0.01 * a);
  EXPECT_GT(stiff.s, 0);
  EXPECT_GT(stiff.g, 0);
}

}  // namespace
}  // namespace mb
