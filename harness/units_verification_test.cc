// Scenes told in other systems of units: lengths by L, masses by M, times by T. What has a dimension follows, what has
// none stays: no tolerance, bound or default of unit size hides anywhere between a scene and its answer.
#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "cases/contract/physical_shift.h"
#include "cases/scene/read_toml.h"
#include "harness/catalogue.h"
#include "harness/study/truth.h"
#include "mechanics/geometry/overloaded.h"
#include "modal/bases/eigenmodes.h"

namespace mb {
namespace {

struct Units {
  const char* name;
  double L, M, T;  // of one metre, kilogram, second in the new units
  double pressure() const { return M / (L * T * T); }
};
const Units mm_tonne{"mm, t, s", 1e3, 1e-3, 1}, cgs{"cm, g, s", 1e2, 1e3, 1}, mm_mg_ms{"mm, mg, ms", 1e3, 1e6, 1e3};

Shape in(const Units& u, Shape shape) {
  std::visit(overloaded{[&](Box& b) { b.size *= u.L; }, [&](Cylinder& c) { c.radius *= u.L, c.length *= u.L; },
                        [&](Sphere& s) { s.radius *= u.L; }, [&](Superquadric& s) { s.semi_axes *= u.L; },
                        [&](TaperedSuperquadric& s) { s.straight.semi_axes *= u.L; }},
             shape);
  return shape;
}

History in(const Units& u, History history) {
  std::visit(overloaded{[&](Step& h) { h.start *= u.T; }, [&](Harmonic& h) { h.omega /= u.T, h.start *= u.T; },
                        [&](Pulse& h) { h.duration *= u.T, h.start *= u.T; },
                        [&](Ramp& h) { h.duration *= u.T, h.start *= u.T; },
                        [](auto&) { throw std::logic_error("a history that these tests do not tell in other units"); }},
             history);
  return history;
}

void tell(const Units& u, Patch& patch) {
  if (!patch.disc) return;
  patch.disc->centre *= u.L;
  patch.disc->radius *= u.L;
}

void tell(const Units& u, Body& body) {
  body.shape = in(u, body.shape);
  body.material.youngs_modulus *= u.pressure();
  body.material.density *= u.M / std::pow(u.L, 3);
  body.damping.alpha /= u.T;
  body.damping.beta *= u.T;
  for (Dashpot& dashpot : body.dashpots) dashpot.damping *= u.M / u.T, tell(u, dashpot.patch);
  for (Inclusion& inclusion : body.material.inclusions) inclusion.centre *= u.L, inclusion.size *= u.L;
  for (Support& support : body.supports) {
    tell(u, support.patch);
    if (!support.drive) continue;
    support.drive->acceleration = in(u, support.drive->acceleration);
    const auto amplitude = [&](auto& h) {
      if constexpr (requires { h.amplitude; }) h.amplitude *= u.L / (u.T * u.T);
    };
    std::visit(amplitude, support.drive->acceleration);
  }
  body.pose.position *= u.L;
  body.twist.velocity *= u.L / u.T;
  body.twist.angular_velocity /= u.T;
}

Scene in(const Units& u, Scene scene) {
  for (Body& body : scene.bodies) tell(u, body);
  for (Load& load : scene.loads) {
    load.history = in(u, load.history);
    for (Traction& t : load.tractions) t.traction *= u.pressure(), t.pressure *= u.pressure(), tell(u, t.patch);
  }
  scene.gravity *= u.L / (u.T * u.T);
  for (Obstacle& obstacle : scene.obstacles) {
    obstacle.surface.pose.position *= u.L;
    obstacle.surface.rounding *= u.L;
    if (auto* shape = std::get_if<Shape>(&obstacle.surface.shape)) *shape = in(u, *shape);
  }
  for (ContactPair& pair : scene.contacts) {
    pair.stiffness *= u.pressure() / u.L;
    pair.damping *= u.T / u.L;
    pair.slip_speed *= u.L / u.T;
  }
  for (Probe& probe : scene.probes) probe.point *= u.L;
  for (double* time : {&scene.duration, &scene.samples_from}) *time *= u.T;
  for (double* rate : {&scene.frame_rate, &scene.samples_per_second}) *rate /= u.T;
  return scene;
}

std::shared_ptr<const Scene> told(const std::string& file, const Units& u) {
  const Scene scene = read_toml(std::string(MB_SOURCE_DIR) + "/cases/" + file, default_catalogue().vocabulary());
  return std::make_shared<const Scene>(in(u, scene));
}
const Units si{"m, kg, s", 1, 1, 1};

double relative(const MatrixXd& a, const MatrixXd& b) { return (a - b).norm() / b.norm(); }

Trajectory answer(const std::shared_ptr<const Scene>& scene, const std::string& method, const std::string& integrator,
                  const Settings& settings) {
  const Catalogue catalogue = default_catalogue();
  const Model model = make_model(scene, own_meshes(*scene));
  return catalogue.method(method)
      .prepare(model, settings, catalogue.integrator(integrator))
      ->simulate({sample_times(*scene), true});
}

// Displacements over L and strains, 1e-10: rounding of a condition of 1e6 at most.
void expect_same(const Trajectory& other, const Trajectory& own, const Units& u, double tolerance,
                 const std::string& what) {
  ASSERT_EQ(other.status, own.status) << what;
  for (size_t b = 0; b < own.bodies.size(); ++b) {
    EXPECT_LT(relative(other.bodies[b].displacement / u.L, own.bodies[b].displacement), tolerance) << what;
    EXPECT_LT(relative(other.bodies[b].strain, own.bodies[b].strain), tolerance) << what;
  }
}

class UnitsVerification : public testing::TestWithParam<Units> {};
INSTANTIATE_TEST_SUITE_P(Systems, UnitsVerification, testing::Values(mm_tonne, cgs, mm_mg_ms),
                         [](const auto& each) { return std::to_string(each.index); });

TEST_P(UnitsVerification, MatricesAndModesFollow) {
  const Units u = GetParam();
  for (const char* file : {"cylinder-combined.toml", "hard/dashpot.toml", "hard/stiffness-contrast.toml"}) {
    const auto own = told(file, si), other = told(file, u);
    const Model a = make_model(own, own_meshes(*own)), b = make_model(other, own_meshes(*other));
    const System &s = a.bodies[0].full->system(), &t = b.bodies[0].full->system();
    EXPECT_LT(relative(MatrixXd(t.K) * (u.T * u.T / u.M), MatrixXd(s.K)), 1e-10) << file;
    EXPECT_LT(relative(MatrixXd(t.M) / u.M, MatrixXd(s.M)), 1e-10) << file;
    const Modes one = lowest_modes(s, 12, physical_shift(own->bodies[0]));
    const Modes two = lowest_modes(t, 12, physical_shift(other->bodies[0]));
    ASSERT_EQ(two.n_rigid, one.n_rigid) << file;
    // Of a stiffness contrast of 10^6 the soft modes are known to eps times that, and a little.
    EXPECT_LT(relative(two.omega * u.T, one.omega), own->bodies[0].material.inclusions.empty() ? 1e-10 : 2e-9) << file;
  }
}

TEST_P(UnitsVerification, ClosedFormsAndFixedStepsFollow) {
  const Units u = GetParam();
  for (const char* file : {"cylinder-combined.toml", "hard/dashpot.toml"}) {
    const auto own = told(file, si), other = told(file, u);
    Settings settings{.modes = 12};
    for (const char* method : {"eigenmodes", "static-correction"})
      expect_same(answer(other, method, "exact", settings), answer(own, method, "exact", settings), u, 1e-10, file);
    for (const char* integrator : {"newmark", "central-difference"}) {
      settings.time_step = 2e-4;
      const Trajectory one = answer(own, "eigenmodes", integrator, settings);
      settings.time_step *= u.T;
      expect_same(answer(other, "eigenmodes", integrator, settings), one, u, 1e-10, integrator);
    }
  }
}

// Steps are chosen by estimates of the error: either answer is within the error of one, both within twice that.
TEST_P(UnitsVerification, AdaptiveStepsFollowWithinTheirErrorBars) {
  const Units u = GetParam();
  const auto own = told("hard/dashpot.toml", si), other = told("hard/dashpot.toml", u);
  const Trajectory one = answer(own, "full-order", "sundials", {.relative_tolerance = 1e-5});
  const Trajectory two = answer(other, "full-order", "sundials", {.relative_tolerance = 1e-5});
  const Trajectory truth = answer(own, "full-order", "sundials", {.relative_tolerance = 1e-7});
  const BodyTrajectory &a = one.bodies[0], &b = two.bodies[0], &exact = truth.bodies[0];
  EXPECT_LT(relative(b.displacement / u.L, a.displacement), 2 * relative(a.displacement, exact.displacement));
  EXPECT_LT(relative(b.strain, a.strain), 2 * relative(a.strain, exact.strain));
}

// A stiff layer at rest shakes: what modes are off by, 1e-10 and the basis of every pair, comes back 10^4 times as
// large in its force. A rigid body has none of that.
TEST_P(UnitsVerification, ContactFollows) {
  const Units u = GetParam();
  const auto own = told("hard/resting.toml", si), other = told("hard/resting.toml", u);
  for (const auto& [method, r, of_force, of_place] :
       {std::tuple("eigenmodes", 0, 1e-8, 1e-12), std::tuple("static-correction", 16, 1e-4, 1e-6)}) {
    const Trajectory one = answer(own, method, "exact", {.modes = r, .time_step = 1e-4});
    const Trajectory two = answer(other, method, "exact", {.modes = r, .time_step = 1e-4 * u.T});
    const double force = u.M * u.L / (u.T * u.T);
    EXPECT_LT(relative(two.bodies[0].contact.force / force, one.bodies[0].contact.force), of_force) << r;
    EXPECT_LT(relative(two.bodies[0].displacement / u.L, one.bodies[0].displacement), of_place) << r;
  }
}

}  // namespace
}  // namespace mb
