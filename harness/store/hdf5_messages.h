// Messages of HDF5's object headers, read within their own bounds: what each may say in a file of ours.
//
// HDF5 File Format Specification Version 3.0, section IV.A.2.
#pragma once

#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

namespace mb {

inline constexpr std::uint64_t hdf5_undefined = std::numeric_limits<std::uint64_t>::max();  // no address

// Throws std::runtime_error, of a damaged structure, where it does not hold.
void require_hdf5(bool holds, const char* what);

std::uint64_t hdf5_product(std::uint64_t a, std::uint64_t b);  // or the largest number where it is larger

// Bytes read from the front, never beyond their end; little-endian. Throws std::runtime_error there.
class Hdf5Cursor {
 public:
  explicit Hdf5Cursor(std::string_view bytes) : rest_(bytes) {}
  std::uint64_t number(std::size_t n_bytes);  // at most 8
  std::string_view take(std::uint64_t n_bytes);
  std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
};

// Throws std::runtime_error where the message is of another kind than stated here.
std::vector<std::uint64_t> sizes_of_dataspace(std::string_view message);  // largest ones, of at most three dimensions
std::uint64_t size_of_datatype(std::string_view message);                 // [byte]; plain integers, floats and texts
bool has_deflate(std::string_view message);  // of one or more filters: shuffle, and at most once, as the last, deflate
void check_group_info(std::string_view message);
void check_fill_value(std::string_view message);  // version 3, and none: the library copies by the size of its own
void check_attribute(std::string_view message);   // its type and space, too
// Link info and attribute info: everything stands in the header itself, in no heap. Size of the largest index [byte].
void check_no_heap(std::string_view message, std::size_t size_of_largest);

}  // namespace mb
