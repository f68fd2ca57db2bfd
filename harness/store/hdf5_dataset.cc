#include "harness/store/hdf5_dataset.h"

#include "harness/store/hdf5_messages.h"
#include "harness/store/inflate.h"

namespace mb {

namespace {

class Data {
 public:
  Data(std::string_view file, const Hdf5Dataset& dataset) : file_(file), dataset_(dataset) {}

  void check() const {
    Hdf5Cursor cursor(dataset_.layout);
    const std::uint64_t version = cursor.number(1), kind = cursor.number(1);
    require_hdf5(version == 3 || version == 4, "a layout of another version");
    constexpr std::uint64_t compact = 0, contiguous = 1, chunked = 2;
    if (kind == compact) {
      const std::uint64_t n_bytes = cursor.number(2);
      require_hdf5(n_bytes == size(), "compact data of another size");
      cursor.take(n_bytes);
    } else if (kind == contiguous) {
      const std::uint64_t address = cursor.number(8), n_bytes = cursor.number(8);
      if (address == hdf5_undefined) return;  // never written
      require_hdf5(n_bytes == size(), "contiguous data of another size");
      hdf5_at(file_, address, n_bytes);
    } else {
      require_hdf5(kind == chunked && version == 4, "a layout of another kind");
      check_chunks(cursor);
    }
  }

 private:
  std::uint64_t size() const {  // [byte]
    std::uint64_t n_bytes = dataset_.element;
    for (const std::uint64_t n : dataset_.size) n_bytes = hdf5_product(n_bytes, n);
    return n_bytes;
  }

  void check_chunks(Hdf5Cursor cursor) const {
    const std::uint64_t flags = cursor.number(1), rank = cursor.number(1), width = cursor.number(1);
    require_hdf5(rank == dataset_.size.size() + 1 && width >= 1 && width <= 8, "chunks of another kind");
    std::uint64_t n_bytes = 1, n_chunks = 1;
    for (std::uint64_t i = 0; i < rank; ++i) {
      const std::uint64_t along = cursor.number(width);
      require_hdf5(along > 0, "chunks of no size");
      n_bytes = hdf5_product(n_bytes, along);
      if (i + 1 < rank) n_chunks = hdf5_product(n_chunks, dataset_.size[i] / along + (dataset_.size[i] % along > 0));
      if (i + 1 == rank) require_hdf5(along == dataset_.element, "chunks of other elements");
    }
    require_hdf5(n_bytes <= hdf5_max_chunk, "chunks of more than 512 KiB");
    require_hdf5(n_chunks <= hdf5_max_chunks, "more than 8192 chunks");
    constexpr std::uint64_t single = 1, fixed_array = 3;
    const std::uint64_t index = cursor.number(1);
    if (index == single) {
      require_hdf5(n_chunks == 1, "one chunk where there are more");
      const bool has_size = flags & 2;
      require_hdf5(has_size == dataset_.filtered, "a filtered chunk without filters");
      const std::uint64_t stored = has_size ? cursor.number(8) : n_bytes, skipped = has_size ? cursor.number(4) : 0;
      check_chunk(cursor.number(8), stored, skipped, n_bytes);
    } else {
      require_hdf5(index == fixed_array, "an index of chunks of another kind");
      const std::uint64_t page_bits = cursor.number(1), address = cursor.number(8);
      if (address != hdf5_undefined) check_array(address, page_bits, n_bytes, n_chunks);
    }
  }

  void check_chunk(std::uint64_t address, std::uint64_t stored, std::uint64_t skipped, std::uint64_t n_bytes) const {
    if (address == hdf5_undefined) return;  // never written
    const std::string_view bytes = hdf5_at(file_, address, stored);
    require_hdf5(skipped == 0, "a chunk that skips filters");
    require_hdf5(dataset_.deflated ? inflates_to(bytes, n_bytes) : stored == n_bytes, "a chunk of another size");
  }

  void check_array(std::uint64_t address, std::uint64_t page_bits, std::uint64_t n_bytes, std::uint64_t n) const {
    Hdf5Cursor head = signed_at(address, 28, "FAHD");
    const std::uint64_t filtered = head.number(1), width = head.number(1), bits = head.number(1);
    require_hdf5(filtered == dataset_.filtered && (filtered ? width > 12 && width <= 20 : width == 8),
                 "an array of chunks of another kind");
    require_hdf5(bits == page_bits && bits >= 1 && bits <= 31 && head.number(8) == n, "an array of other chunks");
    const std::uint64_t block = head.number(8);
    if (block == hdf5_undefined) return;
    const std::uint64_t per_page = std::uint64_t{1} << bits, n_pages = n > per_page ? (n + per_page - 1) / per_page : 0;
    Hdf5Cursor array = signed_at(block, 14 + (n_pages + 7) / 8 + n * width + 4 * (n_pages + 1), "FADB");
    require_hdf5(array.number(1) == filtered && array.number(8) == address, "chunks of another array");
    if (n_pages > 0) array.take((n_pages + 7) / 8 + 4);
    for (std::uint64_t i = 0; i < n; ++i) {
      if (i > 0 && n_pages > 0 && i % per_page == 0) array.take(4);  // a page's checksum
      const std::uint64_t chunk = array.number(8);
      const std::uint64_t stored = filtered ? array.number(width - 12) : n_bytes;
      const std::uint64_t skipped = filtered ? array.number(4) : 0;
      // Of pages that were never written the library looks at nothing: they are zeros.
      if (chunk != 0) check_chunk(chunk, stored, skipped, n_bytes);
    }
  }

  // Behind signature and version 0.
  Hdf5Cursor signed_at(std::uint64_t address, std::uint64_t n_bytes, std::string_view signature) const {
    Hdf5Cursor cursor(hdf5_at(file_, address, n_bytes));
    require_hdf5(cursor.take(signature.size()) == signature && cursor.number(1) == 0, "an address of something else");
    return cursor;
  }

  std::string_view file_;
  const Hdf5Dataset& dataset_;
};

}  // namespace

std::string_view hdf5_at(std::string_view file, std::uint64_t address, std::uint64_t size) {
  require_hdf5(address <= file.size() && size <= file.size() - address, "an address beyond the end of the file");
  return file.substr(address, size);
}

void check_data(std::string_view file, const Hdf5Dataset& dataset) { Data(file, dataset).check(); }

}  // namespace mb
