#include "mechanics/system/oscillator.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <optional>
#include <stdexcept>

#include "mechanics/system/exp_difference.h"

namespace mb {
namespace {

using Complex = std::complex<double>;

// 1/n!, n = 0 ... 39
constexpr std::array<double, 40> inverse_factorial = [] {
  std::array<double, 40> table{};
  double factorial = 1;
  for (std::size_t n = 0; n < table.size(); ++n) {
    if (n > 0) factorial *= static_cast<double>(n);
    table[n] = 1 / factorial;
  }
  return table;
}();

constexpr double series_radius = 2;  // largest |z| of the Taylor series: 30 terms, and P, R lose at most a digit

// phi1, phi2 and phi3 of [z1, z2] with tau = z1 + z2, delta = z1 z2, both |z| <= series_radius:
// phi_k[z1, z2] = sum_n h_n / (n + 1 + k)!, where h_n, the complete symmetric polynomials of z1 and z2, obey
// h_n = tau h_{n-1} - delta h_{n-2}. Real in every regime, and no difference of nearby numbers is formed.
struct Phi {
  double phi1, phi2, phi3;
};
Phi phi_series(double tau, double delta) {
  double h = 1, h_before = 0;
  Phi sum{0, 0, 0};
  for (std::size_t n = 0; n + 4 < inverse_factorial.size(); ++n) {
    sum.phi1 += h * inverse_factorial[n + 2];
    sum.phi2 += h * inverse_factorial[n + 3];
    sum.phi3 += h * inverse_factorial[n + 4];
    if ((std::abs(h) + std::abs(h_before)) * inverse_factorial[n + 2] < 1e-19) break;
    const double h_next = tau * h - delta * h_before;
    h_before = h;
    h = h_next;
  }
  return sum;
}

// phi1, phi2 and phi3 at one real z <= 0
Phi phi_at(double z) {
  if (z == 0) return {1, 1.0 / 2, 1.0 / 6};
  const double phi1 = std::expm1(z) / z;
  if (z < -1) return {phi1, (phi1 - 1) / z, ((phi1 - 1) / z - 0.5) / z};
  const Phi with_zero = phi_series(z, 0);  // phi_k[z, 0] = phi_{k+1}(z)
  return {phi1, with_zero.phi1, with_zero.phi2};
}

// Real roots z1 >= 2 z2, z2 < -series_radius: the terms differ by a factor of 1.5 at least.
Phi phi_of_far_roots(double z1, double z2) {
  const Phi a = phi_at(z1), b = phi_at(z2);
  return {(a.phi1 - b.phi1) / (z1 - z2), (a.phi2 - b.phi2) / (z1 - z2), (a.phi3 - b.phi3) / (z1 - z2)};
}

// The divided differences where they are needed. Elsewhere k P = 1 - C, k R = t - S - c P and k T = t^2/2 - P - c R are
// free of cancellation: omega t >= sqrt(2).
std::optional<Phi> phi_where_needed(const Roots& r, double t) {
  const double z_fast = (r.underdamped ? r.omega : r.fast) * t;
  if (z_fast <= series_radius) return phi_series(-2 * r.h * t, r.k * t * t);
  if (2 * r.slow < r.fast) return phi_of_far_roots(-r.slow * t, -r.fast * t);
  return std::nullopt;
}

Response free_underdamped(const Roots& r, double t) {
  const double decay = std::exp(-r.h * t), x = r.mu * t;
  const double cosine = decay * std::cos(x), S = decay * std::sin(x) / r.mu;
  return {cosine + r.h * S, -r.k * S, S, cosine - r.h * S, 0, 0};
}

// exp[z1, z2] = e^{z1} (1 - e^{-2d})/(2d), 2d = z1 - z2 >= 0: cannot overflow, however stiff
Response free_overdamped(const Roots& r, double t) {
  const double slow = std::exp(-r.slow * t), gap = 2 * r.mu * t;
  const double S = t * slow * (gap > 0 ? -std::expm1(-gap) / gap : 1.0);
  return {slow + r.slow * S, -r.k * S, S, std::exp(-r.fast * t) - r.slow * S, 0, 0};
}

std::array<Complex, 3> nodes(const Roots& r, double Omega, double t) {
  if (!r.underdamped) return {Complex(-r.slow * t), Complex(-r.fast * t), Complex(0, Omega * t)};
  return {Complex(-r.h, r.mu) * t, Complex(-r.h, -r.mu) * t, Complex(0, Omega * t)};
}

// X and V = X' near resonance or at small t. V t = (z e^z)[x, y, z] = exp[x, y] + z exp[x, y, z] with z the least node.
HarmonicResponse near_resonance(const Roots& r, double Omega, double t) {
  auto z = nodes(r, Omega, t);
  const Complex X = exp_difference(z[0], z[1], z[2]);
  std::sort(z.begin(), z.end(), [](Complex a, Complex b) { return std::norm(a) > std::norm(b); });
  const Complex V = exp_difference(z[0], z[1]) + z[2] * X;
  return {t * t * X.real(), t * t * X.imag(), t * V.real(), t * V.imag()};
}

}  // namespace

Roots::Roots(const Oscillator& oscillator, double omega_, double discriminant)
    : k(oscillator.k),
      omega(omega_),
      h(oscillator.c / 2),
      mu(std::sqrt(std::abs(discriminant))),
      slow(h),
      fast(h),
      underdamped(discriminant < 0) {
  if (!(k >= 0 && h >= 0 && std::isfinite(discriminant)))
    throw std::invalid_argument(fmt::format("oscillator: k = {}, c = {} must be finite and not negative", k, 2 * h));
  if (underdamped) return;
  fast = h + mu;
  slow = fast > 0 ? k / fast : 0;
}

Roots roots(const Oscillator& oscillator) {
  const double h = oscillator.c / 2;  // one rounding for the whole discriminant: near-critical roots stay sharp
  return {oscillator, std::sqrt(oscillator.k), std::fma(h, h, -oscillator.k)};
}

Response response(const Roots& r, double t) {
  Response x = r.underdamped ? free_underdamped(r, t) : free_overdamped(r, t);
  if (const auto phi = phi_where_needed(r, t)) {
    x.P = t * t * phi->phi1;
    x.R = t * t * t * phi->phi2;
  } else {
    x.P = (1 - x.C) / r.k;
    x.R = (t - x.S - 2 * r.h * x.P) / r.k;
  }
  return x;
}

Response integral(const Roots& r, const Response& x, double t) {
  const double c = 2 * r.h, half = t * t / 2;
  const auto phi = phi_where_needed(r, t);
  const double T = phi ? half * (2 * t * t * phi->phi3) : (half - x.P - c * x.R) / r.k;
  return {x.S + c * x.P, -r.k * x.P, x.P, x.S, x.R, T};
}

// Away from the roots, X = (e^{i Omega t} - C - i Omega S) / (k - Omega^2 + i c Omega), whose denominator is
// (i Omega - lambda1)(i Omega - lambda2); both factors times t are to be at least 1, else the numerator cancels.
HarmonicResponse harmonic_response(const Roots& r, const Response& free, double Omega, double t) {
  const double shift = r.underdamped ? r.mu - std::abs(Omega) : std::abs(Omega), slow = r.slow;
  if ((slow * slow + shift * shift) * t * t < 1) return near_resonance(r, Omega, t);
  const double re = (r.omega - Omega) * (r.omega + Omega), im = 2 * r.h * Omega;
  const double scale = 1 / (re * re + im * im), g_re = re * scale, g_im = -im * scale;
  const double cosine = std::cos(Omega * t), sine = std::sin(Omega * t);
  const double x_re = cosine - free.C, x_im = sine - Omega * free.S;
  const double v_re = -Omega * sine - free.C_dot, v_im = Omega * (cosine - free.S_dot);
  return {g_re * x_re - g_im * x_im, g_re * x_im + g_im * x_re, g_re * v_re - g_im * v_im, g_re * v_im + g_im * v_re};
}

// int X = t^3 exp[z1, z2, i Omega t, 0] = (X - P) / (i Omega), where the last two nodes are not too near.
HarmonicResponse integral(const Roots& r, const Response& free, const HarmonicResponse& wave, double Omega, double t) {
  if (std::abs(Omega * t) >= 1) return {wave.q_sin / Omega, (free.P - wave.q_cos) / Omega, wave.q_cos, wave.q_sin};
  const auto z = nodes(r, Omega, t);
  const Complex Y = t * t * t * exp_difference(z[0], z[1], z[2], 0);
  return {Y.real(), Y.imag(), wave.q_cos, wave.q_sin};
}

}  // namespace mb
