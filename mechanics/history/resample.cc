#include "mechanics/history/resample.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "mechanics/history/peak.h"

namespace mb {
namespace {

using Function = std::function<double(double)>;

constexpr long most_bounds = 4'000'000;
constexpr double unseen = 0.01;  // [-] of the scale: what f may do between the points measured at, by its bounds

double shortest_of(double end) { return 4 * std::numeric_limits<double>::epsilon() * std::abs(end); }

double scale_of(double least, double f_a, double f_b) {
  return std::max(least, std::min(std::abs(f_a), std::abs(f_b)));
}

class Bisection {
 public:
  Bisection(const Function& f, const Enclosure& bounds, double start, double end, double tolerance, double least_scale)
      : f_(f),
        bounds_(bounds),
        shortest_(shortest_of(end)),
        length_(end - start),
        tolerance_(tolerance),
        least_scale_(least_scale) {
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
    const double scale = scale_of(least_scale_, f_a, f_b);
    for (int i = 0; i < n_probes; ++i) {
      const double x = golden_fraction(i);
      if (!(std::abs(f_(a + x * (b - a)) - (f_a + x * (f_b - f_a))) <= tolerance_ * scale)) return false;
    }
    return !bounds_ || stays_near({a, b, f_a, (f_b - f_a) / (b - a)}, a, b, scale);
  }
  // By its bounds, between the probes too.
  bool stays_near(const Segment& line, double a, double b, double scale) const {
    const Interval s = bounds_({a, b});
    const double x = value(line, a), y = value(line, b), most = (unseen + tolerance_) * scale;
    if (s.defined && s.hi - std::min(x, y) <= most && std::max(x, y) - s.lo <= most) return true;
    if (b - a <= shortest_) return true;
    if (++n_bounds_ > most_bounds)
      throw std::domain_error(fmt::format("cannot be told from a line near t = {:.6g} s: its terms nearly cancel", a));
    const double middle = 0.5 * (a + b);
    if (!(std::abs(f_(middle) - value(line, middle)) <= tolerance_ * scale)) return false;
    return stays_near(line, a, middle, scale) && stays_near(line, middle, b, scale);
  }
  void refine(double a, double f_a, double b, double f_b) {
    if (pieces_.size() > most_pieces) return;
    if (b - a <= shortest_) {
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
  const Enclosure& bounds_;
  double shortest_, length_, tolerance_, least_scale_;
  mutable long n_bounds_ = 0;
  std::vector<Segment> pieces_;
};

constexpr int n_points = 16;
double point(const Segment& piece, int i) { return piece.start + (i + 0.5) / n_points * (piece.end - piece.start); }

double measured_error(const Function& f, const std::vector<Segment>& pieces, double least_scale) {
  double error = 0;
  for (const auto& piece : pieces) {
    if (piece.end - piece.start <= shortest_of(pieces.back().end)) continue;
    const double scale = scale_of(least_scale, value(piece, piece.start), value(piece, piece.end));
    for (int i = 0; i < n_points; ++i) {
      const double off = std::abs(f(point(piece, i)) - value(piece, point(piece, i)));
      if (off > 0) error = std::max(error, off / scale);
    }
  }
  return error;
}

}  // namespace

double mean_size(const Function& f, const std::vector<Segment>& pieces) {
  double sum = 0;
  for (const auto& piece : pieces)
    for (int i = 0; i < n_points; ++i) sum += std::abs(f(point(piece, i))) * (piece.end - piece.start) / n_points;
  return sum / (pieces.back().end - pieces.front().start);
}

Lines resample(const Function& f, double start, double end, double tolerance, double least_scale,
               const Enclosure& bounds) {
  for (double share : {0.75, 0.4, 0.2, 0.1}) {  // the finer set may find what the probes have missed
    const auto pieces = Bisection(f, bounds, start, end, share * tolerance, least_scale).pieces();
    if (!pieces) break;
    const double error = measured_error(f, *pieces, least_scale);
    if (error <= tolerance) return {*pieces, error};
  }
  throw std::domain_error(fmt::format("cannot be resampled to {:.3g} within {} pieces on [{:.6g}, {:.6g}] s",
                                      tolerance * least_scale, most_pieces, start, end));
}

}  // namespace mb
