// Modes on deal.II meshes against spectra of the same meshes, found independently (cases/exact/tables).
#include <gtest/gtest.h>

#include <cmath>

#include "mechanics/algebra/dense_eigen.h"
#include "mechanics/algebra/worse_test.h"
#include "mechanics/verified_test.h"
#include "modal/bases/verification_test.h"

namespace mb {
namespace {

using testing::expect_verified;
using testing::levels;
using testing::with_supports;

Modes modes_of(const Scene& scene, int n_elastic) {
  const auto model = full_model(scene, scene.bodies[0], scene.bodies[0].resolution);
  return lowest_modes(model->system(), n_elastic, physical_shift(scene.bodies[0]));
}

TEST(SlipBoxVerification, DiscreteSpectrumOfTrilinearCubes) {
  Scene scene = one_body(Box{{1, 1, 1}}, {1, 0.3, 1}, {1, {4, 4, 4}});
  scene = with_supports(scene, Support::Kind::sliding, face_names(scene.bodies[0].shape));
  const Modes modes = modes_of(scene, 225);
  const auto expected = levels("slipbox_discrete_Q1_cube4.csv", 4, [](const auto&) { return 1; });
  ASSERT_EQ(modes.size(), static_cast<Index>(expected.size()));
  EXPECT_EQ(modes.n_rigid, 0);
  double worst = 0;
  for (Index i = 0; i < modes.size(); ++i) {
    const double omega = expected[static_cast<size_t>(i)];
    EXPECT_NEAR(modes.omega[i], omega, 1e-10 * omega) << i;
    worst = worse(worst, std::abs(modes.omega[i] / omega - 1));
  }
  expect_verified(
      {.quantity = "all 225 frequencies of a box on sliding supports, 4 x 4 x 4 trilinear cells of deal.II, "
                   "relative, the worst",
       .reference = "exact solution",
       .source = "of the discrete problem, by its symbol: slipbox_discrete_Q1_cube4.csv",
       .uncertainty = "5e-14, rounding",
       .tolerance = 1e-10,
       .why = "Eigenvalues spread by 41, so that a dense solver rounds by some 1e-14; the rest is room. "
              "Another quadrature or mass matrix would be off by per cents."},
      worst);
}

// Rows of free_fem_discrete.csv: a body (cubes before boards), degree, cells along x, y, z, degrees of freedom, the
// rounding of rigid modes, twenty omega l/c_t with ten digits. Every row is compared, 81 to 30,555 degrees of freedom.
void expect_same_spectra(const std::string& body, const Vector3d& size, const Material& material, size_t first,
                         size_t n_rows) {
  const auto table = numbers("free_fem_discrete.csv");
  ASSERT_EQ(table.size(), 13u);
  double worst = 0;
  for (size_t k = first; k < first + n_rows; ++k) {
    const auto& row = table[k];
    const std::vector<int> cells{static_cast<int>(row[2]), static_cast<int>(row[3]), static_cast<int>(row[4])};
    const Modes modes = modes_of(one_body(Box{size}, material, {static_cast<int>(row[1]), cells}), 20);
    ASSERT_EQ(modes.Phi.rows(), static_cast<Index>(row[5]));
    ASSERT_EQ(modes.n_rigid, 6);
    ASSERT_GE(modes.size(), 26);
    for (Index i = 0; i < 20; ++i) {
      const double omega = modes.omega[6 + i] * size[2] / shear_wave_speed(material);
      const double expected = row[static_cast<size_t>(7 + i)];
      EXPECT_NEAR(omega, expected, 1e-8 * expected)
          << "degree " << row[1] << ", " << cells[2] << " cells along z, mode " << i + 1;
      worst = worse(worst, std::abs(omega / expected - 1));
    }
  }
  expect_verified(
      {.quantity = fmt::format("20 elastic frequencies of a free {} on each of {} meshes of degrees 1 and 2, "
                               "relative, the worst",
                               body, n_rows),
       .reference = "table",
       .source = "another finite element program on the same meshes: free_fem_discrete.csv",
       .uncertainty = "8e-10, nine printed decimals of 0.65 and more",
       .tolerance = 1e-8,
       .why = "Elements and meshes are the same: only the table's digits and the eigensolver's residual "
              "are left, for which this has ten times the digits."},
      worst);
}
TEST(FreeCubeVerification, SameMesh) { expect_same_spectra("cube", {0.2, 0.2, 0.2}, {7e10, 0.3, 2700}, 0, 8); }
TEST(FreeBoardVerification, SameMesh) { expect_same_spectra("board", {0.15, 0.35, 2.4}, {4e9, 0.35, 1200}, 8, 5); }

// Nodes at equal distances along the four edges of the face z = -1/2.
Matrix3Xd bottom_edge_nodes(const Vector3d& size, int n_x, int n_y) {
  std::vector<Vector3d> nodes;
  for (int i = 0; i <= n_x; ++i)
    for (int j = 0; j <= n_y; ++j)
      if (i == 0 || i == n_x || j == 0 || j == n_y)
        nodes.push_back(size.cwiseProduct(Vector3d(double(i) / n_x - 0.5, double(j) / n_y - 0.5, -0.5)));
  Matrix3Xd x(3, static_cast<Index>(nodes.size()));
  for (size_t i = 0; i < nodes.size(); ++i) x.col(static_cast<Index>(i)) = nodes[i];
  return x;
}

// The system without the degrees of freedom that move the points along z; each point is a node.
System held_along_z(const FullModel& model, const Matrix3Xd& points) {
  const System& free = model.system();
  const MatrixXd at_points = model.displacement_at(points);
  std::vector<bool> held(static_cast<size_t>(free.M.rows()), false);
  for (Index p = 0; p < points.cols(); ++p) {
    Index dof = 0;
    EXPECT_NEAR(at_points.row(3 * p + 2).cwiseAbs().maxCoeff(&dof), 1, 1e-10) << "no node there";
    held[static_cast<size_t>(dof)] = true;
  }
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<Index> kept, removed;
  for (Index i = 0; i < free.M.rows(); ++i) {
    if (!held[static_cast<size_t>(i)]) entries.emplace_back(i, static_cast<Index>(kept.size()), 1.0);
    (held[static_cast<size_t>(i)] ? removed : kept).push_back(i);
  }
  SparseMatrix T(free.M.rows(), static_cast<Index>(kept.size()));
  T.setFromTriplets(entries.begin(), entries.end());
  System system;
  system.M = T.transpose() * free.M * T;
  system.K = T.transpose() * free.K * T;
  const auto [U, sigma, V] = thin_svd(free.R(removed, Eigen::all));
  const Index n_rigid = (sigma.array() < 1e-10 * sigma(0)).count();
  const MatrixXd R = free.R(kept, Eigen::all) * V.rightCols(n_rigid);
  const Eigen::LLT<MatrixXd> gram(R.transpose() * (system.M * R));
  system.R = gram.matrixU().solve<Eigen::OnTheRight>(R);
  return system;
}

// NAFEMS FV52: u_z = 0 at the nodes of the four bottom edges. A line support has no limit in three dimensions: same
// mesh only. Frequencies 4 to 11 in Hz, ten digits.
TEST(Fv52Verification, SameMesh) {
  const Vector3d size(10, 10, 1);
  const Material steel{2e11, 0.3, 8000};
  int n_meshes = 0;
  double worst = 0;
  for (const auto& row : numbers("fv52_discrete_fem.csv")) {
    const int degree = static_cast<int>(row[0]);
    const std::vector<int> cells{static_cast<int>(row[1]), static_cast<int>(row[2]), static_cast<int>(row[3])};
    if (cells[0] * degree > 16) continue;  // the finer ones test nothing more
    const Scene scene = one_body(Box{size}, steel, {degree, cells});
    const auto model = full_model(scene, scene.bodies[0], scene.bodies[0].resolution);
    const System plate = held_along_z(*model, bottom_edge_nodes(size, degree * cells[0], degree * cells[1]));
    const Modes modes = lowest_modes(plate, 8, physical_shift(scene.bodies[0]));
    ASSERT_EQ(modes.n_rigid, 3);
    for (Index i = 0; i < 8; ++i) {
      const double expected = row[static_cast<size_t>(4 + i)], hertz = modes.omega[3 + i] / (2 * pi);
      EXPECT_NEAR(hertz, expected, 1e-8 * expected) << degree << " " << cells[0] << " " << i;
      worst = worse(worst, std::abs(hertz / expected - 1));
    }
    ++n_meshes;
  }
  EXPECT_EQ(n_meshes, 4);
  expect_verified(
      {.quantity = "frequencies 4 to 11 of the NAFEMS FV52 plate, held along the nodes of its bottom edges, "
                   "on 4 meshes, relative, the worst",
       .reference = "table",
       .source = "another finite element program on the same meshes: fv52_discrete_fem.csv",
       .uncertainty = "1.2e-9, seven printed decimals of 43 Hz and more",
       .tolerance = 1e-8,
       .why = "Elements, meshes and held nodes are the same: only the table's digits and the eigensolver's "
              "residual are left, for which this has eight times the digits."},
      worst);
}

}  // namespace
}  // namespace mb
