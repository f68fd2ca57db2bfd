#include "harness/store/hdf5_messages.h"

#include <cstring>
#include <stdexcept>
#include <string>

namespace mb {

void require_hdf5(bool holds, const char* what) {
  if (!holds) throw std::runtime_error(std::string("an HDF5 structure is damaged: ") + what);
}

std::uint64_t hdf5_product(std::uint64_t a, std::uint64_t b) {
  return b != 0 && a > hdf5_undefined / b ? hdf5_undefined : a * b;
}

std::uint64_t Hdf5Cursor::number(std::size_t n_bytes) {
  std::uint64_t value = 0;
  const std::string_view bytes = take(n_bytes);
  std::memcpy(&value, bytes.data(), n_bytes);
  return value;
}

std::string_view Hdf5Cursor::take(std::uint64_t n_bytes) {
  require_hdf5(n_bytes <= rest_.size(), "a message ends too early");
  const std::string_view taken = rest_.substr(0, n_bytes);
  rest_.remove_prefix(n_bytes);
  return taken;
}

std::vector<std::uint64_t> sizes_of_dataspace(std::string_view bytes) {
  Hdf5Cursor cursor(bytes);
  require_hdf5(cursor.number(1) == 2, "a dataspace of another version");
  const std::uint64_t rank = cursor.number(1), flags = cursor.number(1), type = cursor.number(1);
  require_hdf5(rank <= 3 && flags <= 1 && type == (rank > 0), "a dataspace of another kind");
  std::vector<std::uint64_t> sizes(rank);
  for (std::uint64_t& size : sizes) size = cursor.number(8);
  for (std::uint64_t& size : sizes) {
    const std::uint64_t largest = flags == 1 ? cursor.number(8) : size;
    require_hdf5(size <= largest, "a dataspace beyond its largest size");
    size = largest;
  }
  return sizes;
}

std::uint64_t size_of_datatype(std::string_view bytes) {
  Hdf5Cursor cursor(bytes);
  const std::uint64_t kind = cursor.number(1), version = kind >> 4;
  require_hdf5(version >= 1 && version <= 3, "a datatype of another version");
  const std::uint64_t details = cursor.number(3), size = cursor.number(4);
  constexpr std::uint64_t integer = 0, floating = 1, text = 3;
  switch (kind & 15) {
    case integer:
      require_hdf5(size >= 1 && size <= 8, "an integer of another size");
      cursor.take(4);
      break;
    case floating:
      require_hdf5(size >= 1 && size <= 8, "a float of another size");
      cursor.take(12);
      break;
    case text:
      require_hdf5(size >= 1 && size <= 4096 && details <= 0x12, "a text of another kind");
      break;
    default:
      require_hdf5(false, "a datatype of another class");
  }
  return size;
}

bool has_deflate(std::string_view bytes) {
  constexpr std::uint64_t deflate = 1, shuffle = 2;
  Hdf5Cursor cursor(bytes);
  require_hdf5(cursor.number(1) == 2, "filters of another version");
  bool deflated = false;
  const std::uint64_t n = cursor.number(1);
  require_hdf5(n > 0, "filters without any");
  for (std::uint64_t i = 0; i < n; ++i) {
    const std::uint64_t filter = cursor.number(2);
    if (filter != deflate && filter != shuffle)
      throw std::runtime_error("uses a filter other than shuffle and deflate");
    require_hdf5(!deflated, "a filter behind deflate");
    deflated = filter == deflate;
    cursor.take(2);
    cursor.take(4 * cursor.number(2));
  }
  return deflated;
}

void check_group_info(std::string_view bytes) {
  Hdf5Cursor cursor(bytes);
  const std::uint64_t version = cursor.number(1), flags = cursor.number(1);
  require_hdf5(version == 0 && flags <= 3, "a group info of another kind");
  cursor.take((flags & 1 ? 4 : 0) + (flags & 2 ? 4 : 0));
}

void check_fill_value(std::string_view bytes) {
  Hdf5Cursor cursor(bytes);
  const std::uint64_t version = cursor.number(1), flags = cursor.number(1);
  require_hdf5(version == 3 && flags <= 0x1f, "a fill value of its own");
}

void check_attribute(std::string_view bytes) {
  Hdf5Cursor cursor(bytes);
  require_hdf5(cursor.number(1) == 3 && cursor.number(1) == 0, "an attribute of another version");
  const std::uint64_t name = cursor.number(2), type = cursor.number(2), space = cursor.number(2);
  require_hdf5(cursor.number(1) <= 1, "a name in other letters");
  require_hdf5(name >= 2 && cursor.take(name).find('\0') == name - 1, "a name of another length");
  std::uint64_t n_bytes = size_of_datatype(cursor.take(type));
  for (const std::uint64_t n : sizes_of_dataspace(cursor.take(space))) n_bytes = hdf5_product(n_bytes, n);
  require_hdf5(cursor.rest().size() == n_bytes, "an attribute of another size");
}

void check_no_heap(std::string_view bytes, std::size_t size_of_largest) {
  Hdf5Cursor cursor(bytes);
  const std::uint64_t version = cursor.number(1), flags = cursor.number(1);
  require_hdf5(version == 0 && flags <= 3, "an info message of another kind");
  if (flags & 1) cursor.take(size_of_largest);
  for (int i = 0; i < (flags & 2 ? 3 : 2); ++i) require_hdf5(cursor.number(8) == hdf5_undefined, "a heap or B-tree");
}

}  // namespace mb
