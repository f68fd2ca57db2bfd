// A trajectory as named matrices, counts and texts: the layout of trajectory_file.h.
#pragma once

#include <string>

#include "cases/contract/method.h"
#include "harness/store/hdf5.h"

namespace mb {

inline constexpr int trajectory_schema = 1;
inline constexpr double trajectory_tolerance = 1e-12;  // [-] of the largest singular value of a body's displacement

// Of all but the text `checksum`: names, units, sizes, values to the last bit. It finds damage, it stops no forger.
std::string checksum_of(const Hdf5Content& content);

// All that a trajectory holds, times, displacements, strains and contact: what is written as factors counts whole.
Index n_values(const Trajectory& trajectory);

// Throws std::invalid_argument where there are more than hdf5_max_elements values or 64 bodies, sizes do not agree,
// times do not ascend or a number is not finite, but for the end of a touch that lasts.
Hdf5Content content_of(const Trajectory& trajectory);

// Throws std::runtime_error with one sentence that names the fault, at least where content_of throws: what it makes is
// read. The content may come from anywhere, its checksum with it.
Trajectory trajectory_of(const Hdf5Content& content);

}  // namespace mb
