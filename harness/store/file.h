// Whole files in and out. A file is either the old one or the new one, never half of it:
//
//   write to FILE.XXXXXX in the same folder, fsync, rename over FILE, fsync the folder
#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace mb {

// "FILE: fault". A damaged or unwritable file of the store; what it held must be computed again.
class StoreError : public std::runtime_error {
 public:
  StoreError(std::filesystem::path file, const std::string& fault);
  const std::filesystem::path& file() const { return file_; }

 private:
  std::filesystem::path file_;
};

// Makes the folder where it is missing. Throws StoreError with the system's reason (disk full, read-only, ...); the old
// file then stands untouched and no temporary one remains.
void write_file(const std::filesystem::path& file, std::string_view content);

// Throws StoreError for what is no regular file or is larger than max_size [bytes], before anything is allocated.
std::string read_file(const std::filesystem::path& file, std::uintmax_t max_size);

}  // namespace mb
