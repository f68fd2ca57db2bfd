// Who answers, in which profile: rivals, steppings, analyses, checks, closed forms.
#include <gtest/gtest.h>

#include "cases/scene/case_files.h"
#include "cases/scene/closed_form.h"

namespace mb {
namespace {

using test::cylinder_text;
using test::problems_of_text;
using test::with;

std::string with_stepping(const std::string& keys) {
  return with(cylinder_text(), "[[study.rival]]", "[[study.stepping]]\n" + keys + "\n[[study.rival]]");
}

std::string with_profile(const std::string& keys) {
  return with(cylinder_text(), "[profile.standard]\n", "[profile.quick]\n" + keys + "\n[profile.standard]\n");
}

// The only check left is of 32 modes, which every profile below runs.
std::string with_one_check(std::string text) {
  const std::size_t second = text.find("[[check]]", text.find("[[check]]") + 1);
  return text.erase(second);
}

TEST(ReadStudy, steppings_take_steps_or_tolerances_by_integrator) {
  const Scene scene = test::read(with_stepping(R"(integrator = "central-difference"
methods = ["eigenmodes", "full"]
modes = [4, 16]
time_steps = [1e-3, 1e-4]
[[study.stepping]]
integrator = "sundials"
methods = ["linear"]
relative_tolerances = [1e-4])"));
  ASSERT_EQ(scene.study.steppings.size(), 2u);
  const Stepping& explicit_steps = scene.study.steppings[0];
  EXPECT_EQ(explicit_steps.integrator, "central-difference");
  EXPECT_EQ(explicit_steps.methods, (std::vector<std::string>{"eigenmodes", "full"}));
  EXPECT_EQ(explicit_steps.modes, (std::vector<int>{4, 16}));
  EXPECT_EQ(explicit_steps.time_steps, (std::vector<double>{1e-3, 1e-4}));
  EXPECT_TRUE(explicit_steps.relative_tolerances.empty());
  EXPECT_TRUE(scene.study.steppings[1].modes.empty());
  EXPECT_TRUE(scene.study.steppings[1].time_steps.empty());
  EXPECT_EQ(scene.study.steppings[1].relative_tolerances, (std::vector<double>{1e-4}));
}

TEST(ReadStudy, rivals_without_degrees_and_cells_are_of_the_bodies_own_meshes) {
  const auto rival = [](const std::string& keys) {
    return with(cylinder_text(), "[[study.rival]]",
                "[[study.rival]]\nintegrator = \"newmark\"\ntime_steps = [1e-3]\n" + keys + "[[study.rival]]");
  };
  const Scene scene = test::read(rival(""));
  EXPECT_TRUE(scene.study.rivals.at(0).cells.empty());
  EXPECT_TRUE(scene.study.rivals.at(0).degrees.empty());
  const auto is_refused = [&](const std::string& keys, const char* why) {
    const std::string all = problems_of_text(rival(keys));
    EXPECT_NE(all.find(why), std::string::npos) << all;
  };
  is_refused("degrees = [2]\n", "'cells'");
  is_refused("cells = [[0, 2]]\n", "'degrees'");
  is_refused("graded = 1\n", "'graded' needs 'degrees' and 'cells'");
  std::string two = test::content(test::cases_folder() / "ball-on-two-by-four.toml");
  two.insert(two.find("[[study.rival]]"),
             "[[study.rival]]\nintegrator = \"newmark\"\ntime_steps = [1e-4]\nsecond_cells = [[8, 2, 1]]\n");
  EXPECT_NE(problems_of_text(two).find("'second_cells' needs 'degrees' and 'cells'"), std::string::npos);
}

TEST(ReadStudy, rivals_of_adaptive_integrators_take_tolerances) {
  const std::string text = with(cylinder_text(), "[[study.rival]]", R"([[study.rival]]
integrator = "sundials"
degrees = [2]
cells = [[0, 2], [1, 2]]
relative_tolerances = [1e-3, 1e-5]
[[study.rival]])");
  const Rival rival = test::read(text).study.rivals.at(0);
  EXPECT_EQ(rival.relative_tolerances, (std::vector<double>{1e-3, 1e-5}));
  EXPECT_EQ(rival.cells, (std::vector<std::vector<int>>{{0, 2}, {1, 2}}));
  EXPECT_TRUE(rival.time_steps.empty());
}

TEST(ReadStudy, rivals_in_contact_or_of_finite_strain_step_such_systems) {
  Vocabulary names = test::vocabulary();
  names.integrators.push_back("own");  // of whoever wrote it, for linear bodies alone
  const auto problems = [&](const std::string& file, const std::string& integrator) -> std::string {
    const std::string text = test::content(test::cases_folder() / file), head = "[[study.rival]]\nintegrator = \"";
    try {
      read_scene(text.substr(0, text.find(head)) + head + integrator + "\"\ntime_steps = [1e-3]\n", "test.toml",
                 test::cases_folder(), names, "quick");
      return "";
    } catch (const CaseErrors& errors) {
      return errors.what();
    }
  };
  EXPECT_NE(problems("hard/beyond-linear.toml", "own").find("'own' steps no full order in contact or of finite"),
            std::string::npos);
  EXPECT_NE(problems("hard/grazing.toml", "own").find("there are: newmark, central-diff"), std::string::npos);
  EXPECT_EQ(problems("hard/dashpot.toml", "own").find("own"), std::string::npos);
  EXPECT_EQ(problems("hard/grazing.toml", "explicit-euler").find("explicit-euler"), std::string::npos);
}

// Two methods at 4 mode counts and one without are 9 runs a step: 576 with 64 steps, 1152 in two entries.
TEST(ReadStudy, counts_runs_with_mode_counts_only_where_methods_take_them) {
  std::string steps = "0.01";
  for (int i = 1; i < 64; ++i) steps += ", 0.01";
  const auto entry = [&](const char* methods) {
    return std::string("integrator = \"newmark\"\nmethods = ") + methods + "\nmodes = [1, 2, 3, 4]\ntime_steps = [" +
           steps + "]\n";
  };
  const std::string nine = entry(R"(["eigenmodes", "static-correction", "linear"])");
  EXPECT_EQ(problems_of_text(with_stepping(nine)), "");
  EXPECT_NE(problems_of_text(with_stepping(nine + "[[study.stepping]]\n" + nine)).find("1152 stepping runs: at most"),
            std::string::npos);
}

TEST(ReadStudy, mode_counts_are_required_only_of_methods_that_take_them) {
  std::string text = cylinder_text().substr(0, cylinder_text().find("[[check]]"));
  text = with(text, "modes   = [0, 1, 2, 4, 8, 16, 32, 64, 128, 256]\n", "");
  EXPECT_NE(problems_of_text(text).find("missing key 'modes' in [study]"), std::string::npos);
  text = with(text, R"(["eigenmodes", "static-correction"])", R"(["linear", "quadratic"])");
  EXPECT_TRUE(test::read(text).study.modes.empty());
}

TEST(ReadStudy, full_in_closed_form_takes_small_meshes_in_every_profile) {
  const std::string text =
      with(cylinder_text(), R"(["eigenmodes", "static-correction"])", R"(["eigenmodes", "static-correction", "full"])");
  EXPECT_EQ(problems_of_text(text), "") << "4,539 degrees of freedom";
  const std::string fine = with(text, "[profile.full]\n",
                                "[profile.full]\nresolution = { cylinder = { degree = 3, cells = [2, 4] } }\n"
                                "finer = { degree = 4, cells = [2, 8] }\n");
  EXPECT_NE(problems_of_text(fine).find("Q3 2x4 of body 'cylinder' has 7527"), std::string::npos);
}

TEST(ReadStudy, analyses_and_prose_are_kept) {
  const std::string text = with(with(cylinder_text(), "[study]\n", "[study]\nanalyses = [\"aliasing\", \"budget\"]\n"),
                                "schema  = 1", "schema = 1\nexercises = \"Damping.\"");
  EXPECT_EQ(test::read(text).study.analyses, (std::vector<std::string>{"aliasing", "budget"}));
  EXPECT_EQ(test::read(text).exercises, "Damping.");
  EXPECT_TRUE(test::read(cylinder_text()).study.analyses.empty());
}

TEST(ReadStudy, analyses_of_beams_are_those_that_take_them) {
  std::string text = with(test::content(test::cases_folder() / "timoshenko-1913.toml"), "[study]\n",
                          "[study]\nanalyses = [\"contact-stiffness\"]\n");
  EXPECT_EQ(problems_of_text(text), "");
  text = with(text, "[\"contact-stiffness\"]", "[\"contact-stiffness\", \"budget\"]");
  EXPECT_NE(problems_of_text(text).find("analysis 'budget' is of solids: body 'beam' is of theory 'euler-bernoulli'"),
            std::string::npos)
      << problems_of_text(text);
}

TEST(ReadProfile, replaces_what_it_states_and_nothing_else) {
  const std::string text = with_profile(R"(duration = 0.2
resolution = { cylinder = { degree = 2, cells = [1, 2] } }
finer = { degree = 3, cells = [1, 2] }
coarser = { degree = 2, cells = [1, 4] }
modes = [0, 32, 128, 256]
rival = []
[[profile.quick.stepping]]
integrator = "newmark"
methods = ["full"]
time_steps = [0.1]
)");
  const Scene quick = test::read(text), standard = test::read(text, "standard");
  EXPECT_EQ(quick.duration, 0.2);
  EXPECT_EQ(quick.bodies[0].resolution, (Resolution{2, {1, 2}}));
  EXPECT_EQ(quick.truth.finer, (Resolution{3, {1, 2}}));
  EXPECT_EQ(quick.truth.coarser, (Resolution{2, {1, 4}}));
  EXPECT_EQ(quick.study.modes, (std::vector<int>{0, 32, 128, 256}));
  EXPECT_TRUE(quick.study.rivals.empty());
  EXPECT_EQ(quick.study.steppings.size(), 1u);
  EXPECT_EQ(quick.study.methods, standard.study.methods);
  const Scene original = test::read(cylinder_text(), "standard");
  EXPECT_EQ(canonical(standard), canonical(original));
  EXPECT_EQ(standard.study.modes, original.study.modes);
  EXPECT_EQ(standard.study.rivals.size(), 1u);
  EXPECT_TRUE(standard.study.steppings.empty());
}

TEST(ReadProfile, replaces_contenders_of_two_bodies) {
  const std::string text = test::content(test::cases_folder() / "ball-on-two-by-four.toml");
  const Scene quick = test::read(text), full = test::read(text, "full");
  ASSERT_EQ(quick.study.rivals.size(), 1u);
  ASSERT_EQ(full.study.rivals.size(), 2u);
  EXPECT_EQ(quick.study.rivals[0].second_cells, full.study.rivals[0].second_cells);
  EXPECT_LT(quick.study.rivals[0].time_steps.size(), full.study.rivals[0].time_steps.size());
}

TEST(ReadProfile, is_checked_whichever_is_asked_for) {
  const std::string text = with(cylinder_text(), "[profile.full]\n", "[profile.full]\nmodes = [4500, 5000]\n");
  for (const char* profile : {"quick", "standard", "full"}) {
    EXPECT_THROW(test::read(text, profile), CaseErrors) << profile;
  }
}

TEST(ReadProfile, runs_what_the_checks_ask_for) {
  const std::string text = with_one_check(with_profile("modes = [32]"));
  EXPECT_EQ(problems_of_text(text), "");
  EXPECT_NE(problems_of_text(with_one_check(with_profile("modes = [31]"))).find("profile quick does not run 32 modes"),
            std::string::npos);
}

TEST(ReadProfile, has_checks_of_its_own) {
  const std::string check = R"(
[[check]]
method = "static-correction"
metric = "displacement-error"
truth = "same_mesh"
modes = 32
why = "For a test."
)";
  const std::string text = with_one_check(cylinder_text()) + check + "at_least = 1e-9\nprofiles = [\"quick\"]\n" +
                           check + "at_least = 1e-6\nprofiles = [\"standard\", \"full\"]\n";
  const size_t n = test::read(with_one_check(cylinder_text())).checks.size();
  for (const char* profile : {"quick", "standard", "full"}) {
    const auto checks = test::read(text, profile).checks;
    ASSERT_EQ(checks.size(), n + 1) << profile;
    EXPECT_EQ(checks.back().at_least, profile == std::string("quick") ? 1e-9 : 1e-6) << profile;
  }
}

// What the study runs in one profile alone may be asked of that one.
TEST(ReadProfile, is_asked_for_what_it_runs_itself) {
  const std::string text = with_one_check(with_profile("modes = [31]"));
  EXPECT_EQ(problems_of_text(with(text, "modes   = 32\n", "modes   = 32\nprofiles = [\"standard\", \"full\"]\n")), "");
}

TEST(ReadCheck, of_a_table_names_a_column_and_perhaps_a_row) {
  const std::string text = with(with_one_check(cylinder_text()), "[study]\n", "[study]\nanalyses = [\"budget\"]\n");
  const auto check = test::read(text + R"(
[[check]]
table = "budget"
column = "truncation"
row = "16"
at_least = -3
reference = "a book"
kind = "published"
why = "For a test."
)")
                         .checks.back();
  EXPECT_EQ(check.table + ", " + check.column + ", " + check.row, "budget, truncation, 16");
  EXPECT_EQ(check.at_least, -3);
  EXPECT_EQ(check.reference + ", " + check.kind, "a book, published");
}

TEST(ReadCheck, of_a_method_without_mode_count_has_none) {
  std::string text = with(with_one_check(cylinder_text()), R"(["eigenmodes", "static-correction"])",
                          R"(["static-correction", "linear"])");
  text +=
      "\n[[check]]\nmethod = \"linear\"\nmetric = \"strain-error\"\ntruth = \"finer\"\nat_most = 1\nwhy = \"Low.\"\n";
  EXPECT_EQ(test::read(text).checks.back().modes, 0);
}

TEST(ReadCheck, of_stepped_runs_names_integrator_and_step) {
  const std::string text = with_one_check(cylinder_text()) + R"(
[[check]]
method     = "full-order"
integrator = "newmark"
time_step  = 0.004166666666666667
status     = "unstable"
why = "For a test."
[[check]]
method = "full-order"
metric = "displacement-error"
truth  = "finer"
at_most = 1
why = "Of all rivals."
)";
  const std::vector<Check> checks = test::read(text).checks;
  const Check& of_one = checks.at(checks.size() - 2);
  EXPECT_EQ(runs_of(of_one), "full-order newmark dt=0.00416667 s");
  EXPECT_EQ(of_one.status, "unstable");
  EXPECT_FALSE(of_one.at_most || of_one.at_least);
  EXPECT_EQ(runs_of(checks.back()), "full-order");
  EXPECT_EQ(runs_of(checks.front()), "static-correction r=32");
}

TEST(ReadTruth, a_closed_form_must_hold_for_the_scene) {
  const std::string text = with(cylinder_text(), "[truth]\n", "[truth]\nexact = \"rod-step\"\n");
  Scene scene = test::read(cylinder_text());
  EXPECT_EQ(closed_form_problem(scene), "") << "none is named";
  scene.truth.exact = "rod-step";
  const std::string why_not = closed_form_problem(scene);
  ASSERT_FALSE(why_not.empty()) << "a cylinder is no rod of square section";
  EXPECT_NE(problems_of_text(text).find(": error: " + why_not + "\n"), std::string::npos);
  const Scene rod = read_toml(test::cases_folder() / "rod-step.toml", test::vocabulary());
  EXPECT_EQ(rod.truth.exact, "rod-step");
}

TEST(ReadReference, frequencies_ascend_with_their_multiplets) {
  const std::string text = with(cylinder_text(), "[study]\n",
                                "[reference_frequencies]\nhertz = [10, 10, 12.5]\nuncertainty = 1e-8\n[study]\n");
  EXPECT_EQ(test::read(text).reference_frequencies.hertz, (std::vector<double>{10, 10, 12.5}));
  EXPECT_EQ(test::read(text).reference_frequencies.uncertainty, 1e-8);
  EXPECT_NE(problems_of_text(with(text, "12.5]", "9]")).find("must ascend: 9 follows 10"), std::string::npos);
}

}  // namespace
}  // namespace mb
