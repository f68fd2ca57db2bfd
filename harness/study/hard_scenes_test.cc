// What every hard case must bring along: contenders of every integrator, on the mesh and on its modes, below and past
// the limit of their steps, and checks that hold them to what must come of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "cases/scene/read_toml.h"
#include "harness/catalogue.h"
#include "harness/metrics/metric.h"
#include "harness/study/plan.h"

namespace mb {
namespace {

namespace fs = std::filesystem;

std::vector<Scene> hard_scenes() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(fs::path(MB_SOURCE_DIR) / "cases/hard"))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  std::ranges::sort(files);
  std::vector<Scene> scenes;
  for (const fs::path& file : files) scenes.push_back(read_toml(file, default_catalogue().vocabulary()));
  return scenes;
}

bool has(const std::vector<std::string>& names, const std::string& name) { return std::ranges::count(names, name) > 0; }

// Modes of a free body that turns are stepped in its frame, by nothing but the closed form.
bool turns(const Scene& scene) {
  return std::ranges::any_of(scene.bodies,
                             [](const Body& b) { return b.kinematics == Kinematics::finite && b.supports.empty(); });
}

bool is_damped(const Body& body) {
  return body.damping.alpha > 0 || body.damping.beta > 0 || !body.damping_ratios.empty() || !body.dashpots.empty();
}

// Of a truth, not of the answer or of the truth alone.
bool is_error(const std::string& name) {
  const auto found = std::ranges::find(metric_catalogue(), name, &Metric::name);
  return found != metric_catalogue().end() && !found->of_answer_alone && !found->of_truth_alone;
}

// Whether any check of such runs asks for that end, "unstable", or with "" holds an error of theirs from above.
bool checked(const Scene& scene, const std::string& method, const std::string& integrator, const std::string& status) {
  return std::ranges::any_of(scene.checks, [&](const Check& check) {
    return check.method == method && check.integrator == integrator && check.status == status &&
           (!status.empty() || (check.at_most && is_error(check.metric)));
  });
}

class HardScenes : public ::testing::Test {
 protected:
  const Catalogue catalogue_ = default_catalogue();
  const std::vector<Scene> all_ = hard_scenes();
};

// Limits of explicit schemes that no step is below, or so low that a million steps within them do not reach the end:
// 2 zeta/omega of explicit Euler, and of symplectic Euler about 1/(zeta omega) where zeta is 1e8.
const std::map<std::string, std::vector<std::string>> modes_beyond_reach{
    {"explicit-euler", {"damping-extremes", "million-steps", "resonance", "stiff-at-frame-rate"}},
    {"symplectic-euler", {"damping-extremes"}}};

// Modes in contact are contenders in closed form between kicks alone; contact-stability steps them by all others.
TEST_F(HardScenes, WithoutContactAreSteppedByEveryIntegratorInModes) {
  ASSERT_GE(all_.size(), 25u);
  for (const Scene& scene : all_) {
    if (!scene.contacts.empty() || turns(scene)) continue;
    for (const Integrator& integrator : catalogue_.integrators) {
      if (integrator.name == "exact") continue;
      const std::string what = scene.name + " " + integrator.name;
      EXPECT_TRUE(std::ranges::any_of(scene.study.steppings, [&](const Stepping& s) {
        return s.integrator == integrator.name;
      })) << what;
      EXPECT_EQ(checked(scene, "eigenmodes", integrator.name, "unstable"), integrator.conditionally_stable) << what;
      const auto beyond = modes_beyond_reach.find(integrator.name);
      const bool reached = beyond == modes_beyond_reach.end() || !has(beyond->second, scene.name);
      EXPECT_EQ(checked(scene, "eigenmodes", integrator.name, ""), reached) << what << ": below the limit, if any";
    }
  }
}

// Against the truth of the mesh what is cut would hide what steps make wrong.
TEST_F(HardScenes, EveryStepOfModesIsHeldToTheirClosedFormOrToItsEnd) {
  for (const Scene& scene : all_) {
    for (const Stepping& stepping : scene.study.steppings)
      for (const std::string& method : stepping.methods) {
        if (method == "full") continue;
        for (const int r : stepping.modes) {
          std::vector<std::optional<double>> steps(stepping.time_steps.begin(), stepping.time_steps.end());
          if (steps.empty()) steps.emplace_back();
          for (const auto& step : steps)
            EXPECT_TRUE(std::ranges::any_of(
                scene.checks,
                [&](const Check& check) {
                  return check.method == method && check.modes == r && check.integrator == stepping.integrator &&
                         check.time_step == step &&
                         (check.status == "unstable" || (check.truth == "same_modes" && check.at_most));
                }))
                << scene.name << " " << method << " " << stepping.integrator << " r=" << r << " " << step.value_or(0);
        }
      }
  }
}

