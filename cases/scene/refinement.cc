#include "cases/scene/refinement.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mb {

namespace {

// [-] of the sizes of cells: along directions in which something changes, all where the degree does; 1 where nothing
// does.
double least_ratio(const Resolution& finer, const Resolution& coarser) {
  double least = std::numeric_limits<double>::infinity();
  const auto take = [&](double ratio) {
    if (ratio != 1 || finer.degree != coarser.degree) least = std::min(least, ratio);
  };
  const auto across = [](int cells) { return cells > 0 ? cells : 0.5; };  // a disc of one block for five
  for (std::size_t i = 0; i < std::min(finer.cells.size(), coarser.cells.size()); ++i)
    take(across(finer.cells[i]) / across(coarser.cells[i]));
  if (finer.graded != coarser.graded) take(std::exp2(finer.graded - coarser.graded));
  return std::isfinite(least) ? least : 1;
}

}  // namespace

double fall_of_body(const Resolution& finer, const Resolution& coarser, const Order& order) {
  return std::pow(least_ratio(finer, coarser), order.in_size) *
         std::pow(static_cast<double>(finer.degree) / coarser.degree, order.in_degree);
}

double fall_of_errors(const Resolution& finer, const Resolution& coarser, const Order& order) {
  double fall = fall_of_body(finer, coarser, order);
  for (std::size_t i = 0; i < std::min(finer.others.size(), coarser.others.size()); ++i)
    fall = std::min(fall, fall_of_body(finer.others[i], coarser.others[i], order));
  return fall;
}

}  // namespace mb
