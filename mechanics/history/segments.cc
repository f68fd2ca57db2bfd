// What integrators ask of a history: where to stop, its chain of segments, its size.
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "mechanics/history/enclosure.h"
#include "mechanics/history/history.h"
#include "mechanics/history/peak.h"
#include "mechanics/history/resample.h"
#include "mechanics/types.h"

namespace mb {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

void require(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(what);
}
bool positive(double x) { return x > 0 && std::isfinite(x); }

void check(const Step& h) { require(std::isfinite(h.amplitude) && std::isfinite(h.start), "step: not finite"); }
void check(const Harmonic& h) {
  require(positive(h.omega), "harmonic: omega must be positive");
  require(std::isfinite(h.phase) && std::isfinite(h.amplitude) && std::isfinite(h.start), "harmonic: not finite");
}
void check(const Chirp& h) {
  require(positive(h.duration), "chirp: duration must be positive");
  require(h.omega0 >= 0 && h.omega1 >= 0, "chirp: frequencies must not be negative");
  require(std::isfinite(h.omega0 + h.omega1 + h.amplitude + h.start), "chirp: not finite");
}
void check(const Table& h) {
  require(h.t.size() >= 2 && h.t.size() == h.s.size(), "table: needs at least 2 times and a value for each");
  for (std::size_t i = 0; i < h.t.size(); ++i) {
    require(std::isfinite(h.t[i]) && std::isfinite(h.s[i]), "table: not finite");
    require(i == 0 || h.t[i] > h.t[i - 1], "table: times must ascend");
  }
}
void check(const Expression&) {}  // the compiler of formulas checks it
template <class PulseOrRamp>
void check(const PulseOrRamp& h) {
  require(positive(h.duration), "pulse, ramp: duration must be positive");
  require(std::isfinite(h.amplitude) && std::isfinite(h.start), "pulse, ramp: not finite");
}

void check(const History& history, double duration) {
  require(positive(duration), "the duration of a history must be positive");
  std::visit([](const auto& h) { check(h); }, history);
}

// Exact chains, zero outside of them.
Segments chain(const Step& h, double, double) { return {{{h.start, infinity, h.amplitude}}}; }

Segments chain(const Pulse& h, double, double) {  // A sin^2 x = A/2 - A/2 cos 2x
  return {{{h.start, h.start + h.duration, h.amplitude / 2, 0, -h.amplitude / 2, 0, 2 * pi / h.duration}}};
}

Segments chain(const Ramp& h, double, double) {
  const double top = h.start + h.duration;
  return {{{h.start, top, 0, h.amplitude / h.duration}, {top, infinity, h.amplitude}}};
}

Segments chain(const Harmonic& h, double, double) {
  return {{{h.start, infinity, 0, 0, h.amplitude * std::sin(h.phase), h.amplitude * std::cos(h.phase), h.omega}}};
}

Segments chain(const Table& h, double, double) {
  Segments result;
  for (std::size_t i = 0; i + 1 < h.t.size(); ++i)
    result.pieces.push_back({h.t[i], h.t[i + 1], h.s[i], (h.s[i + 1] - h.s[i]) / (h.t[i + 1] - h.t[i])});
  return result;
}

Segments of(Lines lines) { return {std::move(lines.pieces), lines.error}; }

Segments chain(const Chirp& h, double duration, double tolerance) {
  const double start = std::max(h.start, 0.0), end = std::min(h.start + h.duration, duration);
  if (!(start < end)) return {};
  Chirp endless = h;  // its last node is the limit from the left, not the zero that follows
  endless.duration = 2 * h.duration;
  endless.omega1 = 2 * h.omega1 - h.omega0;
  return of(resample(evaluator(endless), start, end, tolerance, peak(h, duration)));
}

// Against the mean of |s|: a short window may be far higher than all the rest, and not weigh more.
Segments chain(const Expression& h, double duration, double tolerance) {
  const auto s = evaluator(h);
  const Enclosure bounds = enclosure(h.formula);
  const Lines rough = resample(s, 0, duration, 0.01, largest_size(s, bounds, 0, duration), bounds);
  return of(resample(s, 0, duration, tolerance, mean_size(s, rough.pieces), bounds));
}

// Largest |sin| over the phases [from, to]
double largest_sine(double from, double to) {
  const double crest = (std::ceil(from / pi - 0.5) + 0.5) * pi;  // first odd multiple of pi/2 from `from` on
  return crest <= to ? 1 : std::max(std::abs(std::sin(from)), std::abs(std::sin(to)));
}

double largest(const Step& h, double duration) { return h.start <= duration ? std::abs(h.amplitude) : 0; }
double largest(const Pulse& h, double duration) {
  const double from = std::clamp(-h.start / h.duration, 0.0, 1.0);
  const double to = std::clamp((duration - h.start) / h.duration, 0.0, 1.0);
  const double sine = largest_sine(pi * from, pi * to);
  return std::abs(h.amplitude) * sine * sine;
}
double largest(const Ramp& h, double duration) {
  return std::abs(h.amplitude) * std::clamp((duration - h.start) / h.duration, 0.0, 1.0);
}
double largest(const Harmonic& h, double duration) {
  if (h.start > duration) return 0;
  const auto phase = [&](double t) { return h.omega * std::max(0.0, t - h.start) + h.phase; };
  return std::abs(h.amplitude) * largest_sine(phase(0), phase(duration));
}
double largest(const Chirp& h, double duration) {
  const auto phase = [&](double t) {  // ascending in t
    const double tau = std::clamp(t - h.start, 0.0, h.duration);
    return tau * (h.omega0 + 0.5 * (h.omega1 - h.omega0) * tau / h.duration);
  };
  return std::abs(h.amplitude) * largest_sine(phase(0), phase(duration));
}
double largest(const Table& h, double duration) {  // of a chain of lines: at the ends of its pieces
  double result = 0;
  for (const auto& piece : segments(h, duration).pieces)
    result = std::max({result, std::abs(value(piece, piece.start)), std::abs(value(piece, piece.end))});
  return result;
}
double largest(const Expression& h, double duration) {
  return largest_size(evaluator(h), enclosure(h.formula), 0, duration);
}

std::vector<double> corners(const Step& h) { return {h.start}; }
std::vector<double> corners(const Harmonic& h) { return {h.start}; }
std::vector<double> corners(const Table& h) { return h.t; }
std::vector<double> corners(const Expression&) { return {}; }
template <class Limited>
std::vector<double> corners(const Limited& h) {
  return {h.start, h.start + h.duration};
}

}  // namespace

