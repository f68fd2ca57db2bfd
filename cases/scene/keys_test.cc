// The documentation of the format against the reader: neither knows a key that the other does not.
#include "cases/scene/keys.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "cases/scene/case_files.h"

namespace mb {
namespace {

namespace fs = std::filesystem;

// What the reader asks for in any file of the source tree, right or wrong: path -> what it takes there.
const std::map<std::string, std::string>& asked() {
  static const std::map<std::string, std::string> all = [] {
    std::map<std::string, std::string> out;
    for (const fs::path& folder : {test::cases_folder(), test::cases_folder() / "hard", test::cases_folder() / "bad"}) {
      for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() != ".toml") continue;
        out.merge(keys_asked(test::content(entry.path()), folder, test::vocabulary()));
      }
    }
    return out;
  }();
  return all;
}

// What keys take depends on the case or on catalogues: there the documentation has words of its own.
bool depends_on_case(const std::string& documented) {
  static const std::set<std::string> such{"schema",
                                          "body.shape.kind",
                                          "body.kinematics",
                                          "body.support.face",
                                          "body.dashpot.face",
                                          "load.traction.face",
                                          "load.traction.body",
                                          "probe.body",
                                          "contact.body",
                                          "contact.obstacle",
                                          "contact.stiffness",
                                          "obstacle.rounding",
                                          "disc.centre",
                                          "disc.radius",
                                          "mesh.cells",
                                          "truth.exact",
                                          "study.rival.integrator",
                                          "study.stepping.integrator",
                                          "study.rival.time_steps",
                                          "study.stepping.time_steps",
                                          "check.method",
                                          "check.metric",
                                          "check.integrator"};
  return such.contains(documented);
}

std::string without_path(std::string what) {  // "a table [body.shape]" -> "a table"
  const std::size_t at = what.find(" [");
  if (what.starts_with("a table") || what.find(" tables [[") != std::string::npos) what.resize(at);
  return what;
}

TEST(Keys, every_key_that_the_reader_asks_for_is_documented_as_it_is_read) {
  ASSERT_GT(asked().size(), 100u);
  for (const auto& [path, what] : asked()) {
    if (path == "profile.quick" || path == "profile.standard" || path == "profile.full") continue;
    const KeyDoc* key = find_key(path);
    ASSERT_NE(key, nullptr) << path << ": " << what;
    if (depends_on_case(key->path)) continue;
    std::string expected = without_path(what);
    if (expected.starts_with("a name of")) expected = "a name";
    const bool of_acceleration = path.starts_with("body.support.acceleration.");  // [m/s^2] where a load's is a factor
    if (of_acceleration && expected.ends_with(" m/s^2")) expected.resize(expected.size() - 6);
    if (path.starts_with("check.at_") && expected == "a number in [-1e15, 1e15]") continue;  // of a table's column
    EXPECT_EQ(takes(*key), expected) << path;
  }
}

TEST(Keys, every_documented_key_is_one_that_the_reader_asks_for) {
  std::set<std::string> found;
  for (const auto& [path, what] : asked()) {
    if (const KeyDoc* key = find_key(path)) found.insert(key->path);
  }
  for (const KeyGroup& group : key_groups()) {
    for (const KeyDoc& key : group.keys) EXPECT_TRUE(found.contains(key.path)) << key.path;
  }
}

TEST(Keys, are_documented_once_and_in_one_line) {
  std::set<std::string> paths;
  for (const KeyGroup& group : key_groups()) {
    for (const KeyDoc& key : group.keys) {
      EXPECT_TRUE(paths.insert(key.path).second) << key.path;
      for (const std::string& text : {key.type, key.range, key.unit, key.fallback, key.meaning, key.example}) {
        EXPECT_EQ(text.find_first_of("\n|"), std::string::npos) << key.path;
      }
      EXPECT_FALSE(key.type.empty() || key.fallback.empty() || key.meaning.empty()) << key.path;
    }
  }
}

