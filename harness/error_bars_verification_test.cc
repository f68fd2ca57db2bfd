// Error bars are distances of two meshes of truths. That they hold is seen by a third, finer still: marks may not move
// by more than their bar.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <regex>

#include "harness/analysis/modal_body.h"
#include "harness/analysis/modes_against_steps.h"
#include "harness/program_test.h"
#include "harness/store/scratch_folder_test.h"
#include "harness/store/store.h"
#include "mechanics/verified_test.h"

namespace mb {
namespace {

struct Ladder {
  const char* file;                    // of cases/hard
  const char *coarse, *middle, *fine;  // meshes, from the coarsest
};

// The case with truths on two meshes, and a study of some modes and of its own mesh stepped, no more.
std::string held_to(const std::string& file, const std::string& finer, const std::string& coarser) {
  std::string all = text(fs::path(MB_SOURCE_DIR) / "cases/hard" / file);
  all.resize(all.find("[study]"));
  all = std::regex_replace(all, std::regex("\nfiner .*"), "\nfiner = " + finer);
  all = std::regex_replace(all, std::regex("\ncoarser .*"), "\ncoarser = " + coarser);
  all = std::regex_replace(all, std::regex("\nhard +=[^]*?\"\"\"[^]*?\"\"\""), "");
  return all + R"([study]
methods = ["eigenmodes", "static-correction"]
modes   = [2, 8]
[[study.rival]]
integrator = "newmark"
time_steps = [5e-3]
)";
}

struct Mark {
  double value, bar;
};
// [-] A bar as long as what it is relative to says that nothing is known of a stress, as at the rod's free end, which
// has none.
constexpr double most_known = 1;
// Of the truth on the finer mesh, by contender, metric and subject. Those without a bar are of the answer alone.
std::map<std::string, Mark> marks_of(const std::string& scene) {
  const ScratchFolder scratch;
  const Said said = modalbench(scratch.path(), {"run", written(scratch / "case.toml", scene).string(), "--untimed"});
  EXPECT_EQ(said.code, 0) << said.err;
  std::map<std::string, Mark> marks;
  for (const Record& r : Store(scratch / "results").read_all_records().records)
    if (r.truth == "finer" && r.status == "ok" && r.error_bar && r.contender.integrator != "sundials")
      marks[fmt::format("{} {} r={} {} of {}", r.contender.method, r.contender.integrator, r.modes_used, r.metric,
                        r.subject)] = {r.value, *r.error_bar};
  return marks;
}

TEST(ErrorBarsVerification, HoldAgainstAMeshThatIsFinerStill) {
  double worst = 0;
  size_t n = 0;
  for (const auto& [file, coarse, middle, fine] :
       {Ladder{"nearly-degenerate-bar.toml", "{ degree = 2, cells = [1, 1, 6] }", "{ degree = 3, cells = [1, 1, 6] }",
               "{ degree = 4, cells = [1, 1, 6] }"},
        Ladder{"dashpot.toml", "{ degree = 2, cells = [1, 1, 6] }", "{ degree = 3, cells = [1, 1, 6] }",
               "{ degree = 4, cells = [1, 1, 6] }"},
        Ladder{"distorted-mesh.toml", "{ degree = 2, cells = [2, 2, 4] }", "{ degree = 2, cells = [3, 3, 6] }",
               "{ degree = 3, cells = [3, 3, 6] }"},
        Ladder{"slender-rod.toml", "{ degree = 3, cells = [1, 1, 12] }", "{ degree = 3, cells = [1, 1, 24] }",
               "{ degree = 3, cells = [1, 1, 48] }"},
        Ladder{"degenerate-cube.toml", "{ degree = 2, cells = [2, 2, 2] }", "{ degree = 2, cells = [3, 3, 3] }",
               "{ degree = 3, cells = [3, 3, 3] }"}}) {
    const auto first = marks_of(held_to(file, middle, coarse)), then = marks_of(held_to(file, fine, middle));
    EXPECT_EQ(first.size(), then.size()) << file;
    for (const auto& [what, mark] : first) {
      ASSERT_TRUE(then.contains(what)) << file << ": " << what;
      if (mark.bar >= most_known && what.find("probe-von-mises") != std::string::npos) continue;
      const double moved = std::abs(then.at(what).value - mark.value) / mark.bar;
      EXPECT_LE(moved, 1) << file << ": " << what << " is " << mark.value << " +- " << mark.bar << ", then "
                          << then.at(what).value << " +- " << then.at(what).bar;
      worst = std::max(worst, moved);
      ++n;
    }
  }
  EXPECT_GT(n, 80);
  testing::expect_verified(
      {.quantity = "how far marks of modes and steps move where the truth's mesh is made finer still, of their error "
                   "bars, the worst",
       .reference = "converged numbers",
       .source = "a third mesh",
       .uncertainty = "that of the third mesh, its own bar",
       .tolerance = 1,
       .why = "A bar is what an error may be: no mark may move by more than it."},
      worst);
}

// Bars of the own mesh's tables are twice the distance to the truth's `finer`.
TEST(ErrorBarsVerification, OfFrequenciesHoldAgainstAMeshThatIsFinerStill) {
  constexpr int n_modes = 6;
  double worst = 0;
  for (const auto& [file, finest] :
       {std::pair{"slender-rod.toml", Resolution{3, {1, 1, 96}}},
        std::pair{"damping-extremes.toml", Resolution{4, {2, 2, 12}}},
        std::pair{"dashpot.toml", Resolution{4, {2, 2, 12}}}, std::pair{"resonance.toml", Resolution{4, {2, 2, 12}}},
        std::pair{"stiffness-contrast.toml", Resolution{3, {4, 6, 10}}},
        std::pair{"nearly-incompressible.toml", Resolution{4, {3, 3, 4}}},
        std::pair{"thin-plate.toml", Resolution{4, {10, 10, 1}}},
        std::pair{"sliver-mesh.toml", Resolution{4, {3, 3, 12}}},
        std::pair{"nearly-degenerate-bar.toml", Resolution{4, {2, 2, 8}}},
        std::pair{"million-steps.toml", Resolution{4, {2, 2, 20}}},
        std::pair{"beyond-linear.toml", Resolution{4, {2, 2, 12}}},
        std::pair{"../free-cube.toml", Resolution{4, {4, 4, 4}}},
        std::pair{"../cylinder-shear.toml", Resolution{4, {2, 8}}}}) {
    const Scene scene = read_toml(fs::path(MB_SOURCE_DIR) / "cases/hard" / file, default_catalogue().vocabulary());
    const auto [meshes, bar_per_distance] = another_mesh(scene);
    const auto omega_on = [&, &s = scene](const Resolution& mesh) {
      const Modes modes = solved_body(on_meshes(s, mesh), n_modes).modes;
      return VectorXd(modes.omega.segment(modes.n_rigid, n_modes));
    };
    const VectorXd own = omega_on(own_meshes(scene)), finer = omega_on(meshes), exact = omega_on(finest);
    const VectorXd off = (own - exact).cwiseAbs().cwiseQuotient(bar_per_distance * (own - finer).cwiseAbs());
    EXPECT_LE(off.maxCoeff(), 1) << file << ": " << off.transpose();
    worst = std::max(worst, off.maxCoeff());
  }
  testing::expect_verified(
      {.quantity =
           "how far frequencies of the own mesh are from those of a mesh finer than the truth's, of their error "
           "bars, the worst",
       .reference = "converged numbers",
       .source = "a third mesh",
       .uncertainty = "that of the third mesh",
       .tolerance = 1,
       .why = "A bar is what an error may be: twice the distance to a mesh whose error is half of the own's at most."},
      worst);
}

}  // namespace
}  // namespace mb
