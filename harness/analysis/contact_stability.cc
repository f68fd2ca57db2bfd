#include "harness/analysis/contact_stability.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

#include "mechanics/system/one_step.h"
#include "mechanics/system/oscillator.h"

namespace mb {
namespace {

constexpr double grows = 1 + 1e-6;  // rounding of eigenvalues, of which rigid modes are double: sqrt(eps)
constexpr double widest = 0.06, narrowest = 1e-7;  // [-] windows that are looked for one by one
constexpr double scanned = 1.03;                   // [-] from step to step, which wider ones cannot escape

constexpr double unbounded = std::numeric_limits<double>::infinity();

CoupledModes coupled(const PressedModes& p, double h) {
  return {MatrixXd(p.lambda.asDiagonal()) + p.stiffness(h) * p.g * p.g.transpose(), p.c.asDiagonal()};
}

// The least h = limit(h) of one that grows with h, from below.
template <class Limit>
double least_fixed_point(const Limit& limit) {
  double h = limit(0.0);
  for (int i = 0; i < 1000 && h > 0 && std::isfinite(h); ++i) {
    const double next = limit(h);
    if (!(next > h * (1 + 1e-9))) return h;
    h = next;
  }
  return h;
}

// Half a kick by contact alone, closed form without it, half a kick; (s q, v) as of one_step.
MatrixXd kick_drift_kick(const PressedModes& p, double h) {
  const Index n = p.g.size();
  const VectorXd s = energy_scales(coupled(p, h).K, h);
  MatrixXd kick = MatrixXd::Identity(2 * n, 2 * n), drift = MatrixXd::Zero(2 * n, 2 * n);
  kick.bottomLeftCorner(n, n) = -h / 2 * p.stiffness(h) * p.g * p.g.cwiseQuotient(s).transpose();
  for (Index i = 0; i < n; ++i) {
    const Response r = response(roots({p.lambda[i], p.c[i]}), h);
    drift(i, i) = r.C, drift(i, n + i) = s[i] * r.S;
    drift(n + i, i) = r.C_dot / s[i], drift(n + i, n + i) = r.S_dot;
  }
  return kick * drift * kick;
}

// Of modes alike in lambda and c contact presses one combination, the others keep to themselves: of rigid modes, which
// are up to twelve, one is left.
PressedModes combined(const PressedModes& p) {
  std::map<std::pair<double, double>, double> squares;
  for (Index i = 0; i < p.g.size(); ++i) squares[{p.lambda[i], p.c[i]}] += p.g[i] * p.g[i];
  const auto n = static_cast<Index>(squares.size());
  PressedModes one{VectorXd(n), VectorXd(n), VectorXd(n), p.kappa, p.yields};
  Index i = 0;
  for (const auto& [of, square] : squares) {
    std::tie(one.lambda[i], one.c[i]) = of;
    one.g[i++] = std::sqrt(square);
  }
  return one;
}

// Ascending, from first to last.
std::vector<double> apart_by(double ratio, double first, double last) {
  std::vector<double> all{first};
  while (all.back() < last) all.push_back(std::min(last, all.back() * ratio));
  return all;
}

}  // namespace

double PressedModes::stiffness(double h) const {
  double yielding = 0;
  for (const StaticYield& of : yields) yielding += of.beta > 0 ? of.c / (1 + 4 * of.beta / h) : of.c;
  return kappa / (1 + kappa * yielding);
}

double pressed_radius(const PressedModes& pressed, const std::string& scheme, double h) {
  if (scheme == "exact") return spectral_radius(kick_drift_kick(pressed, h));
  return spectral_radius(one_step(coupled(pressed, scheme == "explicit-euler" ? unbounded : h), scheme, h));
}

double opening_gain(double kappa, double m, double h) {
  const double g = kappa * h * h / (4 * m);
  return g < 1 ? g / (1 - g) : std::numeric_limits<double>::infinity();
}

double opening_limit(double kappa, double m, double gain) { return std::sqrt(4 * m / kappa * gain / (1 + gain)); }

double opening_limit(const PressedModes& pressed, double m, double gain) {
  return least_fixed_point([&](double h) { return opening_limit(pressed.stiffness(h), m, gain); });
}

std::vector<double> resonances(const PressedModes& p, double most) {
  std::vector<double> all;
  const VectorXd omega = p.lambda.cwiseSqrt();
  for (Index i = 0; i < omega.size(); ++i)
    for (Index j = i; j < omega.size(); ++j) {
      if (!(omega[i] > 0 && omega[j] > 0)) continue;
      const double w = p.stiffness(unbounded) * std::abs(p.g[i] * p.g[j]) / std::sqrt(omega[i] * omega[j]);
      const double width = 2 * w / (omega[i] + omega[j]);
      if (width < narrowest || width > widest || w < std::sqrt(p.c[i] * p.c[j])) continue;
      const auto stiffened = [&](Index k) {
        return omega[k] + p.stiffness(unbounded) * p.g[k] * p.g[k] / (2 * omega[k]);
      };
      const double h = 2 * pi / (stiffened(i) + stiffened(j));
      for (double k = 1; k * h < most; ++k) all.push_back(k * h);
    }
  std::ranges::sort(all);
  return all;
}

double pressed_limit(const PressedModes& pressed, const std::string& scheme, double most) {
  if (scheme == "explicit-euler") return stable_step(coupled(pressed, unbounded), scheme);
  if (scheme != "exact") return least_fixed_point([&](double h) { return stable_step(coupled(pressed, h), scheme); });
  const PressedModes together = combined(pressed);
  const auto stable = [&](double h) { return spectral_radius(kick_drift_kick(together, h)) <= grows; };
  const double first = 1e-4 * most;
  std::vector<double> tried = apart_by(scanned, first, most);
  std::ranges::copy(resonances(pressed, most), std::back_inserter(tried));
  std::ranges::sort(tried);
  double low = first;
  for (double high : tried) {
    if (high < first || stable(high)) {
      low = std::max(first, high);
      continue;
    }
    while (high > low * 1.001) {
      const double middle = std::sqrt(low * high);
      (stable(middle) ? low : high) = middle;
    }
    return high;
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace mb
