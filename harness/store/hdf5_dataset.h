// The data of a dataset, held against what its header says of it: version 1.10 of the library copies by the header's
// sizes, whatever a chunk unpacks to.
//
// HDF5 File Format Specification Version 3.0, sections IV.A.2.i (layout) and VII.C (fixed array).
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace mb {

inline constexpr std::uint64_t hdf5_max_chunk = 512 << 10;  // [byte] of the largest chunk, those of ours
// Of all datasets together: ours have 2048 and one for each that is small; the library takes 400 bytes for each.
inline constexpr std::uint64_t hdf5_max_chunks = 8192;

// What the messages of an object's header say.
struct Hdf5Dataset {
  std::vector<std::uint64_t> size;  // along each dimension, the largest that it may have
  std::uint64_t element = 0;        // [byte] of one value
  bool filtered = false, deflated = false;
  std::string_view layout;  // the message
};

// What reading will take, by the header alone. Whatever is too large for a number is the largest one.
struct Hdf5Extent {
  std::uint64_t values = 0, chunks = 0;
  std::uint64_t unpacked = 0;  // [byte] of all chunks, filled up beyond the dataset's edges
};

// The bytes [address, address + size) of a file. Throws std::runtime_error where it ends before.
std::string_view hdf5_at(std::string_view file, std::uint64_t address, std::uint64_t size);

// Throws std::runtime_error where the layout is of another kind or its chunks are larger or more than the above.
Hdf5Extent extent_of(const Hdf5Dataset& dataset);

// Throws std::runtime_error where it is not: every address within the file, every chunk of the size stated. Chunks are
// unpacked one by one: extent_of tells before how many.
void check_data(std::string_view file, const Hdf5Dataset& dataset);

}  // namespace mb
