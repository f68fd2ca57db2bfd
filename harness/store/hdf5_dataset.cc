#include "harness/store/hdf5_dataset.h"

#include <bit>

#include "harness/store/hdf5_messages.h"
#include "harness/store/inflate.h"

namespace mb {

namespace {

enum Kind : std::uint64_t { compact = 0, contiguous = 1, chunked = 2 };
enum ChunkIndex : std::uint64_t { single = 1, fixed_array = 3 };
constexpr std::uint64_t has_size = 2;  // flag of chunks: the single one is filtered, its size beside it

std::uint64_t n_values(const Hdf5Dataset& dataset) {
  std::uint64_t n = 1;
  for (const std::uint64_t along : dataset.size) n = hdf5_product(n, along);
  return n;
}

struct Layout {
  std::uint64_t kind;
  Hdf5Cursor rest;
};
Layout layout_of(const Hdf5Dataset& dataset) {
  Hdf5Cursor cursor(dataset.layout);
  const std::uint64_t version = cursor.number(1), kind = cursor.number(1);
  require_hdf5(version == 3 || version == 4, "a layout of another version");
  require_hdf5(kind <= chunked && (kind != chunked || version == 4), "a layout of another kind");
  require_hdf5(kind == chunked || !dataset.filtered, "filters without chunks");
  return {kind, cursor};
}

struct Chunks {
  std::uint64_t n_bytes, n;  // of one, and how many
  std::uint64_t flags, index;
  Hdf5Cursor rest;
};
Chunks chunks_of(const Hdf5Dataset& dataset, Hdf5Cursor cursor) {
  const std::uint64_t flags = cursor.number(1), rank = cursor.number(1), width = cursor.number(1);
  require_hdf5(rank == dataset.size.size() + 1 && width >= 1 && width <= 8, "chunks of another kind");
  std::uint64_t n_bytes = 1, n = 1;
  for (std::uint64_t i = 0; i < rank; ++i) {
    const std::uint64_t along = cursor.number(width);
    require_hdf5(along > 0, "chunks of no size");
    n_bytes = hdf5_product(n_bytes, along);
    if (i + 1 < rank) n = hdf5_product(n, dataset.size[i] / along + (dataset.size[i] % along > 0));
    if (i + 1 == rank) require_hdf5(along == dataset.element, "chunks of other elements");
  }
  require_hdf5(n_bytes <= hdf5_max_chunk, "chunks of more than 512 KiB");
  require_hdf5(n <= hdf5_max_chunks, "more than 8192 chunks");
  const std::uint64_t index = cursor.number(1);
  require_hdf5(index == single || index == fixed_array, "an index of chunks of another kind");
  // Flag 1 leaves the filters out at the edges: the library would take what is packed there for the values.
  require_hdf5(flags == (index == single && dataset.filtered ? has_size : 0), "chunks with other flags");
  return {n_bytes, n, flags, index, cursor};
}

class Data {
 public:
  Data(std::string_view file, const Hdf5Dataset& dataset) : file_(file), dataset_(dataset) {}

  void check() const {
    auto [kind, cursor] = layout_of(dataset_);
    const std::uint64_t size = hdf5_product(n_values(dataset_), dataset_.element);  // [byte]
    if (kind == compact) {
      const std::uint64_t n_bytes = cursor.number(2);
      require_hdf5(n_bytes == size, "compact data of another size");
      cursor.take(n_bytes);
    } else if (kind == contiguous) {
      const std::uint64_t address = cursor.number(8), n_bytes = cursor.number(8);
      if (address == hdf5_undefined) return;  // never written
      require_hdf5(n_bytes == size, "contiguous data of another size");
      hdf5_at(file_, address, n_bytes);
    } else {
      check_chunks(chunks_of(dataset_, cursor));
    }
  }

