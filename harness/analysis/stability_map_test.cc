// Full order in the map is stepped in modes. That it is the mesh which the integrator steps is seen by steps of that.
#include <gtest/gtest.h>

#include <cmath>

#include "cases/scene/case_files.h"
#include "harness/analysis/context_test.h"
#include "harness/program_test.h"
#include "harness/store/scratch_folder_test.h"
#include "mechanics/system/modal_form.h"
#include "reports/findings.h"

namespace mb {
namespace {

struct Body {
  const char* name;
  std::vector<std::pair<std::string, std::string>> changes;  // of small_case
};
void PrintTo(const Body& body, std::ostream* out) { *out << body.name; }

const std::string held = "[[body.support]]\nkind = \"fixed\"\nface = \"z-min\"\n";
const std::string dashpot = "[[body.dashpot]]\nface = \"z-max\"\ndirection = [0, 0, 1]\ndamping = 5\n";

Scene scene_of(const Body& body) {
  std::string words = small_case();
  for (const auto& [before, what] : body.changes) words.insert(words.find(before), what);
  const std::string pull = "[[load.traction]]\nbody = \"body\"\nface = \"z-min\"\ntraction = [0, 0, 400]\n";
  if (words.find(held) != std::string::npos) words.erase(words.find(pull), pull.size());
  words.replace(words.find("degree = 2"), 10, "degree = 1");
  const ScratchFolder folder;
  return read_toml(written(folder / "case.toml", words), default_catalogue().vocabulary());
}

// As the map begins: from rest, every elastic mode with the same energy, of 1 together.
double largest_energy(const System& system, bool lumped, const Integrator& integrator, double dt) {
  const System seen = lumped ? with_lumped_mass(system) : with_consistent_mass(system);
  System undamped = seen;
  undamped.modal_damping = {MatrixXd(seen.M.rows(), 0), VectorXd(0)};
  const ModalForm form = modal_form(undamped);
  const Index n_rigid = system.R.cols(), n = form.Phi.cols() - n_rigid;
  System free = system;
  free.F.resize(system.M.rows(), 0);
  free.s.clear();
  free.v0.setZero(system.M.rows());
  free.u0.setZero(system.M.rows());
  for (Index i = 0; i < n; ++i)
    free.u0 += (i % 2 ? -1 : 1) / std::sqrt(form.lambda(n_rigid + i)) * form.Phi.col(n_rigid + i);
  Settings settings;
  settings.time_step = dt;
  const VectorXd times = dt * VectorXd::LinSpaced(1000, 1, 1000);
  const States states = integrator.prepare(free, settings, times(999))->run(times);
  if (states.status != Status::ok) return std::numeric_limits<double>::infinity();
  double largest = 0;
  for (Index j = 0; j < times.size(); ++j)
    largest = std::max(largest,
                       (states.v.col(j).dot(seen.M * states.v.col(j)) + states.u.col(j).dot(seen.K * states.u.col(j))) /
                           static_cast<double>(n));
  return std::isfinite(largest) ? largest : std::numeric_limits<double>::infinity();
}

class StabilityMapOf : public ::testing::TestWithParam<Body> {};
TEST_P(StabilityMapOf, FullOrderIsTheMeshThatIsStepped) {
  const Scene scene = scene_of(GetParam());
  const Model model = make_model(std::make_shared<const Scene>(scene), own_meshes(scene));
  const System& system = model.bodies.front().full->system();
  ASSERT_GT(system.lumped_mass.rows(), 0);
  const Finding map = test::analysed("stability-map", scene).front();
  const Catalogue catalogue = default_catalogue();
  std::map<std::string, std::array<int, 2>> seen;  // bounded, unstable
  for (std::size_t i = 0; i < map.rows.size(); ++i) {
    if (text_at(map, i, "system") != "full order") continue;
    const Integrator& integrator = catalogue.integrator(text_at(map, i, "integrator"));
    const double dt = number_at(map, i, "dt"), energy = number_at(map, i, "energy");
    const double own = largest_energy(system, integrator.conditionally_stable, integrator, dt);
    const bool unstable = text_at(map, i, "found") == "unstable";
    seen[integrator.name][unstable] += 1;
    if (unstable)
      EXPECT_GT(own, 1e4) << integrator.name << " " << dt;
    else
      EXPECT_NEAR(own / energy, 1, 1e-6) << integrator.name << " " << dt;  // rounding of 1000 steps, each its own
    EXPECT_NE(text_at(map, i, "verdict"), "not as predicted") << integrator.name << " " << dt;
    EXPECT_NE(text_at(map, i, "verdict"), "no prediction") << integrator.name << " " << dt;
  }
  EXPECT_EQ(seen.size(), 4U);
  for (const char* name : {"central-difference", "symplectic-euler"})
    for (const int n : seen[name]) EXPECT_GT(n, 1) << name << " was seen on one side of its limit alone";
}
INSTANTIATE_TEST_SUITE_P(
    Bodies, StabilityMapOf,
    ::testing::Values(Body{"undamped", {}}, Body{"held", {{"[[load]]\n", held}}},
                      Body{"damped", {{"[body.resolution]", "[body.damping]\nbeta = 1e-3\n"}}},
                      Body{"ratios", {{"[[load]]\n", held}, {"[body.resolution]", "[body.damping]\nratios = [40]\n"}}},
                      Body{"both", {{"[body.resolution]", "[body.damping]\nalpha = 5\nbeta = 1e-3\n"}}},
                      Body{"dashpot", {{"[[load]]\n", held + dashpot}}},
                      Body{"dashpot_beside_mass",
                           {{"[[load]]\n", held + dashpot}, {"[body.resolution]", "[body.damping]\nalpha = 5\n"}}}),
    [](const auto& at) { return at.param.name; });

}  // namespace
}  // namespace mb
