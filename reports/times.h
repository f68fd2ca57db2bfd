// How far a time can be trusted, and which times may be compared.
//
//   busy = processor time / wall-clock time;   t +- s taken at that share lies in [busy (t - s), t + s]
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "cases/contract/record.h"

namespace mb {

inline constexpr double busy_enough = 0.9;  // [-] below it a time is called perturbed

bool is_time(const Record& record);     // its metric is named ...-time and no truth grades it
double busy_share(const Record& time);  // [-] in (0, 1]; 1 where it was not recorded, or is at least busy_enough
bool is_perturbed(const Record& time);  // something else had the core for more than a tenth of it

struct TimeRange {
  double low, high;  // [s]; both NaN for a single run, which has no spread
};
TimeRange range_of(const Record& time);

using Machine = std::array<std::string, 3>;               // processor, BLAS, threads
using CaseProfile = std::pair<std::string, std::string>;  // names of both
Machine machine_of(const Record& record);

// Of every case and profile the machine that took most of its times: only those are compared.
std::map<CaseProfile, Machine> machines_compared(const std::vector<Record>& records);
long count_times_left_out(const std::vector<Record>& records);  // taken on others

}  // namespace mb
