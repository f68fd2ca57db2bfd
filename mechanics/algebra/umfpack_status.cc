#include "mechanics/algebra/umfpack_status.h"

#include <fmt/format.h>
#include <umfpack.h>

namespace mb::umfpack {

std::string describe(int status) {
  switch (status) {
    case UMFPACK_WARNING_singular_matrix:
      return "the matrix is singular";
    case UMFPACK_ERROR_out_of_memory:
      return "out of memory";
    case UMFPACK_ERROR_invalid_matrix:
      return "the matrix is not well formed";
    default:
      return fmt::format("UMFPACK status {}", status);
  }
}

}  // namespace mb::umfpack
