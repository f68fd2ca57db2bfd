#include "harness/metrics/gci.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace mb {

std::optional<GridConvergence> grid_convergence(double f1, double f2, double f3, double refinement, double theory) {
  if (!(refinement > 1 && std::isfinite(refinement) && theory > 0 && std::isfinite(theory)))
    throw std::invalid_argument("grid_convergence: the refinement ratio must exceed 1 and the order 0");
  const double contraction = (f3 - f2) / (f2 - f1);  // r^p; NaN or infinite where answers are equal
  if (!(contraction > 1 && std::isfinite(contraction)) || f1 == 0 || f2 == 0) return std::nullopt;
  const double order = std::log(contraction) / std::log(refinement), reach = (f1 - f2) / (contraction - 1);
  const double safety = std::abs(order - theory) <= 0.1 * theory ? 1.25 : 3;
  const double least = std::pow(refinement, safety < 3 ? order : std::min(order, theory)) - 1;
  const double fine = safety * std::abs((f2 - f1) / f1) / least, coarse = safety * std::abs((f3 - f2) / f2) / least;
  return GridConvergence{order, f1 + reach, fine, coarse, coarse / (contraction * fine)};
}

std::optional<double> gci_of_two(double f1, double f2, double refinement, double order) {
  if (!(refinement > 1 && std::isfinite(refinement) && order > 0 && std::isfinite(order)))
    throw std::invalid_argument("gci_of_two: the refinement ratio must exceed 1 and the order 0");
  constexpr double safety = 3;
  if (!std::isfinite(f1) || !std::isfinite(f2) || f1 == 0) return std::nullopt;
  return safety * std::abs((f2 - f1) / f1) / (std::pow(refinement, order) - 1);
}

}  // namespace mb
