// A rod (nu = 0) under a step load against d'Alembert's waves, u = F/(E A) times triangles of the length L and the time
// L/c (cases/exact/tables/rod_step_load.csv; Graff 1975, Wave Motion in Elastic Solids, sect. 2.3).
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "mechanics/system/central_difference.h"
#include "mechanics/system/newmark.h"
#include "mechanics/verified_test.h"
#include "reference/static_answer.h"
#include "reference/sundials/sundials.h"

namespace mb {
namespace {

using testing::expect_verified;
using testing::face;
using testing::support;
using K = Support::Kind;

const Box rod{{0.3, 0.2, 2.5}};
const Material resin{3.6e9, 0, 1000};
const double c = std::sqrt(3.6e9 / 1000), transit = 2.5 / c;  // [m/s], [s]
const double stress = 7e4, stretch = stress * 2.5 / 3.6e9;    // [Pa], [m] what the static load would do to a held rod

// Rows: t c/L, then displacements over the stretch: of the held rod at its loaded end and middle, of the free rod at
// its loaded end and at the other.
MatrixXd table() {
  std::ifstream file(std::string(MB_SOURCE_DIR) + "/cases/exact/tables/rod_step_load.csv");
  std::vector<double> values;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || !(std::isdigit(static_cast<unsigned char>(line[0])))) continue;
    std::istringstream fields(line);
    std::vector<double> row;
    for (std::string field; std::getline(fields, field, ',');) row.push_back(std::stod(field));
    for (const size_t column : {0u, 1u, 2u, 5u, 6u}) values.push_back(row.at(column));
  }
  return Eigen::Map<const MatrixXd>(values.data(), 5, static_cast<Index>(values.size()) / 5);
}

// Linear elements along the rod, its sides in frictionless channels. Pulled at z-max where held, else pushed at z-min.
Scene loaded_rod(int n_elements, bool held) {
  Scene scene = one_body(rod, resin, {1, {1, 1, n_elements}});
  auto& supports = scene.bodies[0].supports;
  for (const char* side : {"x-min", "x-max", "y-min", "y-max"}) supports.push_back(support(K::sliding, face(side)));
  if (held) supports.push_back(support(K::fixed, face("z-min")));
  testing::load(scene, held ? "z-max" : "z-min", {0, 0, stress});
  return scene;
}

// Displacements along z over the stretch, at the points of the table: 2 x n_t.
MatrixXd observed(const FullModel& model, bool held, const MatrixXd& u) {
  Matrix3Xd points = Matrix3Xd::Zero(3, 2);
  points.row(2) << (held ? 1.25 : -1.25), (held ? 0 : 1.25);
  const MatrixXd at = model.displacement_at(points) * u;
  return (MatrixXd(2, u.cols()) << at.row(2), at.row(5)).finished() / stretch;
}
MatrixXd expected(const MatrixXd& rows, bool held) { return held ? rows.middleRows(1, 2) : rows.middleRows(3, 2); }

// With the lumped mass and h = (element length)/c the difference equation is d'Alembert's: exact at the nodes. Left:
// the table's last digit (its middle column is a series, good to 1e-6) and rounding, which the highest mode, at its
// limit of stability, lets grow in proportion to the steps.
TEST(RodVerification, LumpedMassAtCourantNumberOneIsExactAtTheNodes) {
  const MatrixXd rows = table();
  ASSERT_EQ(rows.cols(), 81);
  Eigen::Vector2d at_load;
  for (const bool held : {true, false}) {
    const Scene scene = loaded_rod(40, held);
    const auto model = full_model(scene, scene.bodies[0], scene.bodies[0].resolution);
    const MatrixXd u = central_difference(model->system(), transit / 40)->run(transit * rows.row(0).transpose()).u;
    const MatrixXd error = observed(*model, held, u) - expected(rows, held);
    at_load[held] = error.row(0).cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
    EXPECT_LT(error.row(1).cwiseAbs().maxCoeff<Eigen::PropagateNaN>(), held ? 1e-6 : 1e-10) << held;
  }
  expect_verified({.quantity = "displacement of the loaded end of a rod, held and free, after a step of load, over the "
                               "static stretch: lumped mass, central differences, Courant number 1",
                   .reference = "exact solution",
                   .source = "d'Alembert's waves (Graff 1975, sect. 2.3), rod_step_load.csv",
                   .uncertainty = "none: at these times they are tenths, which ten digits hold",
                   .tolerance = 1e-10,
                   .why = "Exact at the nodes; rounding of the highest mode, at its limit of stability, grows with the "
                          "steps."},
                  at_load.maxCoeff<Eigen::PropagateNaN>());
}

