#include "mechanics/system/oscillator.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <stdexcept>

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

// phi1[z1, z2] and phi2[z1, z2] with tau = z1 + z2, delta = z1 z2, both |z| <= series_radius:
// phi_k[z1, z2] = sum_n h_n / (n + 1 + k)!, where h_n, the complete symmetric polynomials of z1 and z2, obey
// h_n = tau h_{n-1} - delta h_{n-2}. Real in every regime, and no difference of nearby numbers is formed.
struct Phi {
  double phi1, phi2;
};
Phi phi_series(double tau, double delta) {
  double h = 1, h_before = 0;
  Phi sum{0, 0};
  for (std::size_t n = 0; n + 3 < inverse_factorial.size(); ++n) {
    sum.phi1 += h * inverse_factorial[n + 2];
    sum.phi2 += h * inverse_factorial[n + 3];
    if ((std::abs(h) + std::abs(h_before)) * inverse_factorial[n + 2] < 1e-19) break;
    const double h_next = tau * h - delta * h_before;
    h_before = h;
    h = h_next;
  }
  return sum;
}

// phi1 and phi2 at one real z <= 0
Phi phi_at(double z) {
  if (z == 0) return {1, 0.5};
  const double phi1 = std::expm1(z) / z;
  if (z < -1) return {phi1, (phi1 - 1) / z};
  return {phi1, phi_series(z, 0).phi1};  // phi1[z, 0] = phi2(z)
}

// P and R of real roots z1 >= 2 z2, z2 < -series_radius: the terms differ by a factor of 1.5 at least.
Phi phi_of_far_roots(double z1, double z2) {
  const Phi a = phi_at(z1), b = phi_at(z2);
  return {(a.phi1 - b.phi1) / (z1 - z2), (a.phi2 - b.phi2) / (z1 - z2)};
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

// sinh(w)/w for |w| <= 1/2
Complex sinhc(Complex w) {
  const Complex x = w * w;
  Complex sum = 0;
  for (int n = 8; n >= 0; --n) sum = sum * x + inverse_factorial[static_cast<std::size_t>(2 * n + 1)];
  return sum;
}

Complex exp_difference(Complex a, Complex b) {  // exp[a, b]
  if (std::norm(a - b) > 1) return (std::exp(a) - std::exp(b)) / (a - b);
  return std::exp(0.5 * (a + b)) * sinhc(0.5 * (a - b));
}

// exp[a, b, c] of nodes at most 1 apart: Taylor about their mean, where the complete symmetric polynomials obey
// h_n = -e2 h_{n-2} + e3 h_{n-3} (e1 = 0)
Complex exp_of_near_nodes(Complex a, Complex b, Complex c) {
  const Complex mean = (a + b + c) / 3.0;
  const Complex x = a - mean, y = b - mean, z = c - mean;
  const Complex e2 = x * y + y * z + z * x, e3 = x * y * z;
  Complex h0 = 1, h1 = 0, h2 = 0, sum = 0;  // h_n, h_{n-1}, h_{n-2}
  for (std::size_t n = 0; n < 22; ++n) {    // |h_n| <= (n+2)(n+1)/2 (2/3)^n: the rest is below 1e-24
    sum += h0 * inverse_factorial[n + 2];
    const Complex h_next = -e2 * h1 + e3 * h2;
    h2 = h1;
    h1 = h0;
    h0 = h_next;
  }
  return std::exp(mean) * sum;
}

// exp[a, b, c]: divided by the largest separation, so that nothing cancels by more than that separation.
Complex exp_of_three_nodes(Complex a, Complex b, Complex c) {
  const double ab = std::norm(a - b), bc = std::norm(b - c), ca = std::norm(c - a);
  if (std::max({ab, bc, ca}) <= 1) return exp_of_near_nodes(a, b, c);
  if (ab >= bc && ab >= ca) std::swap(b, c);
  if (bc > ab && bc >= ca) std::swap(a, b);
  return (exp_difference(a, b) - exp_difference(b, c)) / (a - c);
}

// X and V = X' near resonance or at small t. V t = (z e^z)[x, y, z] = exp[x, y] + z exp[x, y, z] with z the least node.
HarmonicResponse near_resonance(const Roots& r, double Omega, double t) {
  std::array<Complex, 3> z = {Complex(-r.h, r.mu) * t, Complex(-r.h, -r.mu) * t, Complex(0, Omega * t)};
  if (!r.underdamped) z = {Complex(-r.slow * t), Complex(-r.fast * t), Complex(0, Omega * t)};
  const Complex X = exp_of_three_nodes(z[0], z[1], z[2]);
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

// Where the series does not reach, k P = 1 - C and k R = t - S - c P are free of cancellation: omega t >= sqrt(2).
Response response(const Roots& r, double t) {
  Response x = r.underdamped ? free_underdamped(r, t) : free_overdamped(r, t);
  const double c = 2 * r.h, z_fast = (r.underdamped ? r.omega : r.fast) * t;
  if (z_fast <= series_radius || 2 * r.slow < r.fast) {
    const Phi phi =
        z_fast <= series_radius ? phi_series(-c * t, r.k * t * t) : phi_of_far_roots(-r.slow * t, -r.fast * t);
    x.P = t * t * phi.phi1;
    x.R = t * t * t * phi.phi2;
  } else {
    x.P = (1 - x.C) / r.k;
    x.R = (t - x.S - c * x.P) / r.k;
  }
  return x;
}

Response response(const Oscillator& oscillator, double t) { return response(roots(oscillator), t); }

Response response(double omega, double zeta, double t) {
  const double k = omega * omega;
  return response(Roots({k, 2 * zeta * omega}, omega, k * ((zeta - 1) * (zeta + 1))), t);
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

HarmonicResponse harmonic_response(const Oscillator& oscillator, double Omega, double t) {
  const Roots r = roots(oscillator);
  return harmonic_response(r, response(r, t), Omega, t);
}

Phase propagate(const Roots& r, const Phase& state0, double f, const Segment& segment, double tau) {
  const Response x = response(r, tau);
  Phase state = {state0.q * x.C + state0.v * x.S, state0.q * x.C_dot + state0.v * x.S_dot};
  state.q += f * (segment.c0 * x.P + segment.c1 * x.R);
  state.v += f * (segment.c0 * x.S + segment.c1 * x.P);
  if (segment.a == 0 && segment.b == 0) return state;
  const HarmonicResponse y = harmonic_response(r, x, segment.omega, tau);
  state.q += f * (segment.a * y.q_cos + segment.b * y.q_sin);
  state.v += f * (segment.a * y.v_cos + segment.b * y.v_sin);
  return state;
}

Phase propagate(const Oscillator& oscillator, const Phase& state0, double f, const Segment& segment, double tau) {
  return propagate(roots(oscillator), state0, f, segment, tau);
}

}  // namespace mb
