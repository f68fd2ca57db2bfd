// The program starved of disk and shut out: what it has finished stays, nothing is left half-written, and what cannot
// be written is said with the system's reason, exit code 2.
#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>

#include "harness/faults_test.h"

namespace mb {
namespace {

using namespace faults;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;

// A file system of so many KiB at a folder, for this test and what it starts: nobody else sees it, and it goes with the
// process. Takes a right that containers seldom give.
class TinyDisk {
 public:
  TinyDisk(const fs::path& folder, int kibibytes) : folder_(folder) {
    fs::create_directories(folder);
    const std::string size = "size=" + std::to_string(kibibytes) + "k";
    mounted_ = ::unshare(CLONE_NEWNS) == 0 && ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
               ::mount("tmpfs", folder.c_str(), "tmpfs", 0, size.c_str()) == 0;
  }
  ~TinyDisk() {
    if (mounted_) ::umount2(folder_.c_str(), MNT_DETACH);
  }
  TinyDisk(const TinyDisk&) = delete;
  TinyDisk& operator=(const TinyDisk&) = delete;
  bool is_mounted() const { return mounted_; }
  bool becomes_read_only() const {
    return ::mount("tmpfs", folder_.c_str(), "tmpfs", MS_REMOUNT | MS_RDONLY, nullptr) == 0;
  }

