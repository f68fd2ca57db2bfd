#include "harness/study/memory.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

namespace mb {

namespace {

namespace fs = std::filesystem;

std::optional<double> number(const fs::path& file) {
  std::ifstream stream(file);
  std::string word;
  double value = 0;
  if (!(stream >> word) || std::from_chars(word.data(), word.data() + word.size(), value).ec != std::errc()) return {};
  return value;
}

// Counted in KiB.
std::optional<double> mem_available(const fs::path& root) {
  std::ifstream meminfo(root / "proc/meminfo");
  for (std::string line; std::getline(meminfo, line);) {
    std::istringstream words(line);
    std::string key;
    double kibibytes = 0;
    if (words >> key >> kibibytes && key == "MemAvailable:") return 1024 * kibibytes;
  }
  return {};
}

}  // namespace

std::optional<double> available_memory(const fs::path& root) {
  std::optional<double> available = mem_available(root);
  const auto bound = [&](double limit) { available = std::min(available.value_or(limit), std::max(0.0, limit)); };
  const auto limit = number(root / "sys/fs/cgroup/memory.max"), used = number(root / "sys/fs/cgroup/memory.current");
  if (limit && used) bound(*limit - *used);
  rlimit space{};
  if (::getrlimit(RLIMIT_AS, &space) == 0 && space.rlim_cur != RLIM_INFINITY)
    bound(static_cast<double>(space.rlim_cur));
  return available;
}

void require_memory(double needed, std::optional<double> available) {
  if (!available || needed <= *available) return;
  throw std::runtime_error(
      fmt::format("takes about {:.3g} GB of memory and {:.3g} GB are there; coarser meshes or fewer samples take less",
                  1e-9 * needed, 1e-9 * *available));
}

}  // namespace mb