// What a mesh of its own leaves is its steps alone, as of the same modes.
TEST_F(HardScenes, AreSteppedInFullOrderOnTheirOwnMeshToItsTruth) {
  for (const Scene& scene : all_) {
    if (!scene.contacts.empty()) {  // the quick profile has another mesh: any of its rivals
      EXPECT_TRUE(std::ranges::any_of(scene.checks, [](const Check& check) {
        return check.method == "full-order" && check.integrator == "newmark" && check.truth == "same_mesh";
      })) << scene.name;
      continue;
    }
    int n = 0;
    for (const Contender& own : contenders(scene, catalogue_)) {
      if (!is_full_order(own) || catalogue_.integrator(own.integrator).conditionally_stable ||
          to_string(own.resolution) != to_string(own_meshes(scene)))
        continue;
      ++n;
      EXPECT_TRUE(std::ranges::any_of(scene.checks,
                                      [&](const Check& check) {
                                        return check.method == "full-order" && check.integrator == own.integrator &&
                                               check.truth == "same_mesh" && check.at_most &&
                                               check.time_step == own.settings.time_step;
                                      }))
          << scene.name << " " << own.integrator << " " << own.settings.time_step;
    }
    EXPECT_GE(n, 2) << scene.name << ": implicit steps of the mesh itself";
  }
}

// What holds against its own mesh alone may be wrong by whatever that mesh is.
TEST_F(HardScenes, AreHeldToAFinerMesh) {
  for (const Scene& scene : all_)
    EXPECT_TRUE(std::ranges::any_of(scene.checks, [&](const Check& c) {
      return c.truth == "finer" && c.at_most && is_error(c.metric);
    })) << scene.name;
}

// Of these a million steps of a mesh within its limit do not reach the end: 200 of step-limits alone are below it.
const std::vector<std::string> out_of_reach{"damping-extremes", "slender-rod", "thin-plate"};

TEST_F(HardScenes, AreSteppedInFullOrderBelowAndPastTheLimit) {
  for (const Scene& scene : all_) {
    bool implicit = false, past = false;
    for (const Rival& rival : scene.study.rivals) {
      const bool conditionally = catalogue_.integrator(rival.integrator).conditionally_stable;
      implicit |= !conditionally;
      past |= conditionally && checked(scene, "full-order", rival.integrator, "unstable");
    }
    EXPECT_TRUE(implicit && past) << scene.name;
    const bool couples = std::ranges::any_of(scene.bodies, [](const Body& b) { return !b.dashpots.empty(); });
    EXPECT_EQ(has(scene.study.analyses, "step-limits"), scene.contacts.empty() && !couples) << scene.name;
    if (has(out_of_reach, scene.name)) continue;
    EXPECT_TRUE(checked(scene, "full-order", "central-difference", "") ||
                checked(scene, "full-order", "symplectic-euler", ""))
        << scene.name << ": below the limit";
  }
}

// Of the whole mesh explicit Euler, stable to 2 zeta/omega, is run past that alone where a run within it would take
// millions of steps or nothing is damped: step-limits knows its limit, where there is one, of most too short to tell.
const std::vector<std::string> beyond_reach_of_euler{
    "damping-extremes", "degenerate-sphere",     "geological-tower",      "microsecond-beam", "million-steps",
    "near-zero",        "nearly-degenerate-bar", "nearly-incompressible", "resonance",        "slender-rod",
    "sliver-mesh",      "stiff-at-frame-rate",   "stiffness-contrast",    "thin-plate",       "undamped-impacts"};

TEST_F(HardScenes, HoldExplicitEulerOfTheMeshFromBothSidesWhereItsLimitIsInReach) {
  std::vector<std::string> of_none;
  for (const Scene& scene : all_) {
    const bool within = std::ranges::any_of(scene.checks, [](const Check& check) {
      return check.method == "full-order" && check.integrator == "explicit-euler" && check.at_most;
    });
    const bool mapped = std::ranges::any_of(scene.checks, [](const Check& check) {
      return check.row == "explicit-euler, full order" && check.at_least.value_or(0) > 0 &&
             (check.column == "order" || check.column == "stable");
    });
    if (!within && !mapped) of_none.push_back(scene.name);
  }
  EXPECT_EQ(of_none, beyond_reach_of_euler);
}

