#include "harness/store/seal.h"

#include <stdexcept>

#include "harness/store/hash.h"

namespace mb {

namespace {

std::string seal_of(std::string_view text) { return "{\"checksum\":\"" + content_hash(text) + "\"}\n"; }

}  // namespace

std::string sealed(std::string_view text) { return std::string(text) + seal_of(text); }

std::string unsealed(std::string_view text) {
  static const std::size_t size = seal_of("").size();
  const std::size_t end = text.size() < size ? 0 : text.size() - size;
  const std::string_view content = text.substr(0, end);
  if (text.substr(end) != seal_of(content))
    throw std::runtime_error("is cut short or altered: its checksum is missing or another");
  return std::string(content);
}

}  // namespace mb
