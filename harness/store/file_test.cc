#include "harness/store/file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <exception>
#include <future>
#include <random>
#include <thread>

#include "harness/store/scratch_folder_test.h"

namespace mb {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

std::ptrdiff_t n_files(const std::filesystem::path& folder) {
  return std::distance(std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator());
}

// No file may grow beyond `size` while this lives: the disk is full.
class FullDisk {
 public:
  explicit FullDisk(rlim_t size) : action_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{size, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, action_);
  }

 private:
  rlimit before_{};
  void (*action_)(int);
};

TEST(File, ContentComesBackFromAFolderThatIsMade) {
  const ScratchFolder folder;
  const std::string content("a\0b\nc", 5);
  write_file(folder / "deep/er/file", content);
  EXPECT_EQ(read_file(folder / "deep/er/file", 5), content);
  write_file(folder / "deep/er/file", "");
  EXPECT_EQ(read_file(folder / "deep/er/file", 0), "");
  EXPECT_EQ(n_files(folder / "deep/er"), 1);  // no temporary file remains
}

TEST(File, TheUmaskSaysWhoMayRead) {
  namespace fs = std::filesystem;
  const ScratchFolder folder;
  const mode_t before = ::umask(077);
  write_file(folder / "mine/file", "x");
  ::umask(022);
  write_file(folder / "ours/file", "x");
  ::umask(before);
  EXPECT_EQ(fs::status(folder / "mine/file").permissions(), fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(fs::status(folder / "mine").permissions(), fs::perms::owner_all);
  EXPECT_EQ(fs::status(folder / "ours/file").permissions(),
            fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read | fs::perms::others_read);
}

TEST(File, WhatMustBeDoneBeforeIsDoneOnceTheContentIsOnTheDisk) {
  const ScratchFolder folder;
  write_file(folder / "file", "old");
  write_file(folder / "file", "new", [&] {
    EXPECT_EQ(read_file(folder / "file", 9), "old");
    EXPECT_EQ(n_files(folder.path()), 2);
  });
  EXPECT_EQ(read_file(folder / "file", 9), "new");
  const auto fails = [] { throw StoreError("other", "cannot be removed"); };
  EXPECT_THROW(write_file(folder / "file", "newer", fails), StoreError);
  EXPECT_EQ(read_file(folder / "file", 9), "new");
  EXPECT_EQ(n_files(folder.path()), 1);
  remove_file(folder / "file");
  remove_file(folder / "file");
  EXPECT_EQ(n_files(folder.path()), 0);
  std::filesystem::create_directory(folder / "folder");
  EXPECT_THROW(remove_file(folder / "folder"), StoreError);
}

TEST(File, AFullDiskIsToldAndTheOldFileStands) {
  const ScratchFolder folder;
  write_file(folder / "file", "old");
  {
    const FullDisk full(4096);
    EXPECT_THAT(
        [&] { write_file(folder / "file", std::string(100000, 'x')); },
        ThrowsMessage<StoreError>(AllOf(HasSubstr((folder / "file").string()), HasSubstr("cannot be written"))));
  }
  EXPECT_EQ(read_file(folder / "file", 100), "old");
  EXPECT_EQ(n_files(folder.path()), 1);
}

// At moments drawn with a fixed seed: the file is whole, one or the other.
TEST(File, AWriterThatIsKilledLeavesAWholeFile) {
  const ScratchFolder folder;
  const std::filesystem::path file = folder / "file";
  const std::string contents[] = {std::string(2000000, 'a'), std::string(3000000, 'b')};
  write_file(file, contents[0]);
  std::mt19937 random(7);
  for (int i = 0; i < 15; ++i) {
    const pid_t writer = ::fork();
    ASSERT_GE(writer, 0);
    if (writer == 0)
      for (int k = 0;; ++k) write_file(file, contents[k % 2]);
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 20000));
    ::kill(writer, SIGKILL);
    ::waitpid(writer, nullptr, 0);
    const std::string found = read_file(file, 1 << 22);
    EXPECT_TRUE(found == contents[0] || found == contents[1]) << i;
  }
}

TEST(File, AFolderHasOneHolderAtATimeHoweverThatEnds) {
  const ScratchFolder folder;
  auto lock = std::make_unique<FolderLock>(folder / "store");
  auto waiting = std::async(std::launch::async, [&] { const FolderLock second(folder / "store"); });
  EXPECT_EQ(waiting.wait_for(std::chrono::milliseconds(50)), std::future_status::timeout);
  lock.reset();
  waiting.get();
  const pid_t holder = ::fork();
  ASSERT_GE(holder, 0);
  if (holder == 0) {
    const FolderLock held(folder / "store");
    write_file(folder / "held", "");
    for (;;) ::pause();
  }
  while (!std::filesystem::exists(folder / "held")) std::this_thread::yield();
  ::kill(holder, SIGKILL);
  ::waitpid(holder, nullptr, 0);
  const FolderLock after(folder / "store");
  write_file(folder / "file", "x");
  EXPECT_THROW(FolderLock(folder / "file"), StoreError);
}

TEST(File, AFolderThatCannotBeLockedIsTold) {
  const ScratchFolder folder;
  rlimit before{};
  ::getrlimit(RLIMIT_NOFILE, &before);
  const rlimit none{0, before.rlim_max};
  std::exception_ptr thrown;
  ::setrlimit(RLIMIT_NOFILE, &none);
  try {
    const FolderLock lock(folder.path());
  } catch (...) {
    thrown = std::current_exception();
  }
  ::setrlimit(RLIMIT_NOFILE, &before);  // before anything is looked at: sanitizers open files to do so
  ASSERT_TRUE(thrown);
  EXPECT_THAT([&] { std::rethrow_exception(thrown); },
              ThrowsMessage<StoreError>(AllOf(HasSubstr("cannot be opened to be locked"), HasSubstr("open files"))));
  EXPECT_NO_THROW(FolderLock(folder.path()));
}

TEST(File, AFolderThatCannotBeWrittenIsTold) {
  const ScratchFolder folder;
  write_file(folder / "file", "x");
  EXPECT_THROW(write_file(folder / "file/below", "y"), StoreError);
  EXPECT_THROW(write_file("/proc/modalbench", "y"), StoreError);
  std::filesystem::create_directory(folder / "taken");
  EXPECT_THROW(write_file(folder / "taken", "y"), StoreError);
  EXPECT_EQ(n_files(folder.path()), 2);
}

TEST(File, WhatIsNoFileOrTooLargeIsNotRead) {
  const ScratchFolder folder;
  write_file(folder / "file", "12345");
  EXPECT_THAT([&] { read_file(folder / "file", 4); }, ThrowsMessage<StoreError>(HasSubstr("larger than 4 bytes")));
  EXPECT_THROW(read_file(folder / "missing", 4), StoreError);
  EXPECT_THROW(read_file(folder.path(), 4), StoreError);
  EXPECT_THROW(read_file("/dev/zero", 4), StoreError);
  try {
    read_file(folder / "missing", 4);
  } catch (const StoreError& error) {
    EXPECT_EQ(error.file(), folder / "missing");
  }
}

}  // namespace
}  // namespace mb
