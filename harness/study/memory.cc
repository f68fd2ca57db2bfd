#include "harness/study/memory.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <new>
#include <sstream>
#include <stdexcept>

namespace mb {

namespace {

namespace fs = std::filesystem;

constexpr const char* shortage = "out of memory";  // as solvers say it, too

std::optional<double> number(const fs::path& file) {
  std::ifstream stream(file);
  std::string word;
  double value = 0;
  if (!(stream >> word) || std::from_chars(word.data(), word.data() + word.size(), value).ec != std::errc()) return {};
  return value;
}

// Of a file of lines "key value ...".
std::optional<double> number(const fs::path& file, const std::string& wanted) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    std::string key;
    double value = 0;
    if (words >> key >> value && key == wanted) return value;
  }
  return {};
}

// A folder of a control group, and how its version names things there.
struct Group {
  fs::path folder;
  const char *limit, *used, *inactive;
};
Group version_2(fs::path folder) { return {std::move(folder), "memory.max", "memory.current", "inactive_file"}; }
Group version_1(fs::path folder) {
  return {std::move(folder), "memory.limit_in_bytes", "memory.usage_in_bytes", "total_inactive_file"};
}

// From the process's own group up to the root, in each hierarchy that counts memory. Within a container the path may be
// the host's, which is not to be seen: the root stands for it then.
std::vector<Group> groups(const fs::path& root) {
  const fs::path base = root / "sys/fs/cgroup";
  std::vector<Group> all{version_2(base), version_1(base / "memory")};
  std::ifstream lines(root / "proc/self/cgroup");
  for (std::string line; std::getline(lines, line);) {  // "0::/a/b", "4:memory:/a/b"
    const auto first = line.find(':'), second = line.find(':', std::min(first, line.size() - 1) + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = "," + line.substr(first + 1, second - first - 1) + ",";
    const bool is_second = controllers == ",,";
    if (!is_second && controllers.find(",memory,") == std::string::npos) continue;
    const fs::path path = fs::path(line.substr(second + 1)).lexically_normal().relative_path();
    for (fs::path at = path; !at.empty(); at = at.parent_path())
      all.push_back(is_second ? version_2(base / at) : version_1(base / "memory" / at));
  }
  return all;
}

// What a group has left. Files that nobody looks at are given back where memory is short.
std::optional<double> left_in(const Group& group) {
  const auto limit = number(group.folder / group.limit), used = number(group.folder / group.used);
  if (!limit || !used) return {};
  const double inactive = number(group.folder / "memory.stat", group.inactive).value_or(0);
  return *limit - std::max(0.0, *used - inactive);
}

std::optional<double> left_of_address_space(const fs::path& root) {
  rlimit space{};
  if (::getrlimit(RLIMIT_AS, &space) != 0 || space.rlim_cur == RLIM_INFINITY) return {};
  const double pages = number(root / "proc/self/statm").value_or(0);
  return static_cast<double>(space.rlim_cur) - pages * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

}  // namespace

std::optional<double> available_memory(const fs::path& root) {
  std::optional<double> available;
  const auto bound = [&](std::optional<double> limit) {
    if (limit) available = std::max(0.0, std::min(available.value_or(*limit), *limit));
  };
  if (const auto kibibytes = number(root / "proc/meminfo", "MemAvailable:")) bound(1024 * *kibibytes);
  for (const Group& group : groups(root)) bound(left_in(group));
  bound(left_of_address_space(root));
  return available;
}

void require_memory(double needed, std::optional<double> available) {
  if (!available || needed <= *available) return;
  throw std::runtime_error(fmt::format(
      "{}: takes about {:.3g} GB of memory and {:.3g} GB are there; coarser meshes, fewer modes or samples take less",
      shortage, 1e-9 * needed, 1e-9 * *available));
}

bool is_shortage(const std::string& failure) { return failure.find(shortage) != std::string::npos; }

int processes_that_fit(int n, const std::vector<double>& needed, std::optional<double> available) {
  double largest = 0;
  for (const double one : needed)
    if (available && one <= *available) largest = std::max(largest, one);
  return largest > 0 ? static_cast<int>(std::clamp(std::floor(*available / largest), 1.0, static_cast<double>(n))) : n;
}

std::string failure_text(const std::exception& error, double estimated) {
  if (dynamic_cast<const std::bad_alloc*>(&error) == nullptr) return error.what();
  const auto available = available_memory();
  return fmt::format("{}: about {:.3g} GB were expected{}", shortage, 1e-9 * estimated,
                     available ? fmt::format(", {:.3g} GB are there", 1e-9 * *available) : "");
}

}  // namespace mb
