// The door of HDF5: real matrices, counts and texts by name, as the bytes of an HDF5 1.10 file and back.
//
// Written: one dataset a matrix in the root group, little-endian doubles, shuffle and deflate, unit as an attribute;
// counts and texts are attributes of the root. The library works on memory alone: files are opened by
// harness/store/file. An Eigen column is a row of the dataset, so that a dataset's first index is the matrix' second.
//
// Compressed values may hold the signature of a refused structure (below) by chance, in a file of n bytes with
// probability p <= 1 - exp(-6 n / 2^32). Then the file is written again with a second shuffle, of stride k = 2 ... 64:
// byte i of a chunk goes beside byte i + k, so that each k puts other bytes side by side, even where they do not
// compress. The HDF5 library undoes it by itself, in other programs too. All fail with p^64, less than 1e-17 in a file
// of 512 MiB.
//
// Read: untrusted. Plugins are off, and all else than the above is refused before its data is touched: heaps, soft,
// external and user-defined links, groups, other types, external storage, virtual datasets, other filters (a file with
// external storage could read any file of the machine). Dimensions are checked before anything is allocated.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "mechanics/types.h"

namespace mb {

struct Hdf5Matrix {
  MatrixXd values;
  std::string unit;
};
struct Hdf5Content {
  std::map<std::string, long> counts;
  std::map<std::string, std::string> texts;
  std::map<std::string, Hdf5Matrix> matrices;
};

// For writing and reading alike: what is written can be read.
inline constexpr Index hdf5_max_objects = 1024;                         // matrices; counts and texts together
inline constexpr Index hdf5_max_elements = Index{1} << 26;              // of all matrices together: 512 MiB
inline constexpr std::size_t hdf5_max_name = 64, hdf5_max_text = 4096;  // [byte] at least 1

// Throws std::runtime_error where the library fails or names, counts or texts themselves hold such a signature,
// std::invalid_argument beyond the limits above.
std::string to_hdf5(const Hdf5Content& content);

// Throws std::runtime_error with one sentence that names the fault and, where there is one, the object.
Hdf5Content from_hdf5(std::string_view bytes);

// Files that the library holds open, and what is open in them: neither of the above leaves any behind. The library
// closes forgotten ones at the program's end, so that no leak would tell.
Index open_hdf5_objects();

bool hdf5_plugins_are_off();  // once any of the above was called: a filter of a file loads no library

}  // namespace mb