// Limits of steps are of small motion without contact: of what presses and of finite strain runs alone tell.
TEST_F(HardScenes, InContactOrOfFiniteStrainAreSteppedInFullOrderByEveryExplicitIntegrator) {
  for (const Scene& scene : all_) {
    const bool finite =
        std::ranges::any_of(scene.bodies, [](const Body& b) { return b.kinematics == Kinematics::finite; });
    if (scene.contacts.empty() && !finite) continue;
    for (const Integrator& integrator : catalogue_.integrators) {
      if (!integrator.conditionally_stable) continue;
      EXPECT_TRUE(checked(scene, "full-order", integrator.name, "unstable")) << scene.name << " " << integrator.name;
      const bool damped = std::ranges::any_of(scene.bodies, is_damped);  // else explicit Euler's limit is no step
      const bool below = std::ranges::any_of(scene.checks, [&](const Check& c) {  // an error, or its energy alone
        return c.method == "full-order" && c.integrator == integrator.name && c.status.empty() && c.at_most;
      });
      EXPECT_EQ(below, damped || integrator.name != "explicit-euler")
          << scene.name << " " << integrator.name << ": steps below the limit";
    }
  }
}

TEST_F(HardScenes, HaveMapsOfTheirStepsAndSayWhatIsHard) {
  for (const Scene& scene : all_) {
    const std::string map = scene.contacts.empty() ? "stability-map" : "contact-stability";
    EXPECT_TRUE(has(scene.study.analyses, map)) << scene.name;
    const auto held = [&](const std::string& table, const char* column) {
      return std::ranges::any_of(scene.checks, [&](const Check& check) {
        return check.table == table && check.column == column && check.row.empty();
      });
    };
    for (const char* table : {"contact-stability-summary", "corrected-stability-summary"})
      EXPECT_TRUE(scene.contacts.empty() || held(table, "share as predicted")) << scene.name << " " << table;
    if (scene.contacts.empty()) {
      EXPECT_TRUE(held("stability-summary", "not as predicted")) << scene.name;
      EXPECT_TRUE(held("stability-summary", "share as predicted")) << scene.name << ": it may say nothing";
    }
    EXPECT_FALSE(scene.hard.empty()) << scene.name;
  }
}

// Two checks of the same runs but for the step, the smaller held to less.
bool falls(const Scene& scene, const std::string& method) {
  const auto is_finer = [](const Check& a, const Check& b) {
    return a.time_step && b.time_step && *a.time_step < *b.time_step && a.at_most && b.at_most &&
           *a.at_most < *b.at_most;
  };
  return std::ranges::any_of(scene.checks, [&](const Check& a) {
    return a.method == method && is_error(a.metric) && std::ranges::any_of(scene.checks, [&](const Check& b) {
             return b.method == method && b.integrator == a.integrator && b.modes == a.modes && b.metric == a.metric &&
                    b.truth == a.truth && b.rotation == a.rotation && is_finer(a, b);
           });
  });
}

// The order of one integrator that is stable at any step says so of modes as well.
TEST_F(HardScenes, ComeNearerToTheTruthAsTheStepFalls) {
  for (const Scene& scene : all_) {
    EXPECT_TRUE(falls(scene, "full-order")) << scene.name;
    const std::string table = scene.contacts.empty() ? "stability-summary" : "contact-stability-summary";
    const bool has_order = std::ranges::any_of(scene.checks, [&](const Check& check) {
      return check.table == table && check.row == "newmark" && check.column == "order" && check.at_least;
    });
    EXPECT_TRUE(has_order || falls(scene, "eigenmodes")) << scene.name;
  }
}

// A limit predicted far too low would find everything unstable as predicted, one too high stable cells within it.
TEST_F(HardScenes, HoldLimitsOfContactFromBothSides) {
  for (const Scene& scene : all_)
    for (const char* table : {"contact-stability-summary", "corrected-stability-summary"})
      for (const Integrator& integrator : catalogue_.integrators) {
        if (scene.contacts.empty() || integrator.name == "sundials") continue;
        const auto held = [&](const char* column) {
          return std::ranges::any_of(scene.checks, [&](const Check& check) {
            return check.table == table && check.row == integrator.name && check.column == column && check.at_most;
          });
        };
        const std::string what = scene.name + " " + table + " " + integrator.name;
        EXPECT_TRUE(held("unstable within the limit")) << what;
        EXPECT_TRUE(integrator.name == "newmark" || held("bounded beyond the limit")) << what;
      }
}

}  // namespace
}  // namespace mb
