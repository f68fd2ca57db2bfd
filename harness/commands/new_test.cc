// `modalbench new`: the template is a valid case, complete, and its comments serve schema and explain.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cases/json/json.h"
#include "cases/scene/read_scene.h"
#include "harness/commands/told_test.h"
#include "harness/commands/usage_error.h"
#include "harness/store/scratch_folder_test.h"

namespace mb {
namespace {

using test::told;
using ::testing::HasSubstr;

std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

test::Told write(const ScratchFolder& folder, const std::string& file) {
  return told(folder.path(), [&](const Console& c) { return new_command({.file = file}, default_catalogue(), c); });
}

TEST(NewTest, WritesAValidCaseInEveryProfile) {
  const ScratchFolder folder;
  const test::Told said = write(folder, "my-block.toml");
  EXPECT_EQ(said.code, 0);
  EXPECT_EQ(said.out, "my-block.toml\n");
  for (const char* profile : {"quick", "standard", "full"}) {
    const Scene scene = read_toml(folder / "my-block.toml", default_catalogue().vocabulary(), profile);
    EXPECT_EQ(scene.name, "my-block");
    EXPECT_EQ(scene.checks.size(), 1u);
  }
}

TEST(NewTest, NeverWritesOverAFile) {
  const ScratchFolder folder;
  std::ofstream(folder / "mine.toml") << "precious";
  EXPECT_THROW(write(folder, "mine.toml"), UsageError);
  EXPECT_EQ(text_of(folder / "mine.toml"), "precious");
  std::filesystem::create_symlink(folder / "elsewhere", folder / "link.toml");
  EXPECT_THROW(write(folder, "link.toml"), UsageError);
  EXPECT_FALSE(std::filesystem::exists(folder / "elsewhere"));
}

TEST(NewTest, RefusesNamesThatAreNoCaseFiles) {
  const ScratchFolder folder;
  for (const char* name : {"", "mine", "mine.txt", ".toml", "no-such-folder/mine.toml"})
    EXPECT_THROW(write(folder, name), UsageError) << name;
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(NewTest, AFileNameThatIsNoCaseNameLeavesTheTemplates) {
  const ScratchFolder folder;
  EXPECT_EQ(write(folder, "My Case.toml").code, 0);
  EXPECT_EQ(read_toml(folder / "My Case.toml", default_catalogue().vocabulary()).name, "my-case");
}

TEST(NewTest, TheSchemaKnowsTablesTypesAndWhatIsRequired) {
  const ScratchFolder folder;
  const auto said =
      told(folder.path(), [](const Console& c) { return new_command({.json_schema = true}, default_catalogue(), c); });
  EXPECT_EQ(said.code, 0);
  const Json schema = parse_json(said.out);
  const Json& body = schema["properties"]["body"];
  EXPECT_EQ(body["type"], "array");
  const Json& material = body["items"]["properties"]["material"];
  EXPECT_EQ(material["type"], "object");
  EXPECT_EQ(material["properties"]["density"]["type"], "number");
  EXPECT_THAT(material["properties"]["density"]["description"].get<std::string>(), HasSubstr("kg/m^3"));
  EXPECT_EQ(material["required"], Json::array({"density"}));  // moduli may be orthotropic
  EXPECT_EQ(body["items"]["properties"]["resolution"]["properties"]["degree"]["type"], "integer");
  const Json& load = schema["properties"]["load"]["items"]["properties"];
  EXPECT_EQ(load["traction"]["type"], "array");
  EXPECT_EQ(load["history"]["type"], "object");
  EXPECT_TRUE(load["history"]["properties"].contains("formula"));
  EXPECT_EQ(schema["properties"]["time"]["properties"]["frame_rate"]["type"], "number");
  EXPECT_TRUE(schema["properties"]["profile"]["properties"]["standard"]["properties"].contains("duration"));
  EXPECT_EQ(schema["properties"]["schema"]["type"], "integer");
}

}  // namespace
}  // namespace mb
