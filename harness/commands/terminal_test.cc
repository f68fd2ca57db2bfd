// Whatever names files have and whatever a store or a case holds, what reaches the terminal prints: no escape sequence
// sets its title, colours it or moves its cursor.
#include <gmock/gmock.h>

#include <sstream>

#include "cases/json/json.h"
#include "cases/scene/printable.h"
#include "harness/program_test.h"
#include "harness/store/file.h"
#include "harness/store/hdf5.h"
#include "harness/store/scratch_folder_test.h"
#include "harness/store/seal.h"
#include "harness/store/store.h"
#include "harness/store/trajectory_content.h"
#include "harness/study/identity.h"
#include "harness/study/plan.h"

namespace mb {
namespace {

using ::testing::HasSubstr;

const std::string evil = "\x1b]0;PWNED\x07";

void expect_prints(const std::string& text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_EQ(printable(line, line.size()), line);
}

TEST(TerminalTest, NamesOfFilesPrint) {
  const ScratchFolder scratch;
  fs::create_directories(scratch / "cases");
  fs::create_directories(scratch / "results");
  written(scratch / ("cases/" + evil + ".toml"), "schema = 1\n");
  for (const auto& [words, told] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"clean"}, "is no valid case"},
           {{"check", "nope"}, "unknown case 'nope'; cases: "},
           {{"run", "PWNED"}, "unknown case 'PWNED'"},
           {{"run"}, "PWNED"},
           {{"list"}, "PWNED"},
           {{"explain", "PWNED"}, "unknown word 'PWNED'"}}) {
    const Said said = modalbench(scratch.path(), words);
    EXPECT_THAT(said.err, HasSubstr(told));
    expect_prints(said.err);
    expect_prints(said.out);
  }
}

TEST(TerminalTest, WordsOfTheCommandLinePrint) {
  const ScratchFolder scratch;
  for (const std::vector<std::string>& words : {std::vector<std::string>{"check", evil},
                                                {"list", evil},
                                                {"new", evil + ".toml"},
                                                {"run", "--profile", evil},
                                                {evil}}) {
    const Said said = modalbench(scratch.path(), words);
    EXPECT_NE(said.out + said.err, "") << words.front();
    expect_prints(said.err);
    expect_prints(said.out);
  }
}

// Sealed as by this program: the checksum says that the file is whole, not that it is honest.
TEST(TerminalTest, RecordsOfAStorePrint) {
  const ScratchFolder scratch;
  const Scene scene = read_toml(written(scratch / "small.toml", small_case()), default_catalogue().vocabulary());
  Record record;
  record.contender = contenders(scene, default_catalogue()).front();
  record.run = run_hash(scene, record.contender);
  record.case_name = "small", record.profile = "quick", record.metric = "displacement-error", record.unit = "-";
  record.truth = "same_mesh", record.status = "failed: HERE";
  std::string line = to_line(to_json(record));
  line.replace(line.find("HERE"), 4, "\\u001b]0;PWNED\\u0007");
  ASSERT_EQ(parse_json(line)["status"], "failed: " + evil);
  const fs::path file = scratch / ("results/records/" + record.run + ".jsonl");
  write_file(file, sealed(line + "\n"));
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"report", "small.toml"}, {"clean", "small.toml"}}) {
    const Said said = modalbench(scratch.path(), words);
    EXPECT_THAT(said.err, HasSubstr("'status' holds a character that does not print"));
    expect_prints(said.err);
    expect_prints(said.out);
  }
}

// A truth of a case that is not here, which `clean` would name.
TEST(TerminalTest, TrajectoriesOfAStorePrint) {
  const ScratchFolder scratch;
  written(scratch / "small.toml", small_case());
  Trajectory truth;
  truth.t = VectorXd{{0, 1}};
  truth.case_name = "elsewhere";
  const std::string hash(32, 'a');
  Store(scratch / "results").write_truth(hash, truth);
  const fs::path file = scratch / ("results/truth/" + hash + ".h5");
  for (const std::string& name : {truth.case_name, evil}) {
    Hdf5Content content = from_hdf5(read_file(file, 1 << 20));
    content.texts["case"] = name;
    content.texts["checksum"] = checksum_of(content);
    write_file(file, to_hdf5(content));
    const Said said = modalbench(scratch.path(), {"clean", "small.toml"});
    EXPECT_THAT(said.err + said.out,
                HasSubstr(name == evil ? "'case' is not a name" : "case 'elsewhere' is not found"));
    expect_prints(said.err);
    expect_prints(said.out);
  }
}

TEST(TerminalTest, ChecksOfACasePrint) {
  const ScratchFolder scratch;
  std::string text = small_case();
  text.replace(text.find("modes = [4, 12]"), 15, "modes = [4, 12]\nanalyses = [\"budget\"]");
  text += "[[check]]\ntable = \"budget\"\ncolumn = \"\\u001b]0;PWNED\\u0007\"\nat_most = 1\nwhy = \"w\"\n";
  written(scratch / "small.toml", text);
  const Said said = modalbench(scratch.path(), {"run", "small.toml"});
  EXPECT_EQ(said.code, 2);
  EXPECT_THAT(said.err, HasSubstr("U+001B, which does not print"));
  expect_prints(said.err);
}

}  // namespace
}  // namespace mb
