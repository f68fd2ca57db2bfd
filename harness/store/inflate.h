// The door of zlib: what HDF5's deflate filter makes.
#pragma once

#include <cstddef>
#include <string_view>

namespace mb {

bool inflates_to(std::string_view deflated, std::size_t n_bytes);  // to exactly so many; allocates no more

}  // namespace mb