Segment rebased(const Segment& segment, double start, double end) {
  const double shift = start - segment.start;
  Segment result = {start, end, segment.c0 + segment.c1 * shift, segment.c1};
  if (segment.a == 0 && segment.b == 0) return result;
  const double cosine = std::cos(segment.omega * shift), sine = std::sin(segment.omega * shift);
  result.a = segment.a * cosine + segment.b * sine;
  result.b = segment.b * cosine - segment.a * sine;
  result.omega = segment.omega;
  return result;
}

std::vector<double> breakpoints(const History& history, double duration) {
  check(history, duration);
  auto times = std::visit([](const auto& h) { return corners(h); }, history);
  std::erase_if(times, [&](double t) { return !(t > 0 && t < duration); });
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

Segments segments(const History& history, double duration, double tolerance) {
  check(history, duration);
  require(positive(tolerance), "the tolerance of resampling must be positive");
  const auto chained = std::visit([&](const auto& h) { return chain(h, duration, tolerance); }, history);
  Segments result{{}, chained.load_error};
  double reached = 0;
  for (const auto& piece : chained.pieces) {
    const double start = std::max(piece.start, 0.0), end = std::min(piece.end, duration);
    if (!(start < end)) continue;
    if (start > reached) result.pieces.push_back({reached, start});
    result.pieces.push_back(rebased(piece, start, end));
    reached = end;
  }
  if (reached < duration) result.pieces.push_back({reached, duration});
  return result;
}

double end(const History& history, double duration) {
  const std::vector<Segment> pieces = segments(history, duration).pieces;
  const auto acts = [](const Segment& s) { return s.c0 != 0 || s.c1 != 0 || s.a != 0 || s.b != 0; };
  const auto last = std::find_if(pieces.rbegin(), pieces.rend(), acts);
  if (last == pieces.rbegin()) return std::numeric_limits<double>::infinity();
  return last == pieces.rend() ? 0 : last->end;
}

bool jumps(const History& history, double duration) {
  const double least = 1e-4 * peak(history, duration);
  double before = 0;
  for (const Segment& piece : segments(history, duration).pieces) {
    if (std::abs(value(piece, piece.start) - before) > least) return true;
    before = value(piece, piece.end);
  }
  return false;
}

double peak(const History& history, double duration) {
  check(history, duration);
  return std::visit([duration](const auto& h) { return largest(h, duration); }, history);
}

std::string expression_problem(const std::string& formula, double duration, const std::vector<double>& times) {
  if (!positive(duration)) return "the duration must be positive";
  try {
    const auto s = evaluator(Expression{formula});
    largest_size(s, enclosure(formula), 0, duration);
    for (const double t : times) s(t);
  } catch (const std::domain_error& error) {
    return error.what();
  }
  return {};
}

}  // namespace mb