 private:
  fs::path folder_;
  bool mounted_ = false;
};

// For a process to be: no file of it grows beyond so many bytes.
std::function<void()> with_files_up_to(rlim_t size) {
  return [size] {
    const rlimit limit{size, RLIM_INFINITY};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  };
}

// Root may write anywhere.
void become_another_user() {
  if (::geteuid() == 0 && (::setgid(65534) != 0 || ::setuid(65534) != 0)) ::_exit(125);
}
bool could_not_become(int code) { return code == 125 || code == 127; }

// What stands below a folder, by path.
std::map<std::string, std::string> all_files(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files[fs::relative(entry.path(), folder)] = text(entry.path());
  return files;
}

TEST(FullDiskCases, FilesThatMayNotGrowLeaveTheStoreWhole) {
  const ScratchFolder scratch;
  written(scratch / "case.toml", analysed_case());
  for (const rlim_t size : {0, 3000, 20000}) {
    Process process(scratch.path(), run, with_files_up_to(size));
    EXPECT_EQ(process.code(), 2) << size;
    if (size > 0) {  // else not even its own message arrives
      EXPECT_THAT(process.err(), ContainsRegex("results/.*: cannot be written: File too large"));
    }
    expect_sound(scratch / "results");
    expect_nothing_half_written(scratch / "results");
  }
  Process process(scratch.path(), run);
  EXPECT_EQ(process.code(), 0) << process.err();
}

TEST(FullDiskCases, ADiskWithoutSpaceLeavesTheStoreWhole) {
  const ScratchFolder scratch;
  written(scratch / "case.toml", analysed_case());
  for (const int kibibytes : {4, 24, 64}) {
    const TinyDisk disk(scratch / "disk", kibibytes);
    if (!disk.is_mounted()) GTEST_SKIP() << "a disk may not be mounted here; files that may not grow stand for it";
    Process process(scratch.path(), run_with({"--store", "disk/results"}));
    EXPECT_EQ(process.code(), 2) << kibibytes << process.err();
    EXPECT_THAT(process.err(), ContainsRegex("disk/results/.*: cannot be written: No space left on device"));
    expect_sound(scratch / "disk/results");
    expect_nothing_half_written(scratch / "disk/results");
  }
}

TEST(FullDiskCases, AReportThatFindsNoSpaceLeavesTheOneBefore) {
  const ScratchFolder scratch;
  written(scratch / "case.toml", analysed_case());
  Process computed(scratch.path(), run);
  ASSERT_EQ(computed.code(), 0) << computed.err();
  Process reported(scratch.path(), {"report", "-o", "old", "-q", "case.toml"});
  ASSERT_EQ(reported.code(), 0) << reported.err();
  const auto before = all_files(scratch / "old");
  Process again(scratch.path(), {"report", "-o", "old", "-q", "case.toml"}, with_files_up_to(2000));
  EXPECT_EQ(again.code(), 2);
  EXPECT_THAT(again.err(), ContainsRegex("cannot write old/.*: File too large"));
  EXPECT_EQ(all_files(scratch / "old"), before);

  const TinyDisk disk(scratch / "disk", 16);
  if (!disk.is_mounted()) GTEST_SKIP() << "a disk may not be mounted here; files that may not grow stand for it";
  Process full(scratch.path(), {"report", "-o", "disk/new", "-q", "case.toml"});
  EXPECT_EQ(full.code(), 2);
  EXPECT_THAT(full.err(), ContainsRegex("cannot write disk/new/.*: No space left on device"));
  EXPECT_TRUE(all_files(scratch / "disk").empty());
}

TEST(FullDiskCases, ANewCaseThatFindsNoSpaceIsNotLeftInPart) {
  const ScratchFolder scratch;
  Process process(scratch.path(), {"new", "mine.toml"}, with_files_up_to(1000));
  EXPECT_EQ(process.code(), 2);
  EXPECT_THAT(process.err(), HasSubstr("mine.toml cannot be written"));
  EXPECT_FALSE(fs::exists(scratch / "mine.toml"));
}

TEST(FullDiskCases, AFolderThatMayNotBeWrittenIsToldWithTheReason) {
  const ScratchFolder scratch;
  fs::permissions(scratch.path(), fs::perms::all);
  written(scratch / "case.toml", analysed_case());
  fs::create_directory(scratch / "shut");
  fs::permissions(scratch / "shut",
                  fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_read | fs::perms::others_exec);
  Process computed(scratch.path(), run);
  ASSERT_EQ(computed.code(), 0) << computed.err();
  Process store(scratch.path(), run_with({"--store", "shut"}), become_another_user);
  const int code = store.code();
  if (could_not_become(code)) GTEST_SKIP() << "no other user to be, or the program is not theirs to read";
  EXPECT_EQ(code, 2);
  EXPECT_THAT(store.err(), HasSubstr("shut/probe"));  // before anything is computed
  EXPECT_THAT(store.err(), HasSubstr("Permission denied"));
  Process report(scratch.path(), {"report", "-o", "shut/report", "-q", "case.toml"}, become_another_user);
  EXPECT_EQ(report.code(), 2);
  EXPECT_THAT(report.err(), ContainsRegex("cannot make shut/report: Permission denied"));
}

// What is stored answers: nothing has to be written.
TEST(FullDiskCases, AWholeStoreIsReadWhereNothingMayBeWritten) {
  const ScratchFolder scratch;
  fs::permissions(scratch.path(), fs::perms::all);
  written(scratch / "case.toml", analysed_case());
  Process computed(scratch.path(), run);
  ASSERT_EQ(computed.code(), 0) << computed.err();
  const auto readable = fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_read | fs::perms::others_exec;
  for (const auto& entry : fs::recursive_directory_iterator(scratch / "results"))
    fs::permissions(entry.path(), readable);
  fs::permissions(scratch / "results", readable);
  Process again(scratch.path(), run, become_another_user);
  const int code = again.code();
  if (could_not_become(code)) GTEST_SKIP() << "no other user to be, or the program is not theirs to read";
  EXPECT_EQ(code, 0) << again.err();
  EXPECT_EQ(again.out(), computed.out());
  fs::permissions(scratch / "results", fs::perms::owner_all);
  for (const auto& entry : fs::recursive_directory_iterator(scratch / "results"))
    fs::permissions(entry.path(), fs::perms::owner_all);
}

// Of a disk that nobody may write to, whatever the permissions say.
TEST(FullDiskCases, ADiskThatIsReadOnlyIsToldAndItsStoreRead) {
  const ScratchFolder scratch;
  written(scratch / "case.toml", analysed_case());
  const TinyDisk disk(scratch / "disk", 16384);
  if (!disk.is_mounted()) GTEST_SKIP() << "a disk may not be mounted here; folders that are shut stand for it";
  Process computed(scratch.path(), run_with({"--store", "disk/results"}));
  ASSERT_EQ(computed.code(), 0) << computed.err();
  ASSERT_TRUE(disk.becomes_read_only());
  Process again(scratch.path(), run_with({"--store", "disk/results"}));
  EXPECT_EQ(again.code(), 0) << again.err();
  EXPECT_EQ(again.out(), computed.out());
  Process other(scratch.path(), run_with({"--store", "disk/other"}));
  EXPECT_EQ(other.code(), 2);
  EXPECT_THAT(other.err(), ContainsRegex("disk/other.*: Read-only file system"));
  Process report(scratch.path(), {"report", "--store", "disk/results", "-o", "disk/report", "-q", "case.toml"});
  EXPECT_EQ(report.code(), 2);
  EXPECT_THAT(report.err(), ContainsRegex("cannot make disk/report: Read-only file system"));
}

}  // namespace
}  // namespace mb
