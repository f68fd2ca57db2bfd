#include "mechanics/history/history.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <tuple>

#include "mechanics/history/expression.h"
#include "mechanics/types.h"

namespace mb {
namespace {

double at(const Step& h, double t) { return t >= h.start ? h.amplitude : 0; }

double at(const Pulse& h, double t) {
  if (t < h.start || t >= h.start + h.duration) return 0;
  const double sine = std::sin(pi * (t - h.start) / h.duration);
  return h.amplitude * sine * sine;
}

double at(const Ramp& h, double t) {
  if (t < h.start) return 0;
  return t < h.start + h.duration ? h.amplitude * (t - h.start) / h.duration : h.amplitude;
}

double at(const Harmonic& h, double t) {
  return t >= h.start ? h.amplitude * std::sin(h.omega * (t - h.start) + h.phase) : 0;
}

double at(const Chirp& h, double t) {
  if (t < h.start || t >= h.start + h.duration) return 0;
  const double tau = t - h.start;
  return h.amplitude * std::sin(tau * (h.omega0 + 0.5 * (h.omega1 - h.omega0) * tau / h.duration));
}

double at(const Table& h, double t) {
  if (h.t.empty() || t < h.t.front() || t >= h.t.back()) return 0;
  const auto after = static_cast<std::size_t>(std::upper_bound(h.t.begin(), h.t.end(), t) - h.t.begin());
  const double t0 = h.t[after - 1], s0 = h.s[after - 1];
  return s0 + (h.s[after] - s0) * ((t - t0) / (h.t[after] - t0));
}

double at(const Expression& h, double t) { return Formula(h.formula)(t); }

template <class H>
std::function<double(double)> function_of(const H& h) {
  return [h](double t) { return at(h, t); };
}

std::function<double(double)> function_of(const Expression& h) {
  return [formula = std::make_shared<const Formula>(h.formula)](double t) { return (*formula)(t); };
}

}  // namespace

bool operator==(const Step& a, const Step& b) {
  return std::tie(a.amplitude, a.start) == std::tie(b.amplitude, b.start);
}
bool operator==(const Pulse& a, const Pulse& b) {
  return std::tie(a.duration, a.amplitude, a.start) == std::tie(b.duration, b.amplitude, b.start);
}
bool operator==(const Ramp& a, const Ramp& b) {
  return std::tie(a.duration, a.amplitude, a.start) == std::tie(b.duration, b.amplitude, b.start);
}
bool operator==(const Harmonic& a, const Harmonic& b) {
  return std::tie(a.omega, a.phase, a.amplitude, a.start) == std::tie(b.omega, b.phase, b.amplitude, b.start);
}
bool operator==(const Chirp& a, const Chirp& b) {
  return std::tie(a.omega0, a.omega1, a.duration, a.amplitude, a.start) ==
         std::tie(b.omega0, b.omega1, b.duration, b.amplitude, b.start);
}
bool operator==(const Table& a, const Table& b) { return a.t == b.t && a.s == b.s; }
bool operator==(const Expression& a, const Expression& b) { return a.formula == b.formula; }

double value(const Segment& segment, double t) {
  const double tau = t - segment.start, line = segment.c0 + segment.c1 * tau;
  if (segment.a == 0 && segment.b == 0) return line;
  return line + segment.a * std::cos(segment.omega * tau) + segment.b * std::sin(segment.omega * tau);
}

double value(const History& history, double t) {
  return std::visit([t](const auto& h) { return at(h, t); }, history);
}

std::function<double(double)> evaluator(const History& history) {
  return std::visit([](const auto& h) { return function_of(h); }, history);
}

}  // namespace mb
