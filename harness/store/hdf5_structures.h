// Structures of the HDF5 file format that files of ours never need, found by their signatures before the library parses
// anything: heaps and B-trees. Virtual datasets, external storage, variable-length texts and large or old groups all
// need one, and version 1.10 of the library can be made to read beyond the ends of forged heaps.
//
// Signatures: HDF5 File Format Specification Version 3.0, sections III.A to III.H.
#pragma once

#include <string>
#include <string_view>

namespace mb {

// The name of the first one found; empty where there is none. Any four bytes may be a signature by chance.
std::string refused_structure(std::string_view hdf5_bytes);

// Without what stands behind the end of file that the superblock (version 2 or 3, section II.A) states: memory that
// the library allocated ahead. Throws std::runtime_error where the superblock is none or states a later end.
std::string whole_file(std::string_view hdf5_bytes);

// Names from outside are echoed only where they are plain: 'name', or "with a strange name".
std::string quoted(const std::string& name);

}  // namespace mb
