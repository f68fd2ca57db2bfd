#include "cases/exact/sphere_on_plane.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <stdexcept>

#include "mechanics/geometry/gauss.h"

namespace mb {
namespace {

constexpr int n_octaves = 3;

void check(double a, const CapSeries& series) {
  if (!(a >= 0.002 && a <= 0.5))
    throw std::invalid_argument(fmt::format("sphere_on_plane: a/R must lie in [0.002, 0.5], not {}", a));
  if (series.n_functions < 1 || series.n_functions > 8 || !(series.phase >= 50 && series.phase <= 5000))
    throw std::invalid_argument(fmt::format("sphere_on_plane: {} functions in [1, 8], phase {} in [50, 5000]",
                                            series.n_functions, series.phase));
}

// Quadrature on the cap in w, r dr = -a^2 w dw, in which w^(2i+1) P_n w is even and entire: the positive half of a
// Gauss rule on [-1, 1], with points for the oscillation of P_n, whose phase is at most n a/R.
struct Cap {
  VectorXd cosine, sine;  // of theta, M points
  MatrixXd weight;        // [R^2] w^(2i+1) dA, functions (i = -1 first) x points
  int n_terms;

  Cap(double a, const CapSeries& series) : n_terms(static_cast<int>(std::ceil(series.phase / std::asin(a)))) {
    const int M = static_cast<int>(series.phase / 3) + 30;
    const Rule rule = gauss_legendre(2 * M);
    const Eigen::ArrayXd w = 2 * rule.x.tail(M).array() - 1;
    sine = a * (1 - w.square()).sqrt();
    cosine = (1 - sine.array().square()).sqrt();
    weight.resize(series.n_functions + 1, M);
    for (int i = 0; i <= series.n_functions; ++i)
      weight.row(i) = 2 * pi * a * a * 2 * rule.w.tail(M).array() * w.pow(2 * i);
  }
};

// P_n(x) and P_n-1(x) at many x, n = 0, 1, 2 ... by Bonnet's recurrence.
struct Legendre {
  Eigen::ArrayXd x, before, now, next;

  explicit Legendre(const VectorXd& at)
      : x(at), before(Eigen::ArrayXd::Zero(at.size())), now(Eigen::ArrayXd::Ones(at.size())), next(at.size()) {}

