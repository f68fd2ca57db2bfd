// Whether what is to be computed fits the machine, asked before anything is allocated.
#pragma once

#include <filesystem>
#include <optional>

namespace mb {

// [byte] What this process may still take: MemAvailable of /proc/meminfo, the control group's limit and its own limit
// of address space, whichever is least. Nothing where the system does not tell. root: where /proc and /sys are.
std::optional<double> available_memory(const std::filesystem::path& root = "/");

// Throws std::runtime_error with both numbers [byte] where more is needed (estimate.h) than is available.
void require_memory(double needed, std::optional<double> available);

}  // namespace mb
