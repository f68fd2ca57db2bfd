// Whole files in and out. A file is either the old one or the new one, never half of it:
//
//   make the folder, fsync what it is in; write to FILE.XXXXXX there, fsync, rename over FILE, fsync the folder
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace mb {

// "FILE: fault". A damaged or unwritable file of the store; what it held must be computed again.
class StoreError : public std::runtime_error {
 public:
  StoreError(std::filesystem::path file, const std::string& fault);
  const std::filesystem::path& file() const { return file_; }
  const std::string& fault() const { return fault_; }

 private:
  std::filesystem::path file_;
  std::string fault_;
};

// Makes the folder where it is missing; permissions are those that the umask leaves. Throws StoreError with the
// system's reason (disk full, read-only, ...); the old file then stands untouched and no temporary one remains.
// before_rename: what must be done before the new content stands, and only once all of it is on the disk.
void write_file(const std::filesystem::path& file, std::string_view content,
                const std::function<void()>& before_rename = {});

// Gone for good when this returns; may be none. Throws StoreError.
void remove_file(const std::filesystem::path& file);

// One holder of a folder at a time, of threads and processes alike; waits for it. Free as soon as its holder ends,
// however that does. Makes the folder where it is missing; on file systems without locks nothing is held.
class FolderLock {
 public:
  explicit FolderLock(const std::filesystem::path& folder);  // throws StoreError where it cannot be had
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int fd_;
};

// Throws StoreError for what is no regular file or is larger than max_size [bytes], before anything is allocated.
std::string read_file(const std::filesystem::path& file, std::uintmax_t max_size);

}  // namespace mb
