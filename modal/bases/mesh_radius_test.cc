#include "modal/bases/mesh_radius.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mechanics/algebra/dense_eigen.h"
#include "mechanics/algebra/noise.h"
#include "mechanics/system/central_difference.h"
#include "mechanics/system/explicit_euler.h"
#include "mechanics/system/oscillators_test.h"
#include "mechanics/system/symplectic_euler.h"
#include "modal/bases/highest_mode.h"

namespace mb {
namespace {

using Make = std::unique_ptr<Stepper> (*)(const System&, double);

struct Damped {
  const char* name;
  System system;
};

// The seventh mode of the consistent mass, which is none of the lumped one, at a damping ratio.
System with_ratio(const Rayleigh& damping, double ratio) {
  System system = test::lumped_box(damping);
  const EigenPairs all = generalized_eigen(MatrixXd(system.K), MatrixXd(system.M)).value();
  system.modal_damping = {system.M * all.vectors.col(6), VectorXd{{2 * ratio * std::sqrt(all.values(6))}}};
  return system;
}

System with_dashpot(const Rayleigh& damping, double c) {
  System system = test::lumped_box(damping);
  const Index n = system.M.rows();
  system.modal_damping = {VectorXd::Unit(n, n - 1) + VectorXd::Unit(n, n - 4), VectorXd{{c}}};
  return system;
}

// By V, as of joined bodies: between the motions of the last node and of the first.
System with_viscous(double c) {
  System system = test::lumped_box({});
  const Index n = system.M.rows();
  VectorXd between = VectorXd::Zero(n);
  between.head(3).setConstant(-1), between.tail(3).setConstant(1);
  system.viscous = SparseMatrix(MatrixXd(c * between * between.transpose()).sparseView());
  return system;
}

// Fewer unknowns than a Lanczos basis: by a dense solver.
System small(const Rayleigh& damping) {
  System system = test::oscillators(VectorXd{{10, 25, 80}}, damping, true);
  system.modal_damping = {VectorXd{{1, -0.7, 0.4}}, VectorXd{{60}}};
  return system;
}

System consistent(System system) {
  system.lumped_mass.resize(0, 0);
  return system;
}

std::vector<Damped> bodies() {
  return {{"undamped", test::lumped_box({})},
          {"of stiffness", test::lumped_box({0, 1e-2})},
          {"of mass", test::lumped_box({30, 0})},
          {"of both", test::lumped_box({30, 1e-2})},
          {"one mode", with_ratio({}, 50)},
          {"one mode beside both", with_ratio({5, 1e-3}, 50)},
          {"dashpot", with_dashpot({}, 100)},
          {"viscous", with_viscous(100)},
          {"three unknowns", small({1, 1e-3})},
          {"consistent, of both", consistent(test::lumped_box({30, 1e-2}))},
          {"consistent, dashpot", consistent(with_dashpot({5, 1e-3}, 100))}};
}

// Largest |u| over every hundredth of n steps from noise.
VectorXd sizes(System system, Make make, double h, long n) {
  system.u0 = 1e-120 * uniform_noise(system.M.rows(), 5);  // whose squares grow without overflow
  const Index windows = 100, each = n / windows;
  const States states =
      make(system, h)->run(h * VectorXd::LinSpaced(windows * each, 1, static_cast<double>(windows * each)));
  VectorXd largest(windows);
  for (Index i = 0; i < windows; ++i) largest(i) = states.u.middleCols(i * each, each).colwise().norm().maxCoeff();
  return largest;
}

// [-] Logarithm of a step's, once it is e^24 that of what noise began with.
double observed_growth(const System& system, Make make, double h, double rho) {
  const long each = std::lround(0.4 / std::log(rho)) + 1;
  const VectorXd grown = sizes(system, make, h, 100 * each);
  return std::log(grown(99) / grown(59)) / static_cast<double>(40 * each);
}

// Where rho passes 1.
double limit(const System& system, const char* integrator) {
  double low = 0, high = 20 / highest_mode(consistent(system)).omega;
  while (high - low > 1e-6 * high) {
    const double middle = (low + high) / 2;
    (mesh_radius(system, integrator, middle) > 1 + 1e-9 ? high : low) = middle;
  }
  return low;
}

const std::pair<const char*, Make> leap_frogs[] = {{"symplectic-euler", symplectic_euler},
                                                   {"central-difference", central_difference}};

// Steps of the integrators themselves, on both sides of where the radius passes 1.
TEST(MeshRadius, IsWhatStepsOfAMeshGrowBy) {
  for (const auto& [name, system] : bodies())
    for (const auto& [integrator, make] : leap_frogs) {
      const double h = limit(system, integrator);
      ASSERT_GT(h, 0) << name << integrator;
      const VectorXd within = sizes(system, make, 0.98 * h, 4000);
      EXPECT_LT(within.tail(50).maxCoeff(), 30 * within(0)) << name << " " << integrator;
      const double rho = mesh_radius(system, integrator, 1.02 * h);
      EXPECT_GT(rho, 1.01) << name << " " << integrator;
      EXPECT_NEAR(observed_growth(system, make, 1.02 * h, rho) / std::log(rho), 1, 1e-3) << name << " " << integrator;
    }
}

// Theory: 2/omega of damping that is implicit; 4 M - 2 h C - h^2 K stops being positive of damping that lags.
TEST(MeshRadius, PassesOneAtTheLimitOfTheory) {
  const System lagging = with_ratio({0, 1e-3}, 50), implicit = consistent(with_dashpot({5, 1e-3}, 100));
  EXPECT_NEAR(limit(implicit, "central-difference") * highest_mode(implicit).omega, 2, 1e-5);
  const double h = limit(lagging, "central-difference");
  MatrixXd C(lagging.M.rows(), lagging.M.rows());
  for (Index j = 0; j < C.cols(); ++j) C.col(j) = apply_damping(lagging, VectorXd::Unit(C.cols(), j));
  const auto least = [&](double step) {
    return symmetric_eigenvalues(4 * MatrixXd(lagging.lumped_mass) - 2 * step * C - step * step * MatrixXd(lagging.K))
        .minCoeff();
  };
  EXPECT_GT(least(0.9999 * h), 0);
  EXPECT_LT(least(1.0001 * h), 0);
  EXPECT_LT(h, 0.5 * limit(test::lumped_box({0, 1e-3}), "central-difference")) << "the ratio decides";
}

// Its own search finds the limit that the radius has by bisection.
TEST(MeshLimit, IsWhereTheRadiusPassesOne) {
  for (const auto& [name, system] : bodies()) {
    const bool lumped = system.lumped_mass.rows() > 0;
    const System seen = lumped ? with_lumped_mass(system) : system;
    for (const Scheme& scheme : schemes()) {
      const auto found = mesh_limit(seen, scheme);
      EXPECT_EQ(found.has_value(), scheme.name.starts_with("symplectic") || scheme.name.starts_with("central"));
      if (!found || !steps_as(scheme, system)) continue;
      EXPECT_NEAR(found->dt / limit(system, scheme.integrator.c_str()), 1, 3e-6) << name << " " << scheme.name;
      EXPECT_NEAR(found->mode.phi.dot(seen.M * found->mode.phi), 1, 1e-9);
    }
  }
  const System ratio = with_lumped_mass(with_ratio({}, 50));
  const double lags = mesh_limit(ratio, scheme("central-difference, lagged damping")).value().dt,
               undamped = mesh_limit(ratio, scheme("central-difference")).value().dt,
               by_new_rate = mesh_limit(ratio, scheme("symplectic-euler, implicit damping")).value().dt;
  EXPECT_LT(lags, 0.5 * undamped);
  EXPECT_GE(by_new_rate, undamped * (1 - 1e-9)) << "damping by the new rate never lowers the limit";
}

TEST(MeshRadius, OfExplicitEulerIsThatOfWhatGrowsMost) {
  for (const auto& [name, system] : bodies()) {
    if (system.M.rows() < 12) continue;  // its dashpot couples every mode with all others: no estimate is near
    int n_grown = 0;
    for (const double x : {0.3, 1.0, 4.0}) {
      const double h = x / highest_mode(consistent(system)).omega, rho = mesh_radius(system, "explicit-euler", h);
      if (rho < 1.01) continue;
      ++n_grown;
      EXPECT_NEAR(observed_growth(system, explicit_euler, h, rho) / std::log(rho), 1, 0.05) << name << " " << x;
    }
    EXPECT_GT(n_grown, 0) << name;
  }
}

TEST(MeshRadius, IsUnknownWhileItStillRises) {
  const System system = with_dashpot({}, 100);
  const double h = 4 * limit(system, "symplectic-euler");
  EXPECT_GT(mesh_radius(system, "symplectic-euler", h), 1);
  EXPECT_TRUE(std::isnan(mesh_radius(system, "symplectic-euler", h, 1)));
  const Scheme& kicked = scheme("symplectic-euler");
  EXPECT_TRUE(mesh_limit(with_lumped_mass(system), kicked));
  EXPECT_FALSE(mesh_limit(with_lumped_mass(system), kicked, 1));
}

TEST(MeshRadius, IsUnknownOfOtherIntegrators) {
  EXPECT_TRUE(std::isnan(mesh_radius(test::lumped_box({}), "sundials", 1)));
  EXPECT_TRUE(std::isnan(mesh_radius(test::lumped_box({}), "newmark", 1)));
}

}  // namespace
}  // namespace mb
