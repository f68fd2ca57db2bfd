#include "reference/fem/grading.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <gtest/gtest.h>

#include "cases/scene/resolution.h"
#include "mechanics/algebra/noise.h"
#include "mechanics/algebra/worse_test.h"
#include "reference/fem/assembly.h"
#include "reference/fem/evaluation.h"
#include "reference/fem/supports.h"

namespace mb::fem {
namespace {

const Material rubber{2e4, 0.45, 1100};
const Shape box = Box{{0.3, 0.2, 0.5}}, cylinder = Cylinder{0.05, 0.2}, sphere = Sphere{0.07};
const Vector3d pole(0, 0, -0.07), oblique = 0.07 * Vector3d(0.3, 0.5, -0.8).normalized(), rim(0.03, 0.04, 0.1);

struct Graded {
  Shape shape;
  Resolution resolution;
  Vector3d focus;
};
// Where a touch may be: the middle of a block's face, a point of no symmetry, a corner, a face, a rim, a side.
const std::vector<Graded> meshes = {{box, {1, {3, 2, 4}, 3}, {0.15, 0.1, -0.25}},
                                    {box, {2, {1, 1, 2}, 2}, {0.03, 0.02, -0.25}},
                                    {box, {3, {1, 1, 3}, 1}, {0.15, 0, 0.25}},
                                    {box, {4, {2, 1, 2}, 1}, {0.15, 0.1, 0.25}},
                                    {sphere, {1, {2}, 3}, pole},
                                    {sphere, {2, {1}, 3}, pole},
                                    {sphere, {2, {2}, 2}, oblique},
                                    {cylinder, {1, {1, 2}, 3}, rim},
                                    {cylinder, {2, {1, 4}, 2}, rim},
                                    {cylinder, {2, {2, 2}, 1}, {0.05, 0, 0.03}},
                                    {cylinder, {1, {0, 2}, 2}, {0.05, 0, 0}}};
// Beyond degree 2 the quadrature of curved cells is not exact (assembly_test.cc).
const std::vector<Graded> meshes_of_high_degree = {
    {sphere, {3, {1}, 2}, oblique}, {sphere, {4, {1}, 1}, pole}, {cylinder, {3, {1, 2}, 2}, rim}};

std::string name(const Graded& m) { return to_string(m.resolution) + " of shape " + std::to_string(m.shape.index()); }

std::vector<Graded> all_meshes() {
  std::vector<Graded> all = meshes;
  all.insert(all.end(), meshes_of_high_degree.begin(), meshes_of_high_degree.end());
  return all;
}

double distance(const dealii::Point<3>& p, const Vector3d& x) { return (Vector3d(p[0], p[1], p[2]) - x).norm(); }

// The level that the base mesh's cells have, their grading not counted.
int base_level(const Graded& m) {
  return Discretisation(m.shape, {m.resolution.degree, m.resolution.cells}).mesh.n_global_levels() - 1;
}

TEST(Grading, HalvesWhatLiesNearAndOnlyThat) {
  for (const Graded& m : all_meshes()) {
    const Discretisation d(m.shape, m.resolution, {m.focus});
    const int finest = base_level(m) + m.resolution.graded;
    std::vector<int> count(static_cast<size_t>(finest) + 1);
    for (const auto& cell : d.mesh.active_cell_iterators()) {
      ASSERT_LE(cell->level(), finest);
      ++count[static_cast<size_t>(cell->level())];
      if (cell->level() == finest) continue;
      EXPECT_GT(distance(cell->center(), m.focus), grading_reach * cell->diameter()) << name(m);
    }
    // A level deep down: 7/8 of the children of the 14 to 21 that were halved, and of the rest of their neighbours.
    for (int level = base_level(m) + 2; level < finest; ++level) {
      EXPECT_GE(count[static_cast<size_t>(level)], 24) << name(m) << " level " << level;
      EXPECT_LE(count[static_cast<size_t>(level)], 160) << name(m) << " level " << level;
    }
    EXPECT_GT(d.hanging.n_constraints(), 0u) << name(m);
  }
}

// All around the pole, which is a corner of four cells there, cells are of the same size, about R/2^(splits + levels),
// and well shaped.
TEST(Grading, SurroundsThePoleOfABall) {
  const Discretisation d(sphere, {2, {2}, 4}, {pole});
  int touching = 0;
  for (const auto& cell : d.mesh.active_cell_iterators()) {
    double nearest = 1;
    for (const unsigned v : cell->vertex_indices()) nearest = std::min(nearest, distance(cell->vertex(v), pole));
    const double longest = cell->diameter() / std::sqrt(3.0), shortest = cell->minimum_vertex_distance();
    if (nearest < 1e-12) {
      ++touching;
      EXPECT_EQ(cell->level(), 5);
    }
    if (nearest > 0.01) continue;
    EXPECT_LT(longest, 2 * shortest);
    if (cell->level() < 5) continue;
    EXPECT_NEAR(shortest, 0.07 / 32, 0.25 * 0.07 / 32);
  }
  EXPECT_EQ(touching, 4);
}

TEST(Grading, TowardsTwoPointsAndBackToNone) {
  const Discretisation one(sphere, {1, {2}, 3}, {pole}), two(sphere, {1, {2}, 3}, {pole, -pole});
  const Discretisation none(sphere, {1, {2}}, {pole}), even(sphere, {1, {2}});
  const auto added = [&](const Discretisation& d) { return d.mesh.n_active_cells() - even.mesh.n_active_cells(); };
  EXPECT_EQ(added(none), 0u);
  EXPECT_EQ(added(two), 2 * added(one));
  EXPECT_EQ(none.node_positions(), even.node_positions());
}

// Both sides of a face between a cell and halved ones: the same points, and the same values of any u = T q.
TEST(Grading, LeavesNoGaps) {
  for (const Graded& m : all_meshes()) {
    const Discretisation d(m.shape, m.resolution, {m.focus});
    const Supports free = condense(d, {});
    const VectorXd u = free.T * uniform_noise(free.T.cols(), 1);
    dealii::Vector<double> ux(d.nodes.n_dofs());
    for (Index a = 0; a < d.n_nodes(); ++a) ux[static_cast<unsigned>(a)] = u[3 * a];
    const dealii::QGauss<2> rule(3);
    const auto flags = dealii::update_values | dealii::update_quadrature_points;
    dealii::FESubfaceValues<3> coarse(d.mapping, d.element, rule, flags);
    dealii::FEFaceValues<3> fine(d.mapping, d.element, rule, flags);
    std::vector<double> from_coarse(rule.size()), from_fine(rule.size());
    int n_faces = 0;
    for (const auto& cell : d.nodes.active_cell_iterators())
      for (const unsigned f : cell->face_indices()) {
        if (cell->at_boundary(f) || !cell->face(f)->has_children()) continue;
        for (unsigned s = 0; s < cell->face(f)->n_children(); ++s, ++n_faces) {
          coarse.reinit(cell, f, s);
          fine.reinit(cell->neighbor_child_on_subface(f, s), cell->neighbor_of_neighbor(f));
          coarse.get_function_values(ux, from_coarse);
          fine.get_function_values(ux, from_fine);
          for (unsigned q = 0; q < rule.size(); ++q) {
            EXPECT_LT(coarse.quadrature_point(q).distance(fine.quadrature_point(q)), 1e-14) << name(m);
            EXPECT_NEAR(from_coarse[q], from_fine[q], 1e-12 * u.cwiseAbs().maxCoeff()) << name(m);
          }
        }
      }
    EXPECT_GT(n_faces, 0) << name(m);
  }
}

// Nodes that do not hang lie on the exact surface where they lie on the boundary; hanging ones where the coarser cell's
// face is, which for even degrees is on it at the middle of that face.
TEST(Grading, PlacesNodesOnTheExactSurface) {
  for (const Resolution& resolution : {Resolution{1, {1}, 3}, Resolution{2, {1}, 3}, Resolution{3, {2}, 2}}) {
    const Discretisation d(sphere, resolution, {oblique});
    const Matrix3Xd x = d.node_positions();
    std::vector<dealii::types::global_dof_index> ids(d.element.n_dofs_per_face());
    double free = 0, hanging = 0;
    for (const auto& cell : d.nodes.active_cell_iterators())
      for (const auto& face : cell->face_iterators()) {
        if (!face->at_boundary()) continue;
        face->get_dof_indices(ids);
        for (const auto a : ids) {
          double& worst = d.hanging.is_constrained(a) ? hanging : free;
          worst = worse(worst, std::abs(x.col(static_cast<Index>(a)).norm() / 0.07 - 1));
        }
      }
    EXPECT_LT(free, 1e-14) << to_string(resolution);
    // Of the base's cells, h = 1.2 R / splits: 1 - cos(h/2R), and what degree 2 and 3 leave of it.
    EXPECT_GT(hanging, 1e-9) << to_string(resolution);
    EXPECT_LT(hanging, resolution.degree == 1 ? 0.2 : resolution.degree == 2 ? 0.02 : 1e-3) << to_string(resolution);
  }
}

TEST(Grading, InheritsTheNamesOfFaces) {
  const Discretisation d(cylinder, {2, {1, 2}, 3}, {rim});
  const VectorXd top = patch_normal(d, {"z-max", {}}), bottom = patch_normal(d, {"z-min", {}});
  EXPECT_NEAR(top(Eigen::seq(2, Eigen::last, 3)).sum(), pi * 0.05 * 0.05, 6e-3 * pi * 0.05 * 0.05);
  EXPECT_NEAR(bottom(Eigen::seq(2, Eigen::last, 3)).sum(), -pi * 0.05 * 0.05, 2e-2 * pi * 0.05 * 0.05);
  for (const auto& quad : d.mesh.active_face_iterators()) {
    if (!quad->at_boundary() || d.faces[quad->boundary_id()] != "z-max") continue;
    for (unsigned v = 0; v < 4; ++v) EXPECT_NEAR(quad->vertex(v)[2], 0.1, 1e-15);
  }
}

// Constant stress balances its tractions, after hanging nodes have handed on theirs: no gaps, no wrong weights.
TEST(GradedPatchTest, LinearDisplacementBalancesConstantStress) {
  const Eigen::Matrix3d G = (Eigen::Matrix3d() << 1e-2, 3e-3, -2e-3, 5e-3, -4e-3, 1e-3, 7e-3, -6e-3, 8e-3).finished();
  const double lame = 2e4 * 0.45 / (1.45 * 0.1), mu = 2e4 / 2.9;
  const Eigen::Matrix3d sigma = lame * G.trace() * Eigen::Matrix3d::Identity() + mu * (G + G.transpose());
  const auto error = [&](const Graded& m) {
    const Discretisation d(m.shape, m.resolution, {m.focus});
    const Supports free = condense(d, {});
    const VectorXd u = (G * d.node_positions()).reshaped();
    EXPECT_LT((free.T * u(free.kept) - u).cwiseAbs().maxCoeff(), 1e-14 * u.cwiseAbs().maxCoeff()) << name(m);
    VectorXd f = VectorXd::Zero(d.n_dofs());
    for (const auto& face : d.faces) {
      const VectorXd normal = patch_normal(d, {face, {}});
      f += (sigma * normal.reshaped(3, d.n_nodes())).reshaped();
    }
    const VectorXd residual = free.T.transpose() * (assemble(d, rubber).K * u - f);
    return residual.norm() / (free.T.transpose() * f).norm();
  };
  for (const Graded& m : meshes) EXPECT_LT(error(m), 2e-13) << name(m);
  for (const Graded& m : meshes_of_high_degree) EXPECT_LT(error(m), 2e-3) << name(m);
}

TEST(GradedAssembly, KeepsMassAndRigidMotions) {
  for (const Graded& m : all_meshes()) {
    const Discretisation d(m.shape, m.resolution, {m.focus});
    const Supports free = condense(d, {});
    const Matrices full = assemble(d, rubber);
    const SparseMatrix M = free.T.transpose() * full.M * free.T, K = free.T.transpose() * full.K * free.T;
    const SparseMatrix lumped = free.T.transpose() * lumped_mass(d, rubber.density).asDiagonal() * free.T;
    const double mass = rubber.density * full.mesh_volume;
    // Lobatto's rule on balls: the coarsest Q1 blocks miss 0.13 of the mass (assembly.h).
    const double quadrature = std::holds_alternative<Sphere>(m.shape) ? (m.resolution.degree == 1 ? 0.06 : 1e-3) : 1e-9;
    for (const Vector3d& axis : {Vector3d::UnitX().eval(), Vector3d::UnitZ().eval()}) {
      const VectorXd r = translation(d, axis)(free.kept);
      EXPECT_NEAR(r.dot(M * r), mass, 1e-12 * mass) << name(m);
      EXPECT_NEAR(r.dot(lumped * r), mass, quadrature * mass) << name(m);
    }
    const MatrixXd R = free_rigid_modes(d, free, M);
    ASSERT_EQ(R.cols(), 6) << name(m);
    EXPECT_LT((R.transpose() * (M * R) - MatrixXd::Identity(6, 6)).cwiseAbs().maxCoeff(), 1e-13) << name(m);
    EXPECT_LT((K * R).cwiseAbs().maxCoeff(), 1e-12 * K.diagonal().maxCoeff() * R.cwiseAbs().maxCoeff()) << name(m);
  }
}

// On straight cells a quadratic displacement is in the space from degree 2 on: its energy and strains are those of the
// one cell's, exactly.
TEST(GradedAssembly, HoldsQuadraticFieldsExactly) {
  const auto quadratic = [](const Matrix3Xd& x) {
    Matrix3Xd u(3, x.cols());
    const auto X = x.row(0).array(), Y = x.row(1).array(), Z = x.row(2).array();
    u << X * X - 2 * Y * Z + X, 3 * X * Y + Z * Z - 1, Y * Y - X * Z + Z;
    return u;
  };
  const auto energy = [&](const Discretisation& d) {
    const VectorXd u = quadratic(d.node_positions()).reshaped();
    return u.dot(assemble(d, rubber).K * u);
  };
  const double expected = energy(Discretisation(box, {2, {1, 1, 1}}));
  for (int degree = 2; degree <= 4; ++degree) {
    const Discretisation d(box, {degree, {2, 1, 1}, 2}, {{0.15, 0.03, -0.25}});
    const Supports free = condense(d, {});
    const VectorXd u = quadratic(d.node_positions()).reshaped();
    EXPECT_LT((free.T * u(free.kept) - u).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_NEAR(energy(d), expected, 1e-12 * expected);
    const Matrix3Xd x = volume_quadrature(box).points;
    EXPECT_LT((displacement_at(d, x) * u - quadratic(x).reshaped()).cwiseAbs().maxCoeff(), 1e-11);
  }
}

// Any continuous field is what its nodes say, at and next to these: corners, edges and faces that cells share, and
// those of the surface, a little within it and outside. Seen from a cell that is not there it would be something else.
TEST(Grading, FieldsAreSeenFromACellThatIsThere) {
  for (const Graded& m : {Graded{box, {2, {1, 1, 2}, 2}, {0.03, 0.02, -0.25}}, Graded{sphere, {2, {1}, 2}, pole},
                          Graded{cylinder, {1, {1, 2}, 3}, rim}}) {
    const Discretisation d(m.shape, m.resolution, {m.focus});
    const Supports free = condense(d, {});
    const VectorXd u = free.T * VectorXd::Random(free.T.cols());
    for (const double away : {0.0, -1e-6, 1e-6}) {
      const VectorXd seen = displacement_at(d, (1 + away) * d.node_positions()) * u;
      EXPECT_LT((seen - u).cwiseAbs().maxCoeff(), 1e-9 + 1e4 * std::abs(away)) << name(m) << " " << away;
    }
  }
}

TEST(Grading, RefusesWhatItCannotGrade) {
  const auto mesh = [](const Shape& shape, const Resolution& resolution, const std::vector<Vector3d>& foci) {
    return Discretisation(shape, resolution, foci).n_dofs();
  };
  EXPECT_NO_THROW(mesh(sphere, {1, {1}, 1}, {pole}));
  EXPECT_THROW(mesh(sphere, {1, {1}, 1}, {}), std::invalid_argument);
  EXPECT_THROW(mesh(sphere, {1, {1}, -1}, {pole}), std::invalid_argument);
  EXPECT_THROW(mesh(sphere, {1, {1}, 13}, {pole}), std::invalid_argument);
  EXPECT_THROW(mesh(sphere, {1, {1}, 1}, {pole, 1.001 * pole}), std::invalid_argument);
  EXPECT_THROW(mesh(sphere, {1, {1}, 1}, {{0, std::nan(""), 0}}), std::invalid_argument);
  // Flat cells: within 1.1 of their diameters lie all.
  EXPECT_THROW(mesh(Box{{1, 1, 1}}, {4, {1024, 1, 1}, 3}, {{0.5, 0, 0}}), std::invalid_argument);
  // In the corners of one block the circle leaves no angle.
  const Vector3d corner(0.05 * std::sqrt(0.5), 0.05 * std::sqrt(0.5), 0.1);
  EXPECT_THROW(mesh(cylinder, {4, {0, 2}, 3}, {corner}), std::invalid_argument);
}

}  // namespace
}  // namespace mb::fem
