#include "harness/store/hdf5_walk.h"

#include <cstdint>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "harness/store/hdf5.h"
#include "harness/store/hdf5_dataset.h"
#include "harness/store/hdf5_messages.h"
#include "harness/store/hdf5_structures.h"

namespace mb {

namespace {

// Headers and their continuations: root, 1024 datasets, a continuation each, some more of the root. Messages: 2048 of
// the root, eight of each dataset, and gaps.
constexpr std::size_t most_headers = 4096, most_messages = 32768;
constexpr std::uint64_t most_values = hdf5_max_elements;
// [byte] Chunks at the edge of a dataset reach beyond it: of ours, all of them together are less than twice as large.
constexpr std::uint64_t most_unpacked = 2 * most_values * sizeof(double);

enum Message : std::uint64_t {
  nil = 0x00,
  dataspace = 0x01,
  link_info = 0x02,
  datatype = 0x03,
  fill_value = 0x05,
  link = 0x06,
  layout = 0x08,
  group_info = 0x0a,
  filters = 0x0b,
  attribute = 0x0c,
  continuation = 0x10,
  attribute_info = 0x15
};

// An object: its first chunk of messages and all that continue it.
struct Header {
  std::uint64_t flags = 0;
  std::set<std::uint64_t> once;                 // types met of those that an object has one of
  std::vector<std::string_view> continuations;  // messages that name further chunks
  Hdf5Dataset dataset;
};

class Walk {
 public:
  explicit Walk(std::string_view file) : file_(file) {}

  void run() {
    Hdf5Cursor cursor(file_);
    cursor.take(9);
    require_hdf5(cursor.number(1) == 8 && cursor.number(1) == 8, "sizes of addresses other than 8 bytes");
    cursor.take(1);
    require_hdf5(cursor.number(8) == 0, "a base address");
    require_hdf5(cursor.number(8) == hdf5_undefined, "an extension of the superblock");
    cursor.take(8);
    headers_.push_back(cursor.number(8));
    while (!headers_.empty()) {
      const std::uint64_t next = headers_.back();
      headers_.pop_back();
      object(next);
    }
    require_few();
    for (const Hdf5Dataset& dataset : datasets_) check_data(file_, dataset);
  }

 private:
  Hdf5Cursor signed_at(std::uint64_t address, std::uint64_t size, std::string_view signature) const {
    Hdf5Cursor cursor(hdf5_at(file_, address, size));
    require_hdf5(cursor.take(signature.size()) == signature, "an address of something else");
    return cursor;
  }

  void object(std::uint64_t address) {
    require_hdf5(seen_.insert(address).second, "an object with two names");
    require_hdf5(seen_.size() <= most_headers, "too many object headers");
    Hdf5Cursor cursor = signed_at(address, address < file_.size() ? file_.size() - address : 0, "OHDR");
    require_hdf5(cursor.number(1) == 2, "an object header of another version");
    Header header;
    header.flags = cursor.number(1);
    require_hdf5(header.flags <= 0x3f, "an object header of another kind");
    if (header.flags & 0x20) cursor.take(16);
    if (header.flags & 0x10) cursor.take(4);
    const std::uint64_t size = cursor.number(std::size_t{1} << (header.flags & 3));
    messages(cursor.take(size), header);
    cursor.take(4);
    for (std::size_t i = 0; i < header.continuations.size(); ++i) follow(header.continuations[i], header);
    if (!header.once.contains(layout)) return;
    require_hdf5(header.once.contains(dataspace) && header.once.contains(datatype), "a dataset of no size or type");
    datasets_.push_back(header.dataset);
  }

  // Before any chunk is unpacked: a small file may hold one that unpacks to a thousand times its size, and name it
  // thousands of times.
  void require_few() const {
    std::uint64_t values = 0, chunks = 0, unpacked = 0;
    for (const Hdf5Dataset& dataset : datasets_) {
      const Hdf5Extent extent = extent_of(dataset);
      if (extent.values > most_values - values) throw std::runtime_error("holds more than 512 MiB of values");
      values += extent.values, chunks += extent.chunks, unpacked += extent.unpacked;
      require_hdf5(chunks <= hdf5_max_chunks, "more than 8192 chunks");
      require_hdf5(unpacked <= most_unpacked, "chunks larger than their datasets");
    }
  }

