#include "mechanics/geometry/superquadric_chart.h"

#include <algorithm>
#include <cmath>

namespace mb {

namespace {

constexpr double least_power = 1e-15;

// The parts of two weights in their sum, of which only logarithms are known where both underflow: gradient_weight /
// point_weight = power c^(p-2) r^(q-2).
ChartTangent with_parts(ChartTangent t, double power, double log_rest) {
  const double sum = t.point_weight + t.gradient_weight;
  if (sum > 1e-290) {
    t.point_part = t.point_weight / sum;
    t.gradient_part = t.gradient_weight / sum;
  } else {
    t.point_part = 1 / (1 + std::exp(std::min(std::log(power) + log_rest, 700.0)));
    t.gradient_part = 1 - t.point_part;
  }
  return t;
}

double log_norm(double log_a, double log_b, double p) {
  const double larger = std::max(log_a, log_b);
  return larger + std::log1p(std::exp(-p * std::abs(log_a - log_b))) / p;
}

}  // namespace

Ratios ratios(double l, double power) {
  const double t = std::abs(l), lesser = std::exp(-t), dual = power == 1 ? lesser : std::exp(-power * t);
  const double z = lesser * dual, share = 1 / (1 + z);
  const double larger = power == 1 ? std::sqrt(share) : std::exp(-std::log1p(z) / (1 + power));
  const double larger_dual = share / larger;
  if (l < 0) return {larger * lesser, larger, larger_dual * dual, larger_dual, z * share, share};
  return {larger, larger * lesser, larger_dual, larger_dual * dual, share, z * share};
}

OctantChart::OctantChart(const Superquadric& body)
    : unit(body.semi_axes.maxCoeff()),
      a(body.semi_axes / unit),
      power_p(std::max(2 / body.e2 - 1, least_power)),
      power_q(std::max(2 / body.e1 - 1, least_power)) {}

ChartPoint OctantChart::at(double sigma, double tau) const {
  const Ratios in = ratios(sigma, power_p), out = ratios(tau, power_q);
  const Vector3d x(a[0] * out.first * in.first, a[1] * out.first * in.second, a[2] * out.second);
  const Vector3d gradient(out.dual_first * in.dual_first / a[0], out.dual_first * in.dual_second / a[1],
                          out.dual_second / a[2]);
  const double slope = gradient.norm();
  return {sigma, tau, in, out, x, gradient / slope, slope};
}

ChartPoint OctantChart::on_ray(const Vector3d& x) const {
  const double u = std::log(x[0] / a[0]), v = std::log(x[1] / a[1]), w = std::log(x[2] / a[2]);
  return at(u - v, log_norm(u, v, 1 + power_p) - w);
}

ChartTangent OctantChart::by_sigma(const ChartPoint& p) const {
  const Ratios &in = p.across, &out = p.along;
  const double log_rest = (power_q - 1) * std::min(p.tau, 0.0) - (power_p - 1) * std::abs(p.sigma);
  const bool first = p.sigma < 0;  // the lesser
  const Vector3d point = first ? Vector3d(a[0] * in.share_second, -a[1] * in.second * in.dual_first, 0)
                               : Vector3d(a[0] * in.first * in.dual_second, -a[1] * in.share_first, 0);
  const Vector3d gradient = first ? Vector3d(in.share_second / a[0], -in.dual_second * in.first / a[1], 0)
                                  : Vector3d(in.dual_first * in.second / a[0], -in.share_first / a[1], 0);
  return with_parts({point, gradient, out.first * (first ? in.first : in.second),
                     power_p * out.dual_first * (first ? in.dual_first : in.dual_second), 0, 0},
                    power_p, log_rest);
}

ChartTangent OctantChart::by_tau(const ChartPoint& p) const {
  const Ratios &in = p.across, &out = p.along;
  const double log_rest = -(power_q - 1) * std::abs(p.tau);
  if (p.tau < 0)
    return with_parts(
        {{a[0] * in.first * out.share_second, a[1] * in.second * out.share_second, -a[2] * out.second * out.dual_first},
         {in.dual_first * out.share_second / a[0], in.dual_second * out.share_second / a[1],
          -out.dual_second * out.first / a[2]},
         out.first,
         power_q * out.dual_first,
         0,
         0},
        power_q, log_rest);
  return with_parts({{a[0] * in.first * out.first * out.dual_second, a[1] * in.second * out.first * out.dual_second,
                      -a[2] * out.share_first},
                     {out.dual_first * in.dual_first * out.second / a[0],
                      out.dual_first * in.dual_second * out.second / a[1], -out.share_first / a[2]},
                     out.second,
                     power_q * out.dual_second,
                     0,
                     0},
                    power_q, log_rest);
}

}  // namespace mb
