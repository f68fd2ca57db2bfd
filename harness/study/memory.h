// Whether what is to be computed fits the machine, asked before anything is allocated.
#pragma once

#include <exception>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace mb {

// [byte] What this process may still take, the least of:
//
//   MemAvailable of /proc/meminfo
//   memory.max - (memory.current - inactive files) of its control group (/proc/self/cgroup) and of each above it
//   its own limit of address space - what it has of it
//
// Nothing where the system does not tell. root: where /proc and /sys are.
std::optional<double> available_memory(const std::filesystem::path& root = "/");

// Throws std::runtime_error with both numbers [byte] where more is needed (estimate.h) than is available.
void require_memory(double needed, std::optional<double> available);

// Of n processes at most, >= 1, so many that each may take the largest of what is needed [byte], as far as that fits at
// all: what fits alone must not be refused because another process runs.
int processes_that_fit(int n, const std::vector<double>& needed, std::optional<double> available);

// What an exception says; of std::bad_alloc, which says its name alone, what was estimated [byte] and what is there.
std::string failure_text(const std::exception& error, double estimated);

// Whether that is what a failure says of itself: what failed for want of memory may have it another time.
bool is_shortage(const std::string& failure);

}  // namespace mb
