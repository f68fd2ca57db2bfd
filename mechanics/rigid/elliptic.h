// Elliptic functions of real argument by arithmetic-geometric means (a, g) <- ((a + g)/2, sqrt(a g)) from (1, sqrt m1):
//
//   K = pi / 2M,   M = lim a,     sn' = cn dn,   cn' = -sn dn,   dn' = -m sn cn,     sn^2 + cn^2 = dn^2 + m sn^2 = 1
//
// Everything takes the complementary parameter m1 = 1 - m in [0, 1]: nothing is lost where m -> 1, K -> infinity.
// Parameters out of range, NaN among them, throw std::invalid_argument; a NaN for u comes back as NaN.
#pragma once

#include <array>

namespace mb {

struct Jacobi {
  double sn, cn, dn;  // [-]
};

// sn, cn, dn of one parameter. Relative accuracy of all three as long as |u| is not within rounding of a zero
// (Bulirsch 1965, Numerische Mathematik 7, 78-90: sums of positive terms only).
class JacobiFunctions {
 public:
  explicit JacobiFunctions(double m1);   // m1 in [0, 1]
  double mean() const { return mean_; }  // M = pi / 2K [-] in [0, 1]; 0 where m1 = 0
  Jacobi at(double u) const;             // |u| <= 2K, finite

 private:
  static constexpr int max_levels = 16;  // sqrt(m1) of the least double takes 14
  int n_ = 0;
  std::array<double, max_levels> a_{}, g_{};
  double mean_ = 0;
};

double agm(double a, double g);  // arithmetic-geometric mean of numbers >= 0

// R_F(x, y, z) = 1/2 int_0^inf dt / sqrt((t + x)(t + y)(t + z)), all >= 0, at most one 0 (Carlson; DLMF 19.16.1, by the
// duplication 19.26.18 and the series 19.36.1). F(phi | m) = sn R_F(cn^2, dn^2, 1).
double carlson_rf(double x, double y, double z);

// Mean over a period of sn^2 / (sn^2 + r cn^2), r > 0: the complete integral of the third kind,
// (1 - Pi(1 - 1/r | m)/K) / (1 - r), without its cancellation at r = 1. DLMF 19.8.7.
double mean_of_third_kind(double m1, double r);

// The argument of a theta function along a line beside the real axis, odd, of period 2K and within (-pi/2, pi/2):
//
//   chi(u) = arg theta_4(pi (u + i b) / 2K, q^2),   q = exp(-pi K'/K),   0 <= b <= K'
//
// by its series in q^2 or, where K > 2K', by Jacobi's imaginary transformation (DLMF 20.2.4, 20.7.33): three terms.
class ThetaArgument {
 public:
  ThetaArgument(double m, double m1, double b);  // m = 1 - m1 given as well, for small m
  double at(double u) const;                     // |u| <= K

 private:
  bool near_separatrix_;                           // K > 2K'
  double M_, M_dash_;                              // pi / 2K, pi / 2K'
  double slope_ = 0;                               // of the part of chi linear in u
  double outer_ = 0, inner_ = 0;                   // q^2 exp(+-pi b / K)
  double nome_ = 0;                                // exp(-pi K / 2K')
  std::array<double, 4> cos_{}, sin_{}, power_{};  // of (2n+1) pi b / 4K'; nome^(n^2 - n)
};

}  // namespace mb
