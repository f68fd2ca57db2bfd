#include "reference/fem/assembly.h"

#include <gtest/gtest.h>

#include "reference/fem/evaluation.h"
#include "reference/fem/supports.h"

namespace mb::fem {
namespace {

const Material rubber{2e4, 0.45, 1100};
// Spruce along x, all nine constants different.
const Material wood{1.2e10, 0, 450, Orthotropy{{1.2e10, 9e8, 5e8}, {0.43, 0.45, 0.37}, {4e7, 7.2e8, 8.5e8}}};
const Shape box = Box{{0.3, 0.2, 0.5}}, cylinder = Cylinder{0.05, 0.2}, sphere = Sphere{0.07};

struct Mesh {
  Shape shape;
  Resolution resolution;
  double tolerance;
};
// The integrands of the divergence theorem on a cell are polynomials of degree 3p - 1 per direction, the quadrature is
// exact to 2p + 1: for p <= 2, or straight cells, only rounding is left; beyond, the quadrature error of curved cells,
// which falls fast as they are split.
const std::vector<Mesh> meshes = {{box, {1, {3, 2, 4}}, 1e-13},
                                  {box, {4, {1, 1, 2}}, 1e-13},
                                  {cylinder, {1, {2, 3}}, 1e-13},
                                  {cylinder, {2, {1, 2}}, 1e-13},
                                  {cylinder, {3, {1, 2}}, 1e-5},
                                  {cylinder, {4, {1, 2}}, 1e-5},
                                  {cylinder, {3, {2, 4}}, 1e-6},
                                  {cylinder, {4, {2, 4}}, 1e-6},
                                  {sphere, {1, {1}}, 1e-13},
                                  {sphere, {2, {1}}, 1e-13},
                                  {sphere, {1, {2}}, 1e-13},
                                  {sphere, {2, {2}}, 1e-13},
                                  {cylinder, {1, {0, 1}}, 1e-13},
                                  {cylinder, {2, {0, 3}}, 1e-13},
                                  {box, {1, {3, 2, 4}, 0, {1, 5, 0.1}, 0.25}, 1e-13},
                                  {box, {2, {3, 2, 4}, 0, {}, 0.2}, 1e-13}};

// Node values of the displacement u = G x.
VectorXd linear_field(const Discretisation& d, const Eigen::Matrix3d& G) {
  const Matrix3Xd u = G * d.node_positions();
  return Eigen::Map<const VectorXd>(u.data(), u.size());
}

const Eigen::Matrix3d gradient =
    (Eigen::Matrix3d() << 1e-2, 3e-3, -2e-3, 5e-3, -4e-3, 1e-3, 7e-3, -6e-3, 8e-3).finished();

Eigen::Matrix<double, 6, 1> voigt_strain(const Eigen::Matrix3d& G) {
  return (Eigen::Matrix<double, 6, 1>() << G(0, 0), G(1, 1), G(2, 2), G(1, 2) + G(2, 1), G(0, 2) + G(2, 0),
          G(0, 1) + G(1, 0))
      .finished();
}

// Patch test: a linear displacement has constant stress, so K u balances the tractions sigma n on the boundary.
TEST(PatchTest, LinearDisplacementBalancesConstantStress) {
  for (const Material& material : {rubber, wood})
    for (const Mesh& mesh : meshes) {
      const Discretisation d(mesh.shape, mesh.resolution);
      const Eigen::Matrix<double, 6, 1> s = elasticity_matrix(material) * voigt_strain(gradient);
      Eigen::Matrix3d sigma;
      sigma << s[0], s[5], s[4], s[5], s[1], s[3], s[4], s[3], s[2];
      VectorXd f = VectorXd::Zero(d.n_dofs());
      for (const auto& face : d.faces) {
        const VectorXd normal = patch_normal(d, {face, {}});
        for (Index a = 0; a < d.n_nodes(); ++a) f.segment<3>(3 * a) += sigma * normal.segment<3>(3 * a);
      }
      const VectorXd residual = assemble(d, material).K * linear_field(d, gradient) - f;
      EXPECT_LT(residual.norm(), mesh.tolerance * f.norm())
          << to_string(mesh.resolution) << " of shape " << mesh.shape.index();
    }
}

TEST(Assembly, MassIsDensityTimesMeshVolume) {
  for (const Mesh& mesh : meshes) {
    const Discretisation d(mesh.shape, mesh.resolution);
    const Matrices matrices = assemble(d, rubber);
    for (int i = 0; i < 3; ++i) {
      VectorXd one = VectorXd::Zero(d.n_dofs());
      for (Index a = 0; a < d.n_nodes(); ++a) one[3 * a + i] = 1;
      const double expected = rubber.density * matrices.mesh_volume;
      EXPECT_NEAR(one.dot(matrices.M * one), expected, 1e-12 * expected);
    }
  }
}

TEST(Assembly, CylinderVolumeOfQuarticsOnTenCells) {
  const Discretisation d(cylinder, {4, {1, 2}});
  EXPECT_EQ(d.mesh.n_active_cells(), 10u);
  EXPECT_NEAR(assemble(d, rubber).mesh_volume, volume(cylinder), 1e-5 * volume(cylinder));
}

TEST(Assembly, QuickCylinderHasTheStatedSize) {
  EXPECT_EQ(Discretisation(cylinder, {4, {1, 4}}).n_dofs(), 4539);
  EXPECT_EQ(Discretisation(cylinder, {4, {2, 4}}).n_dofs(), 17187);
  EXPECT_EQ(Discretisation(cylinder, {3, {2, 4}}).n_dofs(), 7527);
  EXPECT_EQ(Discretisation(cylinder, {1, {1, 2}}).mesh.n_active_cells(), 10u);
}

TEST(Assembly, RigidMotionsCostNoEnergy) {
  for (const Mesh& mesh : meshes) {
    const Discretisation d(mesh.shape, mesh.resolution);
    const Matrices matrices = assemble(d, rubber);
    const Supports free = condense(d, {});
    const MatrixXd R = free_rigid_modes(d, free, matrices.M);
    ASSERT_EQ(R.cols(), 6);
    EXPECT_LT((R.transpose() * (matrices.M * R) - MatrixXd::Identity(6, 6)).cwiseAbs().maxCoeff(), 1e-13);
    const double K_norm = matrices.K.diagonal().maxCoeff();
    // Rounding of K: some hundred entries a row.
    EXPECT_LT((matrices.K * R).cwiseAbs().maxCoeff(), 1e-12 * K_norm * R.cwiseAbs().maxCoeff());
  }
}

TEST(Evaluation, LinearFieldsAreReproducedAtEveryPoint) {
  for (const Mesh& mesh : meshes) {
    const Discretisation d(mesh.shape, mesh.resolution);
    for (const Quadrature& q : {volume_quadrature(mesh.shape), surface_quadrature(mesh.shape)}) {
      const VectorXd u = linear_field(d, gradient), at = displacement_at(d, q.points) * u,
                     strain = strain_at(d, q.points) * u;
      const Matrix3Xd expected = gradient * q.points;
      // Newton's inversion of the mapping stops at about 1e-12 of the cell.
      EXPECT_LT((at - Eigen::Map<const VectorXd>(expected.data(), expected.size())).cwiseAbs().maxCoeff(),
                1e-11 * extent(mesh.shape));
      EXPECT_LT((strain - voigt_strain(gradient).replicate(q.points.cols(), 1)).cwiseAbs().maxCoeff(), 1e-11);
    }
  }
}

TEST(Evaluation, RefusesAPointFarOutside) {
  const Discretisation d(box, {1, {2, 2, 2}});
  EXPECT_THROW(displacement_at(d, Vector3d(1, 1, 1)), std::invalid_argument);
}

// Two layers pulled along z, each held aside: springs in series, sigma = D_zz eps in either.
TEST(Inclusion, OfHalfTheBodyIsASpringInSeries) {
  const double factor = 1e6;
  Material layered{2e4, 0.3, 1100};
  layered.inclusions = {{{0, 0, 0.125}, {0.3, 0.2, 0.25}, factor}};
  const Discretisation d(box, {2, {2, 1, 4}});
  const SparseMatrix K = assemble(d, layered).K;
  const double soft = 1e-3, stiff = soft / factor;  // [-] strains
  VectorXd u(d.n_dofs());
  const Matrix3Xd x = d.node_positions();
  for (Index a = 0; a < d.n_nodes(); ++a) {
    const double z = x(2, a);
    u.segment<3>(3 * a) << 0, 0, z < 0 ? soft * (z + 0.25) : soft * 0.25 + stiff * z;
  }
  const VectorXd f = K * u, pull = patch_load(d, {"z-max", {}}, {0, 0, 1}, 0);
  const double sigma = elasticity_matrix(layered)(2, 2) * soft;
  for (Index a = 0; a < d.n_nodes(); ++a)
    if (x(2, a) > -0.24) {                                                           // below, the support reacts
      EXPECT_NEAR(f[3 * a + 2], sigma * pull[3 * a + 2], 1e-8 * sigma * 0.06) << a;  // 1e6 times a few eps
    }
  EXPECT_EQ(stiffness_factor(layered, {0, 0, 0.1}), factor);
  EXPECT_EQ(stiffness_factor(layered, {0, 0, -0.1}), 1);
}

}  // namespace
}  // namespace mb::fem