  void advance(int n) {
    next = ((2 * n + 1) * x * now - n * before) / (n + 1);
    before.swap(now);
    now.swap(next);
  }
};

// Legendre coefficients of each function as a traction, by order: visit(n, t_n, s_n).
template <typename Visit>
void for_each_order(const Cap& cap, PressureAlong along, const Visit& visit) {
  const bool tilted = along == PressureAlong::plane_normal;
  Legendre P(cap.cosine);
  VectorXd sampled(cap.cosine.size()), t(cap.weight.rows()), s = VectorXd::Zero(cap.weight.rows());
  for (int n = 0; n < cap.n_terms; ++n, P.advance(n - 1)) {
    const double per_area = (2 * n + 1) / (4 * pi);
    if (tilted)
      sampled = -P.x * P.now;  // the sphere's area is that of the plane over cos(theta), the normal part cos(theta)
    else
      sampled = -P.now;
    t.noalias() = per_area * (cap.weight * sampled);
    if (tilted && n > 0) {
      sampled = n * (P.x * P.now - P.before);  // sin(theta) dP_n/dtheta
      s.noalias() = per_area / (n * (n + 1.0)) * (cap.weight * sampled);
    }
    visit(n, t, s);
  }
}

// 1 up to the middle of the octave below n_terms, then smoothly to 0.
double cut_off(double n, double n_terms) {
  const double x = 2 * n / n_terms - 1;
  return x <= 0 ? 1 : x >= 1 ? 0 : 1 / (1 + std::exp(1 / (1 - x) - 1 / x));
}

// sum_n of what falls like n^-4 and n^-6 beside oscillations, from sums cut at N, N/2, N/4.
template <typename Sum>
Sum extrapolated(const std::array<Sum, n_octaves>& sums) {
  const Sum fine = sums[0] + (sums[0] - sums[1]) / 7, rough = sums[1] + (sums[1] - sums[2]) / 7;
  return fine + (fine - rough) / 31;
}

// Products <w^(2i+1), u_z(w^(2j+1))> [R^5/E*], symmetric.
MatrixXd products(const Cap& cap, double nu) {
  const Index n_functions = cap.weight.rows();
  std::array<MatrixXd, n_octaves> sums;
  sums.fill(MatrixXd::Zero(n_functions, n_functions));
  MatrixXd term(n_functions, n_functions);
  for_each_order(cap, PressureAlong::plane_normal, [&](int n, const VectorXd& t, const VectorXd& s) {
    const Eigen::Matrix2d C = surface_compliance(n, nu) / ((1 - nu) * (1 + nu));
    const double norm = 4 * pi / (2 * n + 1), both = C(0, 1) + n * (n + 1.0) * C(1, 0);
    term.noalias() = norm * C(0, 0) * t * t.transpose();
    term.noalias() += norm * both / 2 * (t * s.transpose() + s * t.transpose());
    term.noalias() += norm * n * (n + 1.0) * C(1, 1) * s * s.transpose();
    for (int octave = 0; octave < n_octaves; ++octave)
      sums[octave] += cut_off(n + 0.5, std::ldexp(cap.n_terms, -octave)) * term;
  });
  return extrapolated(sums);
}

}  // namespace

SphereOnPlane sphere_on_plane(double a, double nu, const CapSeries& series) {
  check(a, series);
  const Cap cap(a, series);
  const Index n = series.n_functions;
  const MatrixXd A = products(cap, nu);
  const VectorXd area = cap.weight.rowwise().sum();
  const VectorXd gap = cap.weight * VectorXd(cap.sine.array().square() / (1 + cap.cosine.array()));
  MatrixXd equations(n + 1, n + 1);  // sum_j A_ij c_j - area_i delta = -gap_i
  equations << A.rightCols(n), -area;
  const VectorXd scale = area.cwiseInverse();
  const VectorXd solution = (scale.asDiagonal() * equations).fullPivLu().solve(-scale.cwiseProduct(gap));
  const VectorXd c = solution.head(n);
  return {a, area.tail(n).dot(c), solution[n], 0.5 * c.dot(A.bottomRightCorner(n, n) * c), c};
}

// The cut-off leaves the displacement at r smooth to phase |1 - r/a|; u_z = u_r cos(theta) - u_theta sin(theta).
VectorXd gap_to_plane(const SphereOnPlane& contact, double nu, const VectorXd& r, const CapSeries& series) {
  check(contact.contact_radius, series);
  if (!(r.array() >= 0 && r.array() < 1).all()) throw std::invalid_argument("gap_to_plane: r/R must lie in [0, 1)");
  if (contact.pressure.size() != series.n_functions)
    throw std::invalid_argument("gap_to_plane: the pressure has another number of functions");
  const Cap cap(contact.contact_radius, series);
  const Eigen::ArrayXd sine = r, cosine = (1 - sine.square()).sqrt();
  Legendre P(cosine);
  Eigen::ArrayXd gap = sine.square() / (1 + cosine) - contact.approach;
  for_each_order(cap, PressureAlong::plane_normal, [&](int n, const VectorXd& t, const VectorXd& s) {
    const Eigen::Vector2d traction(t.tail(contact.pressure.size()).dot(contact.pressure),
                                   s.tail(contact.pressure.size()).dot(contact.pressure));
    const Eigen::Vector2d u =
        cut_off(n + 0.5, cap.n_terms) / ((1 - nu) * (1 + nu)) * (surface_compliance(n, nu) * traction);
    gap -= u[0] * cosine * P.now - u[1] * n * (cosine * P.now - P.before);
    P.advance(n);
  });
  return gap;
}

double approach_over_hertz(const SphereOnPlane& contact) {
  return contact.approach / std::pow(0.75 * contact.force, 2.0 / 3);
}

// At the pole P_n = 1; terms oscillate without a part that has one sign. With p_0 = 2 a/pi, delta_H = a^2.
double hertzian_approach(double a, double nu, PressureAlong along, const CapSeries& series) {
  check(a, series);
  const Cap cap(a, series);
  double sum = 0;
  for_each_order(cap, along, [&](int n, const VectorXd& t, const VectorXd& s) {
    const Eigen::Matrix2d C = surface_compliance(n, nu) / ((1 - nu) * (1 + nu));
    sum -= cut_off(n + 0.5, cap.n_terms) * (C(0, 0) * t[1] + C(0, 1) * s[1]);
  });
  return 2 / (pi * a) * sum;
}

}  // namespace mb
