#include "modal/bases/dense_modes.h"

#include <fmt/format.h>

#include <stdexcept>

#include "mechanics/algebra/dense_eigen.h"
#include "mechanics/system/static_response.h"

namespace mb {

ElasticModes dense_modes(const System& system) {
  const Index n = system.K.rows(), n_elastic = n - system.R.cols();
  if (n > largest_dense)
    throw std::invalid_argument(
        fmt::format("modes: more than a third of {} asked for, which needs a dense solver; it "
                    "takes at most {} degrees of freedom",
                    n, largest_dense));
  const auto eigen = generalized_eigen(MatrixXd(system.K), MatrixXd(system.M));
  if (!eigen) throw std::runtime_error("modes: the dense eigenproblem failed");
  // The rigid modes come first, near zero. Rounding mixes them with the lowest elastic ones by eps lambda_max/lambda_1,
  // which the projection takes out again.
  return {eigen->values.tail(n_elastic), without_rigid_part(system, eigen->vectors.rightCols(n_elastic))};
}

}  // namespace mb