TEST(Keys, are_found_wherever_a_case_states_them) {
  const auto path_of = [](const char* path) { return find_key(path) == nullptr ? "" : find_key(path)->path; };
  EXPECT_EQ(path_of("load.history.omega"), "history.omega");
  EXPECT_EQ(path_of("body.support.acceleration.omega"), "history.omega");
  EXPECT_EQ(path_of("load.traction.disc.radius"), "disc.radius");
  EXPECT_EQ(path_of("profile.quick.duration"), "profile.NAME.duration");
  EXPECT_EQ(path_of("profile.full.rival.time_steps"), "study.rival.time_steps");
  EXPECT_EQ(path_of("profile.full.resolution.cylinder.degree"), "mesh.degree");
  EXPECT_EQ(path_of("truth.finer"), "truth.finer");
  for (const char* wrong :
       {"", ".", "body.", "density", "profile.overnight.duration", "history", "profile.full.finer."}) {
    EXPECT_EQ(find_key(wrong), nullptr) << wrong;
  }
}

TEST(CaseFolder, is_listed_whole_in_the_readme_and_reads) {
  const std::string readme = test::content(test::cases_folder() / "README.md");
  std::map<bool, int> n_cases;
  for (const bool hard : {false, true}) {
    for (const auto& entry : fs::directory_iterator(test::cases_folder() / (hard ? "hard" : ""))) {
      if (entry.path().extension() != ".toml") continue;
      EXPECT_NE(readme.find("| `" + entry.path().stem().string() + "` |"), std::string::npos) << entry.path();
      EXPECT_EQ(test::problems(entry.path()), "");
      EXPECT_EQ(test::content(entry.path()).find("\nhard") != std::string::npos, hard) << entry.path();
      ++n_cases[hard];
    }
  }
  EXPECT_GT(n_cases[false], 10);
  EXPECT_GT(n_cases[true], 2);
}

TEST(Keys, stand_in_the_readme_as_they_are) {
  const std::string readme = test::content(test::cases_folder() / "README.md");
  for (const KeyGroup& group : key_groups()) {
    const std::string section = "### " + group.title + "\n\n" + markdown_table(group);
    EXPECT_NE(readme.find(section), std::string::npos) << "cases/README.md lacks:\n" << section;
  }
}

TEST(Template, reads_and_names_every_key) {
  const std::string text = annotated_template();
  EXPECT_EQ(test::problems_of_text(text), "") << text;
  const Scene scene = test::read(text);
  EXPECT_EQ(scene.bodies.size(), 1u);
  EXPECT_EQ(scene.study.rivals.size(), 1u);
  EXPECT_EQ(scene.study.steppings.size(), 1u);
  EXPECT_EQ(scene.checks.size(), 1u);
  std::istringstream lines(text);
  std::string on_one_line;  // comments are broken at blanks
  for (std::string line; std::getline(lines, line);) {
    EXPECT_LE(line.size(), 120u);
    on_one_line += line.starts_with("#   ") ? line.substr(3) : "\n" + line;
  }
  for (const KeyGroup& group : key_groups()) {
    for (const KeyDoc& key : group.keys) {
      const bool is_header = text.find("[" + key.path + "]") != std::string::npos;
      EXPECT_TRUE(is_header || on_one_line.find(key.meaning) != std::string::npos) << key.path;
    }
  }
}

TEST(Template, has_no_key_that_may_be_left_out_unnoticed) {
  const std::string text = annotated_template();
  int n_required = 0;
  for (std::size_t at = 0; (at = text.find("; required: ", at)) != std::string::npos; ++at) {
    const std::size_t line = text.find('\n', at) + 1;
    if (text[line] == '#' || text[line] == '\n') continue;  // of a table that is left out
    std::string without = text;
    without.erase(line, text.find('\n', line) - line);
    EXPECT_NE(test::problems_of_text(without), "") << text.substr(line, text.find('\n', line) - line);
    ++n_required;
  }
  EXPECT_GT(n_required, 20);
}

}  // namespace
}  // namespace mb
