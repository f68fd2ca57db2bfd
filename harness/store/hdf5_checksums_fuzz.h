// Checksums of HDF5's own structures, set right in a file that was altered: without them nearly every alteration would
// be refused at the first structure, and nothing behind it tried.
//
// HDF5 File Format Specification Version 3.0, sections II.A (superblock 2, 3), IV.A.1.b (object header 2) and VII.C
// (fixed array); the checksum is Jenkins' lookup3, hashlittle() of 2006, public domain.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace mb {

inline std::uint32_t lookup3(std::string_view bytes) {
  std::uint32_t a = 0xdeadbeef + static_cast<std::uint32_t>(bytes.size()), b = a, c = a;
  const auto mix = [](std::uint32_t& x, std::uint32_t& y, std::uint32_t z, int by) {
    x -= z, x ^= std::rotl(z, by), z += y;
    return z;
  };
  const auto add = [&](std::size_t at) {  // twelve bytes, zeros behind the end
    std::uint32_t words[3] = {0, 0, 0};
    std::memcpy(words, bytes.data() + at, std::min<std::size_t>(12, bytes.size() - at));
    a += words[0], b += words[1], c += words[2];
  };
  std::size_t at = 0;
  for (; bytes.size() - at > 12; at += 12) {
    add(at);
    c = mix(a, b, c, 4), a = mix(b, c, a, 6), b = mix(c, a, b, 8);
    c = mix(a, b, c, 16), a = mix(b, c, a, 19), b = mix(c, a, b, 4);
  }
  if (at == bytes.size()) return c;
  add(at);
  const auto final_mix = [](std::uint32_t& x, std::uint32_t y, int by) { x ^= y, x -= std::rotl(y, by); };
  final_mix(c, b, 14), final_mix(a, c, 11), final_mix(b, a, 25), final_mix(c, b, 16);
  final_mix(a, c, 4), final_mix(b, a, 14), final_mix(c, b, 24);
  return c;
}

struct Hdf5Message {
  std::size_t header, at;    // places
  std::size_t prefix, size;  // [byte] of what stands before its body, and of that
  std::uint64_t type;
};

class Hdf5Checksums {
 public:
  explicit Hdf5Checksums(std::string& file) : file_(file) {}

  void set_right() {
    if (file_.size() >= 48) seal(0, 48);
    for (std::size_t at = file_.find("OHDR"); at != std::string::npos; at = file_.find("OHDR", at + 4)) header(at);
    for (std::size_t at = file_.find("FAHD"); at != std::string::npos; at = file_.find("FAHD", at + 4)) array(at);
  }

  // Messages of the first chunk of each object header.
  std::vector<Hdf5Message> messages() const {
    std::vector<Hdf5Message> all;
    for (std::size_t at = file_.find("OHDR"); at != std::string::npos; at = file_.find("OHDR", at + 4)) {
      const Chunk chunk = chunk_of(at);
      for (std::size_t i = chunk.begin; i + chunk.prefix <= chunk.end;) {
        const std::size_t size = number(i + 1, 2);
        if (size > chunk.end - i - chunk.prefix) break;
        all.push_back({at, i, chunk.prefix, size, number(i, 1)});
        i += chunk.prefix + size;
      }
    }
    return all;
  }

 private:
  std::uint64_t number(std::size_t at, std::size_t n_bytes) const {
    std::uint64_t value = 0;
    if (at <= file_.size() && n_bytes <= file_.size() - at) std::memcpy(&value, file_.data() + at, n_bytes);
    return value;
  }

  // The last four bytes of [at, at + size).
  void seal(std::size_t at, std::size_t size) {
    if (size < 8 || at > file_.size() || size > file_.size() - at) return;
    const std::uint32_t sum = lookup3(std::string_view(file_).substr(at, size - 4));
    std::memcpy(file_.data() + at + size - 4, &sum, sizeof sum);
  }

  struct Chunk {
    std::size_t begin = 0, end = 0, prefix = 4;  // of its messages; empty where it reaches beyond the file
  };
  Chunk chunk_of(std::size_t header) const {
    const std::uint64_t flags = number(header + 5, 1);
    const std::size_t width = std::size_t{1} << (flags & 3);
    std::size_t first = header + 6;
    if (flags & 0x20) first += 16;  // times
    if (flags & 0x10) first += 4;   // most attributes stored in the header
    const std::uint64_t size = number(first, width);
    first += width;
    if (first > file_.size() || size > file_.size() - first) return {};
    return {first, first + size, flags & 4 ? std::size_t{6} : std::size_t{4}};
  }

  void header(std::size_t at) {
    const Chunk chunk = chunk_of(at);
    if (chunk.end == 0) return;
    continuations(chunk.begin, chunk.end, chunk.prefix, 8);
    seal(at, chunk.end + 4 - at);
  }

  // Head, block and pages of an array of chunks.
  void array(std::size_t at) {
    const std::uint64_t width = number(at + 6, 1), bits = number(at + 7, 1), n = number(at + 8, 8);
    std::uint64_t block = number(at + 16, 8);
    seal(at, 28);
    if (width == 0 || bits > 31 || n > file_.size() / width || block > file_.size()) return;
    const std::uint64_t per_page = std::uint64_t{1} << bits, n_pages = n > per_page ? (n + per_page - 1) / per_page : 0;
    if (n_pages == 0) return seal(block, 14 + n * width + 4);
    const std::uint64_t prefix = 14 + (n_pages + 7) / 8 + 4;
    seal(block, prefix);
    block += prefix;
    for (std::uint64_t done = 0; done < n; done += per_page) {
      const std::uint64_t size = std::min(per_page, n - done) * width + 4;
      seal(block, size);
      block += size;
    }
  }

  // Messages of [at, end): a continuation (type 16) names another chunk of them, with a checksum of its own.
  void continuations(std::size_t at, std::size_t end, std::size_t prefix, int depth) {
    while (at + prefix <= end && end <= file_.size()) {
      const std::uint64_t type = number(at, 1), size = number(at + 1, 2);
      const std::uint64_t chunk = number(at + prefix, 8), length = number(at + prefix + 8, 8);
      at += prefix + size;
      if (type != 16 || size < 16 || depth == 0 || chunk > file_.size() || length < 8 || length > file_.size())
        continue;
      continuations(chunk + 4, chunk + length - 4, prefix, depth - 1);
      seal(chunk, length);
    }
  }

  std::string& file_;
};

// The file with a message moved to a continuation of its header, behind all else, where `chunk` stands instead of it;
// checksums are right. As it is where the message is too small to name a place.
inline std::string continued(std::string file, const Hdf5Message& message, const std::string& chunk) {
  if (message.size < 16 || message.at + message.prefix + message.size > file.size() || file.size() < 48) return file;
  const std::uint64_t place[2] = {file.size(), chunk.size() + 8}, end = file.size() + chunk.size() + 8;
  file[message.at] = 16, file[message.at + 3] = 0;
  std::memcpy(file.data() + message.at + message.prefix, place, sizeof place);
  std::memcpy(file.data() + 28, &end, sizeof end);  // end of file, in the superblock
  file += "OCHK" + chunk + std::string(4, '\0');
  Hdf5Checksums(file).set_right();
  return file;
}

}  // namespace mb
