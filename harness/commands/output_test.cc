// Output that cannot be written, and names that are wrong among others that are not.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <iostream>

#include "cases/json/json.h"
#include "harness/program_test.h"
#include "harness/store/scratch_folder_test.h"

namespace mb {
namespace {

using ::testing::HasSubstr;

// The program with a full disk in the place of its output.
Said onto_a_full_disk(const fs::path& folder, std::vector<std::string> words) {
  words.insert(words.begin(), "modalbench");
  std::vector<char*> argv;
  for (auto& word : words) argv.push_back(word.data());
  const fs::path before = fs::current_path();
  fs::current_path(folder);
  std::cout.flush(), std::fflush(stdout);
  const int output = ::dup(STDOUT_FILENO), full = ::open("/dev/full", O_WRONLY);
  ::dup2(full, STDOUT_FILENO);
  ::testing::internal::CaptureStderr();
  const int code = harness_main(static_cast<int>(argv.size()), argv.data(), default_catalogue());
  ::dup2(output, STDOUT_FILENO);
  ::close(output), ::close(full);
  std::cout.clear(), std::clearerr(stdout);
  fs::current_path(before);
  return {code, "", ::testing::internal::GetCapturedStderr()};
}

TEST(OutputTest, AFullDiskIsNoSuccess) {
  const ScratchFolder scratch;
  fs::create_directory(scratch / "cases");
  written(scratch / "cases/small.toml", small_case());
  for (const auto& words : {std::vector<std::string>{"list"},
                            {"check", "small"},
                            {"run", "small", "--plan", "--json"},
                            {"explain", "newmark"},
                            {"--help"}}) {
    const Said said = onto_a_full_disk(scratch.path(), words);
    EXPECT_EQ(said.code, 2) << words[0];
    EXPECT_THAT(said.err, HasSubstr("could not be written")) << words[0];
  }
  EXPECT_EQ(modalbench(scratch.path(), {"list"}).code, 0);
}

TEST(OutputTest, EveryFileIsCheckedAndEveryProblemTold) {
  const ScratchFolder scratch;
  written(scratch / "good.toml", small_case());
  written(scratch / "bad.toml", "schema = 1\nnme = \"x\"\n");
  const Said said = modalbench(scratch.path(), {"check", "bad.toml", "nosuch", "missing.toml", "good.toml"});
  EXPECT_EQ(said.code, 2);
  EXPECT_THAT(said.err, HasSubstr("unknown key 'nme'"));
  EXPECT_THAT(said.err, HasSubstr("unknown case 'nosuch'"));
  EXPECT_THAT(said.err, HasSubstr("missing.toml"));
  EXPECT_THAT(said.out, HasSubstr("small: valid"));
}

// A cylinder bends alike in two directions: pairs of one frequency beside single modes.
TEST(OutputCases, ModesSayHowManyShareAFrequency) {
  const ScratchFolder scratch;
  written(scratch / "small.toml", small_case());
  const Said said = modalbench(scratch.path(), {"modes", "small.toml", "--count", "12", "--json"});
  ASSERT_EQ(said.code, 0) << said.err;
  const Json json = parse_json(said.out);
  EXPECT_EQ(json["schema"], 3);
  int n_pairs = 0, n_single = 0;
  for (const Json& mode : json["modes"]) {
    if (mode["kind"] == "rigid")
      EXPECT_EQ(mode["multiplicity"], 6);
    else
      n_pairs += mode["multiplicity"] == 2, n_single += mode["multiplicity"] == 1;
  }
  EXPECT_GE(n_pairs, 2);
  EXPECT_GE(n_single, 1);
}

}  // namespace
}  // namespace mb
