// Where linear theory is left, a run and its report say so.
#include <gmock/gmock.h>

#include "harness/program_test.h"
#include "harness/store/scratch_folder_test.h"

namespace mb {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

// A cylinder strained by two per cent, and by two thousandths.
TEST(LinearTheoryCases, WarnWhereItIsLeft) {
  const ScratchFolder scratch;
  fs::create_directory(scratch / "cases");
  std::string little = small_case();
  for (const std::string load : {"-400", "400"})
    little.replace(little.find("0, 0, " + load + "]"), 7 + load.size(),
                   "0, 0, " + load.substr(0, load.size() - 1) + "]");
  const char* const warned = "body: strain 0.0";
  for (const bool beyond : {true, false}) {
    written(scratch / "cases/small.toml", beyond ? small_case() : little);
    const std::string store = beyond ? "beyond" : "within";
    const Said said = modalbench(scratch.path(), {"run", "small", "--untimed", "--store", store});
    EXPECT_EQ(said.code, 0) << said.err;
    EXPECT_EQ(said.err.find(std::string("warning: small · ") + warned) != std::string::npos, beyond) << said.err;
    EXPECT_EQ(modalbench(scratch.path(), {"report", "--store", store}).code, 0);
    EXPECT_EQ(text(scratch / "report/report.md").find(std::string("Warning: ") + warned) != std::string::npos, beyond);
  }
}

// Of the hard case, whose truths are of finite strain: a strain of 0.068 and a rotation of 0.509 rad.
TEST(LinearTheoryCases, OfTheHardCaseStrainAndRotationAreSaid) {
  const ScratchFolder scratch;
  const std::string all = text(fs::path(MB_SOURCE_DIR) / "cases/hard/beyond-linear.toml");
  written(scratch / "case.toml",
          all.substr(0, all.find("[study]")) + "[study]\nmethods = [\"eigenmodes\"]\nmodes = [4]\n[end]\n");
  const Said said = modalbench(scratch.path(), {"run", "case.toml", "--untimed"});
  EXPECT_EQ(said.code, 0) << said.err;
  const auto warns = AllOf(HasSubstr("strip: strain 0.068"), HasSubstr("strip: rotation 0.50"));
  EXPECT_THAT(said.err, AllOf(HasSubstr("warning: beyond-linear"), warns));
  EXPECT_EQ(modalbench(scratch.path(), {"report", "case.toml"}).code, 0);
  EXPECT_THAT(text(scratch / "report/report.md"), warns);
}

}  // namespace
}  // namespace mb