  void messages(std::string_view chunk, Header& header) {
    const std::size_t prefix = header.flags & 4 ? 6 : 4;
    Hdf5Cursor cursor(chunk);
    while (cursor.rest().size() >= prefix) {
      require_hdf5(++n_messages_ <= most_messages, "too many messages");
      const std::uint64_t type = cursor.number(1), size = cursor.number(2), shared = cursor.number(1);
      cursor.take(prefix - 4);
      require_hdf5((shared & ~5u) == 0, "a shared message");  // constant, or not to be shared
      message(type, cursor.take(size), header);
    }
  }

  // Of two the library heeds the first, whatever the second says.
  static void require_first(std::uint64_t type, Header& header) {
    require_hdf5(header.once.insert(type).second, "a message that stands twice in an object's header");
  }

  void message(std::uint64_t type, std::string_view bytes, Header& header) {
    Hdf5Dataset& dataset = header.dataset;
    if (type != nil && type != link && type != attribute && type != continuation) require_first(type, header);
    switch (type) {
      case nil:
        return;
      case group_info:
        return check_group_info(bytes);
      case dataspace:
        dataset.size = sizes_of_dataspace(bytes);
        return;
      case datatype:
        dataset.element = size_of_datatype(bytes);
        return;
      case fill_value:
        return check_fill_value(bytes);
      case link_info:
        return check_no_heap(bytes, 8);
      case attribute_info:
        return check_no_heap(bytes, 2);
      case link:
        return follow_link(bytes);
      case layout:
        dataset.layout = bytes;
        return;
      case filters:
        dataset.filtered = true;
        dataset.deflated = has_deflate(bytes);
        return;
      case attribute:
        return check_attribute(bytes);
      case continuation:
        header.continuations.push_back(bytes);
        return;
      default:
        require_hdf5(false, "a message of a kind that files of ours never need");
    }
  }

  void follow_link(std::string_view bytes) {
    Hdf5Cursor cursor(bytes);
    require_hdf5(cursor.number(1) == 1, "a link of another version");
    const std::uint64_t flags = cursor.number(1);
    require_hdf5(flags <= 0x1f, "a link of another kind");
    const std::uint64_t type = flags & 8 ? cursor.number(1) : 0;
    if (flags & 4) cursor.take(8);
    if (flags & 16) require_hdf5(cursor.number(1) <= 1, "a name in other letters");
    const std::string_view name = cursor.take(cursor.number(std::size_t{1} << (flags & 3)));
    require_hdf5(!name.empty() && name.find('\0') == name.npos, "a name of another length");
    if (type != 0)
      throw std::runtime_error("object " + quoted(std::string(name)) + " is a soft, external or user-defined link");
    headers_.push_back(cursor.number(8));
  }

  // Each is met once, since a file names each chunk once.
  void follow(std::string_view bytes, Header& header) {
    Hdf5Cursor cursor(bytes);
    const std::uint64_t address = cursor.number(8), size = cursor.number(8);
    require_hdf5(size >= 8 && seen_.insert(address).second, "a continuation of another");
    require_hdf5(seen_.size() <= most_headers, "too many continuations");
    Hdf5Cursor chunk = signed_at(address, size, "OCHK");
    messages(chunk.take(size - 8), header);
  }

  std::string_view file_;
  std::set<std::uint64_t> seen_;
  std::vector<std::uint64_t> headers_;  // still to be walked
  std::vector<Hdf5Dataset> datasets_;
  std::size_t n_messages_ = 0;
};

}  // namespace

void require_plain_structures(std::string_view hdf5_file) { Walk(hdf5_file).run(); }

}  // namespace mb