// A base that jumps to the acceleration a: the top swings between 0 and twice the static shortening rho a L^2/(2 E),
// with period 4 L/c; at Courant number one exactly.
TEST(RodVerification, AStepOfTheBaseShortensTwiceAsMuchAsAtRest) {
  const double a = 12;
  Scene scene = loaded_rod(40, false);
  scene.loads.clear();
  scene.bodies[0].supports.push_back({K::driven, face("z-min"), Drive{Vector3d::UnitZ(), Step{}}});
  const auto model = full_model(scene, scene.bodies[0], scene.bodies[0].resolution);
  const VectorXd t = transit / 10 * VectorXd::LinSpaced(81, 0, 80);
  const MatrixXd u = a * central_difference(model->system(), transit / 40)->run(t).u;
  const VectorXd top = (model->displacement_at(Vector3d(0, 0, 1.25)) * u).row(2);
  const double at_rest = -1000 * a * 2.5 * 2.5 / (2 * 3.6e9);
  EXPECT_NEAR(top[10] / at_rest, 1, 1e-9);  // t = L/c
  EXPECT_NEAR(top[20] / at_rest, 2, 1e-9);
  EXPECT_NEAR(top[40] / at_rest, 0, 1e-9);
  EXPECT_NEAR(top[60] / at_rest, 2, 1e-9);
  EXPECT_NEAR(top.minCoeff() / at_rest, 2, 1e-9);
}

double worst(const Scene& scene, bool held, const MatrixXd& rows, const std::function<States(const System&)>& run) {
  const auto model = full_model(scene, scene.bodies[0], scene.bodies[0].resolution);
  const States states = run(model->system());
  EXPECT_EQ(states.n_valid, rows.cols());
  return (observed(*model, held, states.u) - expected(rows, held)).cwiseAbs().maxCoeff();
}

void expect_waves(const std::string& quantity, double tolerance, const std::string& why, double error) {
  expect_verified({.quantity = quantity,
                   .reference = "exact solution",
                   .source = "d'Alembert's waves (Graff 1975, sect. 2.3), rod_step_load.csv",
                   .uncertainty = "5.1e-7: a truncated series at the corners of the held rod's middle",
                   .tolerance = tolerance,
                   .why = why},
                  error);
}

// With the consistent mass short waves run ahead and a kink of u spreads over (time c/L)^(1/3) n^(-2/3) of the rod: the
// error there falls by 1.59 when n elements halve in size. Seen: 0.036 and 0.023 of the static stretch.
TEST(RodVerification, ConsistentMassConvergesToTheWaves) {
  const MatrixXd rows = table();
  const VectorXd t = transit * rows.row(0).transpose();
  Eigen::Vector2d left, factor;
  for (const bool held : {true, false}) {
    std::vector<double> errors;
    for (const int n : {50, 100}) {
      const auto steps = [&](const System& s) { return newmark(s, transit / (4 * n))->run(t); };
      errors.push_back(worst(loaded_rod(n, held), held, rows, steps));
    }
    left[held] = errors[1], factor[held] = errors[0] / errors[1];
    const auto adaptive = [&](const System& s) { return sundials(s, 1e-6, t[t.size() - 1])->run(t); };
    EXPECT_LT(worst(loaded_rod(50, held), held, rows, adaptive), 1.2 * errors[0]) << "the same mesh's error";
  }
  expect_waves(
      "displacement of a rod at two points, held and free, after a step of load, over the static stretch: consistent "
      "mass, average acceleration, 100 elements",
      0.025, "A kink spreads over (time c/L)^(1/3) n^(-2/3) of the rod: 0.023 was seen, 0.036 of half the elements.",
      left.maxCoeff<Eigen::PropagateNaN>());
  expect_waves(
      "factor by which the same error, of consistent mass, falls as 50 elements become 100: distance from "
      "2^(2/3), absolute",
      0.2, "Kinks spread in proportion to n^(-2/3); a factor of order 1 would be 0.41 away.",
      (factor.array() - std::pow(2, 2.0 / 3)).abs().maxCoeff<Eigen::PropagateNaN>());
}

}  // namespace
}  // namespace mb
