#include "mechanics/history/peak.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <stdexcept>
#include <string>
#include <vector>

namespace mb {
namespace {

using Function = std::function<double(double)>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double close_enough = 1.01;                           // [-] a bound over what was found
constexpr double no_size = std::numeric_limits<double>::min();  // below it numbers lose digits
constexpr int most_intervals = 20'000;

// Golden-section search for the largest |f| on [a, b]
double local_peak(const Function& f, double a, double b) {
  constexpr double ratio = 0.6180339887498949;
  double x = b - ratio * (b - a), y = a + ratio * (b - a), f_x = std::abs(f(x)), f_y = std::abs(f(y));
  double largest = std::max(f_x, f_y);
  for (int i = 0; i < 60; ++i) {  // 0.618^60 = 3e-13 of the interval
    if (f_x > f_y) {
      b = y, y = x, f_y = f_x, x = b - ratio * (b - a), f_x = std::abs(f(x));
    } else {
      a = x, x = y, f_x = f_y, y = a + ratio * (b - a), f_y = std::abs(f(y));
    }
    largest = std::max({largest, f_x, f_y});
  }
  return largest;
}

// Of some 4,000 irregular points, improved by search about its maxima.
double sampled_size(const Function& f, double start, double end) {
  constexpr int n_cells = 4096, n_searched = 32;
  std::vector<double> t = {start}, s = {std::abs(f(start))};
  for (int i = 0; i < n_cells; ++i) {
    t.push_back(start + (i + golden_fraction(i)) / n_cells * (end - start));
    s.push_back(std::abs(f(t.back())));
  }
  t.push_back(end), s.push_back(std::abs(f(end)));
  const double sampled = *std::max_element(s.begin(), s.end());

  std::vector<std::size_t> maxima;
  for (std::size_t i = 1; i + 1 < s.size(); ++i)
    if (s[i] >= s[i - 1] && s[i] >= s[i + 1] && s[i] > 0) maxima.push_back(i);
  std::sort(maxima.begin(), maxima.end(), [&](std::size_t i, std::size_t j) { return s[i] > s[j]; });
  if (maxima.size() > n_searched) maxima.resize(n_searched);
  double largest = sampled;
  for (const auto i : maxima) largest = std::max(largest, local_peak(f, t[i - 1], t[i + 1]));
  if (largest > 1e3 * sampled)  // a pole: what the search finds has grown by the fineness of the search
    throw std::domain_error(
        fmt::format("seems unbounded: |s| reaches {:.3g} between samples of at most {:.3g}", largest, sampled));
  return largest;
}

struct Part {
  double start, end;
  double most;    // |f| is not larger on it; infinite where f may be undefined
  bool has_pole;  // for all that is known
};
bool operator<(const Part& a, const Part& b) { return a.most < b.most; }

Part part_of(const Enclosure& bounds, double start, double end) {
  const Interval s = bounds({start, end});
  const double most = std::max(std::abs(s.lo), std::abs(s.hi));
  return {start, end, s.defined ? most : infinity, most == infinity};
}

std::string undecided(const Part& part, double t) {
  return fmt::format("cannot be shown to be {} near t = {:.9g} s: its terms nearly cancel",
                     part.most == infinity ? "finite" : "bounded", t);
}

}  // namespace

double golden_fraction(int i) {
  const double x = 0.5 + 0.6180339887498949 * i;
  return x - std::floor(x);
}

double largest_size(const Function& f, const Enclosure& bounds, double start, double end) {
  double largest = sampled_size(f, start, end);
  const double shortest = 4 * std::numeric_limits<double>::epsilon() * std::max(std::abs(start), std::abs(end));
  std::priority_queue<Part> open;  // the one that could hold the largest first
  open.push(part_of(bounds, start, end));
  for (int n = 0; !open.empty() && open.top().most > std::max(close_enough * largest, no_size); ++n) {
    const Part part = open.top();
    open.pop();
    const double middle = 0.5 * (part.start + part.end);
    if (n >= most_intervals) throw std::domain_error(undecided(part, middle));
    for (const double t : {part.start, middle, part.end}) largest = std::max(largest, std::abs(f(t)));
    if (part.end - part.start <= shortest) {
      if (part.has_pole) throw std::domain_error(fmt::format("seems unbounded near t = {:.9g} s", middle));
      continue;
    }
    open.push(part_of(bounds, part.start, middle));
    open.push(part_of(bounds, middle, part.end));
  }
  return largest;
}

}  // namespace mb
