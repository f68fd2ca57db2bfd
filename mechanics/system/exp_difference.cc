#include "mechanics/system/exp_difference.h"

#include <algorithm>
#include <array>

namespace mb {
namespace {

using Complex = std::complex<double>;

// sinh(w)/w for |w| <= 1/2
Complex sinhc(Complex w) {
  constexpr std::array<double, 9> factors = {6, 20, 42, 72, 110, 156, 210, 272, 342};  // 2n (2n + 1), n = 1 ... 9
  const Complex x = w * w;
  Complex sum = 1;
  for (auto factor = factors.rbegin(); factor != factors.rend(); ++factor) sum = 1.0 + sum * x / *factor;
  return sum;
}

// Nodes at most 1 apart: exp[z] = e^mean sum_n h_n / (n + m - 1)!, where h_n, the complete symmetric polynomials of the
// m distances from the mean, obey h_n = e1 h_{n-1} - e2 h_{n-2} + e3 h_{n-3} - e4 h_{n-4}, e1 = 0.
template <std::size_t m>
Complex of_near_nodes(const std::array<Complex, m>& nodes) {
  Complex mean = 0;
  for (const Complex z : nodes) mean += z / static_cast<double>(m);
  std::array<Complex, m + 1> e{1};  // elementary symmetric polynomials
  for (const Complex z : nodes)
    for (std::size_t k = m; k >= 1; --k) e[k] += (z - mean) * e[k - 1];
  std::array<Complex, m> h{1};  // h_n, h_{n-1}, ...
  double factorial = 1;
  for (std::size_t k = 2; k < m; ++k) factorial *= static_cast<double>(k);
  Complex sum = 0;
  for (std::size_t n = 0; n < 22; ++n) {  // |h_n| <= C(n + m - 1, m - 1) (3/4)^n: the rest is below 1e-22
    sum += h[0] / factorial;
    factorial *= static_cast<double>(n + m);
    Complex next = 0;
    for (std::size_t k = 2; k <= m; ++k) next += (k % 2 == 0 ? -1.0 : 1.0) * e[k] * h[k - 1];
    std::rotate(h.begin(), h.end() - 1, h.end());
    h[0] = next;
  }
  return std::exp(mean) * sum;
}

// Puts the two nodes that are farthest apart first and last; their squared distance.
template <std::size_t m>
double spread(std::array<Complex, m>& nodes) {
  std::size_t first = 0, last = 1;
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = i + 1; j < m; ++j)
      if (std::norm(nodes[i] - nodes[j]) > std::norm(nodes[first] - nodes[last])) first = i, last = j;
  std::swap(nodes[first], nodes[0]);
  std::swap(nodes[last], nodes[m - 1]);  // last > first, and first has gone to 0: last has not been moved
  return std::norm(nodes[0] - nodes[m - 1]);
}

}  // namespace

Complex exp_difference(Complex a, Complex b) {
  if (std::norm(a - b) > 1) return (std::exp(a) - std::exp(b)) / (a - b);
  return std::exp(0.5 * (a + b)) * sinhc(0.5 * (a - b));
}

Complex exp_difference(Complex a, Complex b, Complex c) {
  std::array<Complex, 3> z = {a, b, c};
  if (spread(z) <= 1) return of_near_nodes(z);
  return (exp_difference(z[0], z[1]) - exp_difference(z[1], z[2])) / (z[0] - z[2]);
}

Complex exp_difference(Complex a, Complex b, Complex c, Complex d) {
  std::array<Complex, 4> z = {a, b, c, d};
  if (spread(z) <= 1) return of_near_nodes(z);
  return (exp_difference(z[0], z[1], z[2]) - exp_difference(z[1], z[2], z[3])) / (z[0] - z[3]);
}

}  // namespace mb
