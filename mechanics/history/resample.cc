#include "mechanics/history/resample.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

namespace mb {
namespace {

using Function = std::function<double(double)>;

// Multiples of the golden ratio modulo 1: evenly spread at any number, and no period of f can hide between them.
double golden_fraction(int i) {
  const double x = 0.5 + 0.6180339887498949 * i;
  return x - std::floor(x);
}

class Bisection {
 public:
  Bisection(const Function& f, double start, double end, double tolerance)
      : f_(f), end_(end), length_(end - start), tolerance_(tolerance) {
    refine(start, f(start), end, f(end));
  }
  // Empty when there would be more than most_pieces.
  std::optional<std::vector<Segment>> pieces() const {
    return pieces_.size() <= most_pieces ? std::optional(pieces_) : std::nullopt;
  }

 private:
  // Long intervals are probed at more points, so that a bump which is short against the whole is still seen.
  bool is_line(double a, double f_a, double b, double f_b) const {
    const int n_probes = 7 + static_cast<int>(2048 * (b - a) / length_);
    for (int i = 0; i < n_probes; ++i) {
      const double x = golden_fraction(i);
      if (!(std::abs(f_(a + x * (b - a)) - (f_a + x * (f_b - f_a))) <= tolerance_)) return false;
    }
    return true;
  }
  void refine(double a, double f_a, double b, double f_b) {
    if (pieces_.size() > most_pieces) return;
    if (b - a <= 4 * std::numeric_limits<double>::epsilon() * std::abs(end_)) {
      pieces_.push_back({a, b, f_a});
    } else if (is_line(a, f_a, b, f_b)) {
      pieces_.push_back({a, b, f_a, (f_b - f_a) / (b - a)});
    } else {
      const double middle = 0.5 * (a + b), f_middle = f_(middle);
      refine(a, f_a, middle, f_middle);
      refine(middle, f_middle, b, f_b);
    }
  }

  const Function& f_;
  double end_, length_, tolerance_;
  std::vector<Segment> pieces_;
};

double measured_error(const Function& f, const std::vector<Segment>& pieces) {
  constexpr int n_points = 16;
  double error = 0;
  for (const auto& piece : pieces) {
    if (piece.end - piece.start <= 4 * std::numeric_limits<double>::epsilon() * std::abs(pieces.back().end)) continue;
    for (int i = 0; i < n_points; ++i) {
      const double t = piece.start + (i + 0.5) / n_points * (piece.end - piece.start);
      error = std::max(error, std::abs(f(t) - value(piece, t)));
    }
  }
  return error;
}

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

}  // namespace

Lines resample(const Function& f, double start, double end, double tolerance) {
  for (double share : {0.75, 0.4, 0.2, 0.1}) {  // the finer set may find what the probes have missed
    const auto pieces = Bisection(f, start, end, share * tolerance).pieces();
    if (!pieces) break;
    const double error = measured_error(f, *pieces);
    if (error <= tolerance) return {*pieces, error};
  }
  throw std::domain_error(fmt::format("cannot be resampled to {:.3g} within {} pieces on [{:.6g}, {:.6g}] s", tolerance,
                                      most_pieces, start, end));
}

double sampled_peak(const Function& f, double start, double end) {
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

}  // namespace mb
