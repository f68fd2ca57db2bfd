// A trajectory as one HDF5 file, schema 1:
//
//   t[n_t] [s];  per body k  displacement[n_t, 3 p] [m]  and  strain[n_t, 6 p_volume] [-],  each either plain
//   (bodyK_displacement) or as amplitudes[n_t, rank] x shapes[rank, values], cut at 1e-12 of the largest singular value
// and of bodies in contact their contact history (contact_content.h)
//
// Work counts and status are attributes of the root, and so are the case's name, where it is known, the run whose
// answer it is, where it is stored under one, and a checksum of all other content, the last two compared on reading.
#pragma once

#include <filesystem>

#include "cases/contract/method.h"
#include "harness/store/file.h"
#include "harness/store/trajectory_content.h"

namespace mb {

// Throws StoreError where the file cannot be written, and std::invalid_argument where a value is not finite, naming it
// and its time, or where sizes do not agree: columns of displacement and strain are times (strain may have none). So it
// does where times do not ascend and where there is more than is read again (trajectory_content.h).
void write_trajectory(const std::filesystem::path& file, const Trajectory& trajectory, const std::string& run = "");

// Throws StoreError naming file and fault: truncated, altered, another schema, values that are not finite or too many
// (512 MiB at most), another run than the one asked for, or anything else that write_trajectory does not write. The
// file may come from anywhere.
Trajectory read_trajectory(const std::filesystem::path& file, const std::string& run = "");

}  // namespace mb
