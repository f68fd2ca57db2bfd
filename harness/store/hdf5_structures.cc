#include "harness/store/hdf5_structures.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace mb {

std::string refused_structure(std::string_view hdf5_bytes) {
  constexpr std::array<std::pair<std::string_view, const char*>, 6> structures{{{"GCOL", "a global heap"},
                                                                                {"HEAP", "a local heap"},
                                                                                {"FRHP", "a fractal heap"},
                                                                                {"TREE", "a version 1 B-tree"},
                                                                                {"BTHD", "a version 2 B-tree"},
                                                                                {"SNOD", "an old group"}}};
  for (const auto& [signature, name] : structures) {
    if (hdf5_bytes.find(signature) != std::string_view::npos) {
      return std::string(name) + ", which files of this kind never need";
    }
  }
  return {};
}

std::string whole_file(std::string_view hdf5_bytes) {
  constexpr std::size_t size_of_superblock = 48, version_at = 8, end_at = 28;
  std::uint64_t end = 0;
  const bool has_superblock = hdf5_bytes.size() >= size_of_superblock && hdf5_bytes.starts_with("\x89HDF\r\n\x1a\n") &&
                              (hdf5_bytes[version_at] == 2 || hdf5_bytes[version_at] == 3);
  if (has_superblock) std::memcpy(&end, hdf5_bytes.data() + end_at, sizeof end);
  if (!has_superblock || end > hdf5_bytes.size()) throw std::runtime_error("not a whole HDF5 file");
  return std::string(hdf5_bytes.substr(0, end));
}

std::string quoted(const std::string& name) {
  const bool plain =
      std::ranges::all_of(name, [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; });
  return plain ? "'" + name + "'" : "with a strange name";
}

}  // namespace mb
