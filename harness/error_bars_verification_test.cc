// Error bars follow from the distance of two meshes of truths. That they hold is seen by a third, finer still, to which
// marks move by what the finer one is off, but for the q-th part that the third is off itself:
//
//   (|m_3 - m| - t) / (1 - 1/q) + t <= bar      t: what tolerances leave, by the truth of the same mesh
//                                               q: cases/scene/refinement.h
//
// Of answers that are far off, marks hardly move: the third truth is marked against the first, too, m = 0.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <regex>

#include "harness/analysis/modal_body.h"
#include "harness/analysis/modes_against_steps.h"
#include "harness/program_test.h"
#include "harness/store/scratch_folder_test.h"
#include "harness/store/store.h"
#include "harness/study/grade.h"
#include "harness/study/mesh_bar.h"
#include "mechanics/verified_test.h"

namespace mb {
namespace {

struct Finest {
  const char* file;  // of cases/hard
  const char* mesh;  // finer than that of its truth, as the case file says it
};
void PrintTo(const Finest& f, std::ostream* out) { *out << f.file; }
std::string stem_of(const std::string& file) {
  return std::regex_replace(fs::path(file).stem().string(), std::regex("-"), "_");
}

// The case with a study of some modes, of its own truth or of one on `finest`, whose bar is the distance to that.
std::string held_to(const std::string& file, const std::string& finest) {
  std::string all = text(fs::path(MB_SOURCE_DIR) / "cases/hard" / file);
  all.resize(all.find("[study]"));
  std::smatch finer;
  if (!finest.empty() &&
      std::regex_search(all, finer, std::regex("\\[(truth|profile.quick)\\][^]*?\nfiner +=([^\n#]*)"))) {
    const std::string own = finer[2];
    all = std::regex_replace(all, std::regex("\nfiner .*"), "\nfiner = " + finest);
    all = std::regex_replace(all, std::regex("\ncoarser .*"), "\ncoarser = " + own);
  }
  std::smatch time;
  std::regex_search(all, time, std::regex("\nduration += ([0-9.e-]+)"));
  const double duration = std::stod(time[1]);
  all = std::regex_replace(all, std::regex("\nhard +=[^]*?\"\"\"[^]*?\"\"\""), "");
  const bool touches = all.find("[[contact]]") != std::string::npos;
  return all + R"([study]
methods = ["eigenmodes", "static-correction"]
modes   = [2, 8]
)" + (touches ? fmt::format("contact_steps = [{}]", duration / 1000) : "") +
         R"(
[[study.rival]]
integrator = "newmark"
time_steps = [)" +
         fmt::format("{}", duration / 200) + "]\n[end]\n";
}

struct Held {
  std::string quantity, uncertainty, why;
};
void expect_within_bars(double worst, const Held& held) {
  testing::expect_verified({.quantity = held.quantity,
                            .reference = "converged numbers",
                            .source = "a third mesh",
                            .uncertainty = held.uncertainty,
                            .tolerance = 1,
                            .why = held.why},
                           worst);
}

struct Mark {
  double value, bar, time;  // time: the part of the bar that the mesh has none in
  std::string metric;
};
// Marks against the truth on the finer mesh, and of that itself, by contender, metric and subject.
using Marks = std::map<std::string, Mark>;
struct Told {
  std::shared_ptr<const Scene> scene;
  TruthSet truths;
  Marks marks;
};
Marks marks_in(const std::vector<Record>& records) {  // those without a bar are of the answer alone
  Marks marks;
  std::map<std::string, double> times;
  for (const Record& r : records) {
    if (r.status != "ok" || !r.error_bar) continue;
    const std::string what = fmt::format("{} {} r={} {} of {}", r.contender.method, r.contender.integrator,
                                         r.modes_used, r.metric, r.subject);
    if (r.truth == "finer") marks[what] = {r.value, *r.error_bar, 0, r.metric};
    if (r.truth == "same_mesh") times[what] = *r.error_bar;
  }
  for (auto& [what, mark] : marks) mark.time = std::min(mark.bar, times[what]);
  return marks;
}
Told told_of(const std::string& scene) {
  const ScratchFolder scratch;
  const fs::path file = written(scratch / "case.toml", scene), results = scratch / "results";
  const Said said = modalbench(scratch.path(), {"run", file.string(), "--untimed"});
  EXPECT_EQ(said.code, 0) << said.err;
  const Catalogue all = default_catalogue();
  const auto read = std::make_shared<const Scene>(read_toml(file, all.vocabulary()));
  const Store store(results);
  auto truth = truths(
      read, all, store, [](const std::string& line) { ADD_FAILURE() << "not stored: " << line; }, [] { return false; });
  return {read, std::move(truth.value()), marks_in(store.read_all_records().records)};
}
Marks marks_of_truth(const Told& told, const Trajectory& truth) {
  std::vector<bool> free;
  for (const Body& body : told.scene->bodies) free.push_back(!is_held(body));
  Record base;
  base.contender.method = "the truth";
  base.contender.resolution = own_meshes(*told.scene);  // for their part of time
  return marks_in(Grader(*told.scene, told.truths, free, {}).marks(base, truth));
}

// [-] The worst part of its bar that a mark is off by.
double worst_of(const Marks& first, const Marks& then, const Scene& scene) {
  const auto more = [&](const Order& order) {  // than marks move where a mesh of the truth is replaced by a finer one
    return 1 / (1 - 1 / fall_of_errors(scene.truth.finer, scene.truth.coarser, order));
  };
  const auto [local, mean] = orders_of_motion(scene);
  const PerDistance off{more(mean), more(local)};
  double worst = 0;
  for (const auto& [what, mark] : first) {
    const auto moved = then.find(what);
    if (moved == then.end()) {
      ADD_FAILURE() << what << " is not told beside the third mesh";
      continue;
    }
    const double by = std::abs(moved->second.value - mark.value), time = std::min(by, mark.time);
    const double error = time + (by - time) * (is_of_least_order(metric(mark.metric)) ? off.local : off.mean);
    const double of_bar = error > 0 ? error / mark.bar : 0;
    EXPECT_LE(of_bar, 1) << what << " is " << mark.value << " +- " << mark.bar << ", then " << moved->second.value
                         << " +- " << moved->second.bar;
    worst = std::max(worst, of_bar);
  }
  return worst;
}

// The bars of what is relative to the truth's size, in parts of that: of e = 0 they are d/(1 - d) (Metric::relative).
Marks by_size(Marks marks) {
  for (auto& [what, mark] : marks)
    if (metric(mark.metric).relative)
      for (double* bar : {&mark.bar, &mark.time}) *bar /= 1 + *bar;
  return marks;
}

class MarksVerification : public ::testing::TestWithParam<Finest> {};
TEST_P(MarksVerification, KeepToTheirBarsOnAMeshThatIsFinerStill) {
  const auto& [file, mesh] = GetParam();
  const Told first = told_of(held_to(file, "")), then = told_of(held_to(file, mesh));
  EXPECT_LE(first.marks.size(), then.marks.size());  // what the first truth may be zero of has no mark there
  EXPECT_GT(first.marks.size(), 20U);
  expect_within_bars(worst_of(first.marks, then.marks, *then.scene),
                     {"how far marks of modes, of steps and of the truth itself are off, by how they move where the "
                      "truth's mesh is made finer still, of their error bars, the worst",
                      "what the third mesh is off itself, by the least order that errors may have",
                      "A bar is what an error may be: no mark may be off by more than it."});
  const Marks itself = by_size(marks_of_truth(first, first.truths.finer));
  EXPECT_GT(itself.size(), 5U);
  expect_within_bars(worst_of(itself, marks_of_truth(first, then.truths.finer), *then.scene),
                     {"how far the truth is off, by its distance from the truth on a mesh finer still in every metric "
                      "of answers, in parts of its own size, of its error bars, the worst",
                      "what the third mesh is off itself, by the least order that errors may have",
                      "A bar is what an error may be: the truth may be off by no more than it."});
}
INSTANTIATE_TEST_SUITE_P(ErrorBars, MarksVerification,
                         ::testing::Values(Finest{"nearly-incompressible.toml", "{ degree = 4, cells = [3, 3, 4] }"},
                                           Finest{"degenerate-cube.toml", "{ degree = 4, cells = [4, 4, 4] }"},
                                           Finest{"damping-extremes.toml", "{ degree = 4, cells = [3, 3, 18] }"},
                                           Finest{"distorted-mesh.toml", "{ degree = 4, cells = [3, 3, 6] }"},
                                           Finest{"microsecond-beam.toml", "{ degree = 4, cells = [2, 2, 12] }"},
                                           Finest{"dashpot.toml", "{ degree = 4, cells = [2, 2, 12] }"},
                                           Finest{"nearly-degenerate-bar.toml", "{ degree = 4, cells = [2, 2, 8] }"},
                                           Finest{"slender-rod.toml", "{ degree = 3, cells = [1, 1, 64] }"},
                                           Finest{"slender-rod.toml", "{ degree = 3, cells = [2, 2, 32] }"},
                                           Finest{"geological-tower.toml", "{ degree = 4, cells = [2, 2, 12] }"},
                                           Finest{"resonance.toml", "{ degree = 4, cells = [2, 2, 12] }"},
                                           Finest{"million-steps.toml", "{ degree = 4, cells = [2, 2, 20] }"},
                                           Finest{"undamped-impacts.toml", "{ degree = 3, cells = [2], graded = 3 }"},
                                           Finest{"load-within-a-step.toml", "{ degree = 4, cells = [1, 1, 24] }"},
                                           Finest{"../cylinder-compression-step.toml",
                                                  "{ degree = 4, cells = [1, 8] }"},
                                           Finest{"../cylinder-shear.toml", "{ degree = 4, cells = [2, 8] }"}),
                         [](const auto& at) {
                           return stem_of(at.param.file) +
                                  (std::string(at.param.mesh).find("[2, 2, 32]") == std::string::npos ? "" : "_across");
                         });

// Bars of the own mesh's tables are twice the distance to the truth's `finer`.
struct FinestModes {
  const char* file;
  Resolution mesh;
  int n_modes;
};
void PrintTo(const FinestModes& f, std::ostream* out) { *out << f.file; }
class FrequenciesVerification : public ::testing::TestWithParam<FinestModes> {};
TEST_P(FrequenciesVerification, KeepToTheirBarsOnAMeshThatIsFinerStill) {
  const FinestModes& at = GetParam();
  const Scene scene = read_toml(fs::path(MB_SOURCE_DIR) / "cases/hard" / at.file, default_catalogue().vocabulary());
  const auto [meshes, bar_per_distance] = another_mesh(scene);
  const auto modes_on = [&](const Resolution& mesh, int n) {
    const SolvedBody body = solved_body(on_meshes(scene, mesh), n);
    return seen_modes(*body.model.bodies.front().full, body.model.bodies.front().points.volume, body.modes);
  };
  const int more = at.n_modes + more_of_other;
  SeenModes own = modes_on(own_meshes(scene), at.n_modes);
  own.omega.conservativeResize(at.n_modes), own.shapes.conservativeResize(Eigen::NoChange, at.n_modes);
  const VectorXd finer = paired_frequencies(own, modes_on(meshes, more));
  const VectorXd exact = paired_frequencies(own, modes_on(at.mesh, more));
  const double of_third = 1 / (1 - 1 / fall_of_errors(at.mesh, own_meshes(scene), 2 * order_of_modes(scene)));
  const VectorXd off =
      of_third * (own.omega - exact).cwiseAbs().cwiseQuotient(bar_per_distance * (own.omega - finer).cwiseAbs());
  const double worst = off.maxCoeff();
  EXPECT_TRUE(off.allFinite()) << "another mesh has fewer modes, or one of the very same frequency: "
                               << off.transpose();
  EXPECT_LE(worst, 1) << off.transpose();
  expect_within_bars(
      worst,
      {"how far frequencies of the own mesh are from those of a mesh finer than the truth's, of their error bars, the "
       "worst",
       "what the third mesh is off itself, by the least order that errors may have",
       "A bar is what an error may be: twice the distance to a mesh whose error is half of the own's at most."});
}
INSTANTIATE_TEST_SUITE_P(ErrorBars, FrequenciesVerification,
                         ::testing::Values(FinestModes{"slender-rod.toml", {3, {1, 1, 96}}, 6},
                                           FinestModes{"damping-extremes.toml", {4, {2, 2, 12}}, 24},
                                           FinestModes{"dashpot.toml", {4, {2, 2, 12}}, 24},
                                           FinestModes{"resonance.toml", {4, {2, 2, 12}}, 24},
                                           FinestModes{"stiffness-contrast.toml", {4, {3, 4, 20}}, 24},
                                           FinestModes{"nearly-incompressible.toml", {4, {3, 3, 4}}, 24},
                                           FinestModes{"thin-plate.toml", {4, {10, 10, 1}}, 6},
                                           FinestModes{"sliver-mesh.toml", {4, {3, 3, 12}}, 12},
                                           FinestModes{"nearly-degenerate-bar.toml", {4, {3, 3, 16}}, 12},
                                           FinestModes{"million-steps.toml", {4, {2, 2, 20}}, 12},
                                           FinestModes{"beyond-linear.toml", {4, {2, 2, 12}}, 12},
                                           FinestModes{"../free-cube.toml", {4, {4, 4, 4}}, 24},
                                           FinestModes{"../cylinder-shear.toml", {4, {2, 8}}, 12}),
                         [](const auto& at) { return stem_of(at.param.file); });

}  // namespace
}  // namespace mb
