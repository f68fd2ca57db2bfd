// Orders in the mesh of the dynamic reference, at steps far finer: of elements of degree p displacements converge by
// h^(p + 1) in the L2 norm and strains by h^p, on bricks and on any cells that are not flattened as they become
// smaller: a polynomial of degree p in x is one of degree p along each axis of a trilinear cell (Arnold, Boffi & Falk
// 2002, Math. Comp. 71, for quadrilaterals).
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "mechanics/system/newmark.h"
#include "mechanics/verified_test.h"
#include "reference/fem/manufactured_motion_test.h"
#include "reference/sundials/sundials.h"

namespace mb {
namespace {

using testing::ManufacturedMotion;

// Displacement of the mesh at the end, by one of two routes in time.
using Answer = std::function<VectorXd(const System&)>;
Answer adaptive(double rtol) {
  return [=](const System& system) { return testing::at_the_end(*sundials(system, rtol, testing::manufactured_end)); };
}
// By average acceleration, whose error is even in the step: of order 4, 1e-6 of the displacement in 200 and 400 steps.
VectorXd extrapolated(const System& system) {
  const auto by = [&](int n) { return testing::at_the_end(*newmark(system, testing::manufactured_end / n)); };
  return (4 * by(400) - by(200)) / 3;
}

struct Orders {
  double displacement, strain;
};

// Slope of least squares in logarithms over meshes of n x n x 2n cells of a box, whose cells all waves of the field
// cross alike, or of n cells across each block of a cylinder's section and 2n along it.
Orders fitted(Resolution mesh, const std::vector<int>& counts, const Answer& answer,
              const Shape& shape = Box{testing::manufactured_size}) {
  MatrixXd log_h(counts.size(), 2), log_e(counts.size(), 2);
  for (size_t i = 0; i < counts.size(); ++i) {
    mesh.cells.assign(std::holds_alternative<Box>(shape) ? 2 : 1, counts[i]);
    mesh.cells.push_back(2 * counts[i]);
    const ManufacturedMotion motion(mesh, shape);
    const auto [displacement, strain] = motion.errors(answer(motion.system()), testing::manufactured_end);
    EXPECT_LT(displacement, 0.1) << to_string(mesh);
    log_h.row(static_cast<Index>(i)) << 1, -std::log(counts[i]);
    log_e.row(static_cast<Index>(i)) << std::log(displacement), std::log(strain);
  }
  const MatrixXd fit = log_h.colPivHouseholderQr().solve(log_e);
  return {fit(1, 0), fit(1, 1)};
}

// From either side: an order above theory's is that of another error, of a rule that is off or of waves which fall on
// the cells of one mesh alike.
double largest_distance(const Orders& found, int p) {
  return VectorXd{{found.displacement - (p + 1), found.strain - p}}.cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
}

struct Series {
  int degree;
  std::vector<int> counts;
  double rtol;  // of the steps: a hundredth of the error of the finest mesh at most
};

class ManufacturedOrdersVerification : public ::testing::TestWithParam<Series> {};
INSTANTIATE_TEST_SUITE_P(Degrees, ManufacturedOrdersVerification,
                         ::testing::Values(Series{1, {4, 6, 8}, 1e-6}, Series{2, {2, 3, 4}, 1e-7},
                                           Series{3, {2, 3, 4}, 1e-8}, Series{4, {2, 3}, 1e-8}),
                         [](const auto& each) { return std::to_string(each.param.degree); });

TEST_P(ManufacturedOrdersVerification, OfBricks) {
  const auto& [p, counts, rtol] = GetParam();
  const Orders found = fitted({p, {}}, counts, adaptive(rtol));
  testing::expect_verified(
      {.quantity = fmt::format("distance of the orders in the mesh from {} of displacement and {} of strain, absolute: "
                               "elements of degree {}, {} meshes, a linear box in motion, L2 norm",
                               p + 1, p, p, counts.size()),
       .reference = "manufactured solution",
       .source = "a field of sines times a sine of time, its body force in closed form",
       .uncertainty = fmt::format("{:.0e} of the displacement, the tolerance of the steps in time", rtol),
       .tolerance = 0.2,
       .why = "On two to eight cells half a wave the error's next term is left, on either side. Orders above theory's "
              "are refused as those below: they would be another error's."},
      largest_distance(found, p));
}

// Corners moved by up to a quarter of their edges, edges in progressions of 1 to 3, 2 and 1/2: another draw on each
// mesh, whose constants differ.
TEST(ManufacturedVerification, KeepsItsOrdersOnDistortedAndBiasedCells) {
  double worst = 0;
  for (const int p : {1, 2}) {
    Resolution mesh{p, {}};
    mesh.distorted = 0.25;
    mesh.bias = {3, 2, 0.5};
    worst =
        VectorXd{{worst, largest_distance(fitted(mesh, {4, 6, 8}, adaptive(1e-6)), p)}}.maxCoeff<Eigen::PropagateNaN>();
  }
  testing::expect_verified(
      {.quantity = "distance of the orders in the mesh from p + 1 of displacement and p of strain, absolute: elements "
                   "of degree p = 1, 2 on distorted and biased cells, 3 meshes each, a linear box in motion, L2 norm",
       .reference = "manufactured solution",
       .source = "a field of sines times a sine of time; orders on such cells after Arnold, Boffi and Falk 2002, "
                 "Math. Comp. 71",
       .uncertainty = "1e-6 of the displacement, the tolerance of the steps in time",
       .tolerance = 0.2,
       .why = "Corners are drawn anew for each mesh, which scatters its error by some per cents, and orders over a "
              "factor of 2 in the mesh by a tenth."},
      worst);
}

// Cells are mapped by polynomials of the elements' own degree: curved by degree 2, on chords by degree 1. The blocks of
// a section split by halves alone, and where they are not split at all, waves of the field are not resolved: between
// meshes n and 2n.
TEST(ManufacturedVerification, KeepsItsOrdersOnCurvedCells) {
  const Cylinder round{0.11, 0.4};  // [m]
  const ManufacturedMotion coarsest({2, {2, 4}}, round);
  const VectorXd by_adaptive = adaptive(1e-8)(coarsest.system());
  EXPECT_LT((extrapolated(coarsest.system()) - by_adaptive).norm(), 1e-6 * by_adaptive.norm());
  double worst = 0;
  for (const auto& [p, counts] : {std::pair(1, std::vector{4, 8}), std::pair(2, std::vector{2, 4})})
    worst = VectorXd{{worst, largest_distance(fitted({p, {}}, counts, extrapolated, round), p)}}
                .maxCoeff<Eigen::PropagateNaN>();
  testing::expect_verified(
      {.quantity =
           "distance of the orders in the mesh from p + 1 of displacement and p of strain, absolute: elements "
           "of degree p = 1 on chords and 2 on curved cells, 2 meshes each, a free linear cylinder in motion, L2 norm",
       .reference = "manufactured solution",
       .source = "a field of sines times a sine of time, its tractions on the surface by parts",
       .uncertainty = "1e-6 of the displacement, by average acceleration extrapolated from 200 and 400 steps",
       .tolerance = 0.2,
       .why = "As of bricks: on two to sixteen cells half a wave the error's next term is left, on either side."},
      worst);
}

}  // namespace
}  // namespace mb
