#include "harness/store/trajectory_file.h"

#include <stdexcept>

namespace mb {

namespace {

constexpr std::uintmax_t max_file_size = std::uintmax_t{1} << 30;  // [bytes]

}  // namespace

void write_trajectory(const std::filesystem::path& file, const Trajectory& trajectory) {
  write_file(file, to_hdf5(content_of(trajectory)));
}

Trajectory read_trajectory(const std::filesystem::path& file) {
  const std::string bytes = read_file(file, max_file_size);
  try {
    return trajectory_of(from_hdf5(bytes));
  } catch (const std::runtime_error& fault) {
    throw StoreError(file, fault.what());
  }
}

}  // namespace mb