 private:
  void check_chunks(Chunks chunks) const {
    Hdf5Cursor& cursor = chunks.rest;
    if (chunks.index == single) {
      require_hdf5(chunks.n == 1, "one chunk where there are more");
      const bool filtered = chunks.flags == has_size;
      const std::uint64_t stored = filtered ? cursor.number(8) : chunks.n_bytes,
                          skipped = filtered ? cursor.number(4) : 0;
      check_chunk(cursor.number(8), stored, skipped, chunks.n_bytes);
    } else {
      const std::uint64_t page_bits = cursor.number(1), address = cursor.number(8);
      if (address != hdf5_undefined) check_array(address, page_bits, chunks.n_bytes, chunks.n);
    }
  }

  void check_chunk(std::uint64_t address, std::uint64_t stored, std::uint64_t skipped, std::uint64_t n_bytes) const {
    if (address == hdf5_undefined) return;  // never written
    const std::string_view bytes = hdf5_at(file_, address, stored);
    require_hdf5(skipped == 0, "a chunk that skips filters");
    // Deflated values grow by 0.1 % at most: the library reads whatever stands behind them, too, in every chunk.
    require_hdf5(stored <= n_bytes + n_bytes / 1000 + 13, "a chunk of another size");
    require_hdf5(dataset_.deflated ? inflates_to(bytes, n_bytes) : stored == n_bytes, "a chunk of another size");
  }

  // [byte] of an array's element: address and, of a filtered chunk, size and filters left out. The library decodes by
  // this size, whatever the array states.
  std::uint64_t element_width(std::uint64_t n_bytes) const {
    if (!dataset_.filtered) return 8;
    const auto log2 = static_cast<std::uint64_t>(std::bit_width(n_bytes) - 1);
    return 8 + 1 + (log2 + 8) / 8 + 4;
  }

  void check_array(std::uint64_t address, std::uint64_t page_bits, std::uint64_t n_bytes, std::uint64_t n) const {
    Hdf5Cursor head = signed_at(address, 28, "FAHD");
    const std::uint64_t filtered = head.number(1), width = head.number(1), bits = head.number(1);
    require_hdf5(filtered == dataset_.filtered && width == element_width(n_bytes),
                 "an array of chunks of another kind");
    require_hdf5(bits == page_bits && bits >= 1 && bits <= 31 && head.number(8) == n, "an array of other chunks");
    const std::uint64_t block = head.number(8);
    if (block == hdf5_undefined) return;
    const std::uint64_t per_page = std::uint64_t{1} << bits, n_pages = n > per_page ? (n + per_page - 1) / per_page : 0;
    const std::uint64_t n_flags = (n_pages + 7) / 8;  // [byte] a bit a page, the highest first
    Hdf5Cursor array = signed_at(block, 14 + n_flags + n * width + 4 * (n_pages + 1), "FADB");
    require_hdf5(array.number(1) == filtered && array.number(8) == address, "chunks of another array");
    const std::string_view flags = array.take(n_flags);
    if (n_pages > 0) array.take(4);  // a checksum
    for (std::uint64_t i = 0; i < n; ++i) {
      if (i > 0 && n_pages > 0 && i % per_page == 0) array.take(4);  // a page's checksum
      const std::uint64_t page = i / per_page, chunk = array.number(8);
      const std::uint64_t stored = filtered ? array.number(width - 12) : n_bytes;
      const std::uint64_t skipped = filtered ? array.number(4) : 0;
      // Of pages that were never written the library looks at nothing; of all others at every element, address 0, too.
      const bool written = n_pages == 0 || (static_cast<unsigned char>(flags[page / 8]) << page % 8 & 0x80) != 0;
      if (written) check_chunk(chunk, stored, skipped, n_bytes);
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

Hdf5Extent extent_of(const Hdf5Dataset& dataset) {
  const auto [kind, cursor] = layout_of(dataset);
  Hdf5Extent extent{n_values(dataset), 0, 0};
  if (kind != chunked) return extent;
  const Chunks chunks = chunks_of(dataset, cursor);
  extent.chunks = chunks.n;
  extent.unpacked = hdf5_product(chunks.n, chunks.n_bytes);
  return extent;
}

void check_data(std::string_view file, const Hdf5Dataset& dataset) { Data(file, dataset).check(); }

}  // namespace mb
