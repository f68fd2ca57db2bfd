#include "harness/store/inflate.h"

#include <zlib.h>

#include <vector>

namespace mb {

bool inflates_to(std::string_view deflated, std::size_t n_bytes) {
  std::vector<Bytef> bytes(n_bytes);
  uLongf size = n_bytes;
  return uncompress(bytes.data(), &size, reinterpret_cast<const Bytef*>(deflated.data()), deflated.size()) == Z_OK &&
         size == n_bytes;
}

}  // namespace mb
