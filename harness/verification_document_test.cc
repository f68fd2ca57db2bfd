// docs/verification.md is generated (CONTRIBUTING.md): whether it is of the cases as they are.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "cases/scene/read_toml.h"
#include "harness/catalogue.h"
#include "reports/check_cells.h"
#include "reports/render.h"

namespace mb {
namespace {

namespace fs = std::filesystem;

std::string document() {
  std::ifstream stream(fs::path(MB_SOURCE_DIR) / "docs/verification.md");
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

TEST(VerificationDocument, HoldsEveryCheckOfQuickAndOfHardCases) {
  const std::string text = document();
  ASSERT_FALSE(text.empty());
  const Vocabulary names = default_catalogue().vocabulary();
  int n_checks = 0;
  for (const char* folder : {"cases", "cases/hard"})
    for (const auto& entry : fs::directory_iterator(fs::path(MB_SOURCE_DIR) / folder)) {
      if (entry.path().extension() != ".toml") continue;
      const Scene scene = read_toml(entry.path(), names);
      if (scene.hard.empty() && std::ranges::count(scene.runs_in, "quick") == 0) continue;
      for (const Check& check : scene.checks) {
        const std::string cells = "| " + markdown_text(bound(check)) + " | " + markdown_text(check.why) + " |";
        EXPECT_NE(text.find(cells), std::string::npos)
            << scene.name << ": " << cells << "\ndocs/verification.md is out of date: make it anew";
        ++n_checks;
      }
    }
  EXPECT_GT(n_checks, 60);
}

}  // namespace
}  // namespace mb
