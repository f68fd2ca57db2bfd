#include "harness/store/trajectory_file.h"

#include <stdexcept>

namespace mb {

namespace {

constexpr std::uintmax_t max_file_size = std::uintmax_t{1} << 30;  // [bytes]

}  // namespace

void write_trajectory(const std::filesystem::path& file, const Trajectory& trajectory, const std::string& run) {
  Hdf5Content content = content_of(trajectory);
  if (!run.empty()) {
    content.texts["run"] = run;
    content.texts["checksum"] = checksum_of(content);
  }
  write_file(file, to_hdf5(content));
}

Trajectory read_trajectory(const std::filesystem::path& file, const std::string& run) {
  const std::string bytes = read_file(file, max_file_size);
  try {
    const Hdf5Content content = from_hdf5(bytes);
    if (const auto held = content.texts.find("run");
        !run.empty() && (held == content.texts.end() || held->second != run))
      throw std::runtime_error("holds the answer of another run than it is named after");
    return trajectory_of(content);
  } catch (const std::runtime_error& fault) {
    throw StoreError(file, fault.what());
  }
}

}  // namespace mb
