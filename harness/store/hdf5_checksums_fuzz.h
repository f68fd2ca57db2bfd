// Checksums of HDF5's own structures, set right in a file that was altered: without them nearly every alteration would
// be refused at the first structure, and nothing behind it tried.
//
// HDF5 File Format Specification Version 3.0, sections II.A (superblock 2, 3) and IV.A.1.b (object header 2); the
// checksum is Jenkins' lookup3, hashlittle() of 2006, public domain.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

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

class Hdf5Checksums {
 public:
  explicit Hdf5Checksums(std::string& file) : file_(file) {}

  void set_right() {
    if (file_.size() >= 48) seal(0, 48);
    for (std::size_t at = file_.find("OHDR"); at != std::string::npos; at = file_.find("OHDR", at + 4)) header(at);
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

  void header(std::size_t at) {
    const std::uint64_t flags = number(at + 5, 1);
    const std::size_t width = std::size_t{1} << (flags & 3);
    std::size_t first = at + 6;
    if (flags & 0x20) first += 16;  // times
    if (flags & 0x10) first += 4;   // most attributes stored in the header
    const std::uint64_t size = number(first, width);
    first += width;
    if (size > file_.size()) return;
    continuations(first, first + size, flags & 4 ? 6 : 4, 8);
    seal(at, first + size + 4 - at);
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

}  // namespace mb
