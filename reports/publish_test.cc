#include "reports/publish.h"

#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <set>
#include <sstream>

#include "reports/content.h"
#include "reports/held_signals.h"
#include "reports/listed_files.h"
#include "reports/synthetic.h"

namespace mb {
namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

class Publish : public ::testing::Test {
 protected:
  void SetUp() override {
    directory_ = fs::path(::testing::TempDir()) /
                 (std::string("publish-") + ::testing::UnitTest::GetInstance()->current_test_info()->name() + "-" +
                  std::to_string(getpid()));  // of two builds' tests at once each has its own
    fs::remove_all(directory_);
  }
  void TearDown() override { fs::remove_all(directory_); }

  void put(const std::string& path, const std::string& text) {
    fs::create_directories((directory_ / path).parent_path());
    std::ofstream(directory_ / path) << text;
  }
  std::set<std::string> files() const {
    std::set<std::string> found;
    for (const auto& entry : fs::recursive_directory_iterator(directory_)) {
      if (!entry.is_directory()) found.insert(fs::relative(entry, directory_).string());
    }
    return found;
  }
  fs::path directory_;
};

TEST_F(Publish, WritesWhatItNamesAndAListOfIt) {
  const auto written = publish({{"report.md", "1"}, {"data/a.csv", "2"}}, directory_);
  EXPECT_EQ(written.size(), 3u);
  for (const fs::path& path : written) EXPECT_TRUE(fs::is_regular_file(path)) << path;
  EXPECT_THAT(files(), ::testing::ElementsAre("data/a.csv", "data/files.txt", "report.md"));
  EXPECT_EQ(read(directory_ / list_of_files), "report.md\ndata/a.csv\ndata/files.txt\n");
}

TEST_F(Publish, FilesOfTheReportBeforeGoAndAllOthersStay) {
  publish({{"report.md", "1"}, {"data/old.csv", "2"}, {"figures/old.vl.json", "3"}, {"figures/new.vl.json", "3"}},
          directory_);
  put("figures/old.svg", "drawn");
  put("figures/new.svg", "drawn");
  put("data/mine.csv", "kept");
  put("notes/mine.txt", "kept");
  publish({{"report.md", "4"}, {"figures/new.vl.json", "5"}}, directory_);
  EXPECT_THAT(files(), ::testing::ElementsAre("data/files.txt", "data/mine.csv", "figures/new.svg",
                                              "figures/new.vl.json", "notes/mine.txt", "report.md"));
  EXPECT_EQ(read(directory_ / "report.md"), "4");
  EXPECT_EQ(read(directory_ / "data/mine.csv"), "kept");
}

TEST_F(Publish, AReportThatCannotBeWrittenLeavesTheOneBeforeAsItWas) {
  publish({{"report.md", "before"}, {"data/a.csv", "before"}}, directory_);
  const std::string too_long(300, 'x');  // for a file name: fails once the others are written, as on a full disk
  EXPECT_THROW(publish({{"report.md", "after"}, {"data/" + too_long, "after"}}, directory_), PublishError);
  EXPECT_EQ(read(directory_ / "report.md"), "before");
  EXPECT_EQ(read(directory_ / "data/a.csv"), "before");
  EXPECT_THAT(files(), ::testing::ElementsAre("data/a.csv", "data/files.txt", "report.md"));  // nothing aside is left
}

// Found before the first file is replaced.
TEST_F(Publish, AFolderInTheWayLeavesTheReportBeforeAsItWas) {
  publish({{"report.md", "before"}, {"verification.md", "before"}}, directory_);
  fs::remove(directory_ / "verification.md");
  put("verification.md/mine.txt", "kept");
  EXPECT_THROW(publish({{"report.md", "after"}, {"verification.md", "after"}}, directory_), PublishError);
  EXPECT_EQ(read(directory_ / "report.md"), "before");
}

TEST_F(Publish, AListThatIsNoListIsNone) {
  publish({{"report.md", "1"}, {"data/a.csv", "2"}}, directory_);
  for (const std::string what : {"a pipe", "a folder", "a file without end"}) {
    fs::remove_all(directory_ / list_of_files);
    if (what == "a pipe") {
      ASSERT_EQ(mkfifo((directory_ / list_of_files).c_str(), 0600), 0);
    } else if (what == "a folder") {
      fs::create_directories(directory_ / list_of_files);
      EXPECT_THROW(publish({{"report.md", "3"}}, directory_), PublishError);
      continue;
    } else {
      fs::create_symlink("/dev/zero", directory_ / list_of_files);
    }
    publish({{"report.md", what}}, directory_);
    EXPECT_EQ(read(directory_ / "report.md"), what);
    EXPECT_TRUE(fs::exists(directory_ / "data/a.csv")) << "nobody said that it was the report's";
  }
}

TEST_F(Publish, WhatAnInterruptedReportLeftAsideGoes) {
  put(".unfinished-report.999999999/data/half.csv", "half");
  publish({{"report.md", "1"}}, directory_);
  EXPECT_THAT(files(), ::testing::ElementsAre("data/files.txt", "report.md"));
}

TEST_F(Publish, AListThatNamesOtherFilesRemovesNone) {
  publish({{"report.md", "1"}}, directory_);
  const std::string outside = directory_.string() + "-outside.csv";
  std::ofstream(outside) << "kept";
  put("data/sub/mine.csv", "kept");
  put("mine.cc", "kept");
  put("notes.md", "kept");
  put("tables/mine.csv", "kept");
  put("other/mine.csv", "kept");
  put("data/files.txt",
      "../" + fs::path(outside).filename().string() + "\n" + outside +
          "\ndata/../mine.cc\ndata/sub/mine.csv\nmine.cc\nother/mine.csv\ndata\n\n..\nnotes.md\ntables/mine.csv\n");
  publish({{"report.md", "2"}}, directory_);
  EXPECT_TRUE(fs::exists(outside));
  fs::remove(outside);
  EXPECT_THAT(files(), ::testing::ElementsAre("data/files.txt", "data/sub/mine.csv", "mine.cc", "notes.md",
                                              "other/mine.csv", "report.md", "tables/mine.csv"));
}

// A name ends where the file system ends it, at NUL; others' names have blanks and further dots.
TEST_F(Publish, AListWithNamesThatNoReportGivesRemovesNone) {
  using namespace std::string_literals;
  publish({{"report.md", "1"}}, directory_);
  for (const char* mine : {"data/mine.odt", "data/my notes.csv", "data/mine.old.csv", "figures/mine", "figures/a.json"})
    put(mine, "kept");
  put("data/files.txt",
      "data/mine.odt\0.csv\ndata/my notes.csv\ndata/mine.old.csv\nfigures/mine\0.vl.json\nfigures/a.json\n"s);
  publish({{"report.md", "2"}}, directory_);
  EXPECT_THAT(files(), ::testing::ElementsAre("data/files.txt", "data/mine.odt", "data/mine.old.csv",
                                              "data/my notes.csv", "figures/a.json", "figures/mine", "report.md"));
}

TEST_F(Publish, EveryFileOfAReportIsOneThatTheNextMayRemove) {
  std::set<std::string> all;
  for (const fs::path& file : write_report(synthetic::input(), directory_))
    all.insert(file.lexically_relative(directory_).generic_string());
  EXPECT_EQ(listed_files(read(directory_ / list_of_files)), all);
}

int n_signals = 0;

TEST(HeldSignals, ComeWhenTheyAreNoLongerHeld) {
  const auto before = std::signal(SIGINT, [](int) { ++n_signals; });
  {
    const HeldSignals held;
    ::raise(SIGINT);
    EXPECT_EQ(n_signals, 0);
  }
  EXPECT_EQ(n_signals, 1);
  std::signal(SIGINT, before);
}

}  // namespace
}  // namespace mb
