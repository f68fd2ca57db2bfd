#include "mechanics/contact/law.h"

#include <cmath>

namespace mb {

namespace {

// - mu p s, s = v_t / sqrt(|v_t|^2 + v_eps^2), and what it adds to the derivatives. dn: derivative of the normal by x.
void add_friction(Traction3& out, const Friction& friction, const Gap& gap, const Vector3d& v,
                  const Vector3d& pressure_by_x, const Vector3d& pressure_by_v) {
  const Vector3d& n = gap.normal;
  const double v_n = n.dot(v);
  const Vector3d slip = v - v_n * n;
  const double size = std::sqrt(slip.squaredNorm() + friction.slip_speed * friction.slip_speed);
  const Vector3d s = slip / size;
  const Eigen::Matrix3d s_by_slip = (Eigen::Matrix3d::Identity() - s * s.transpose()) / size;
  const Eigen::Matrix3d tangential = Eigen::Matrix3d::Identity() - n * n.transpose();
  const Eigen::Matrix3d slip_by_x = -(v_n * gap.hessian + n * (gap.hessian * v).transpose());
  const double mu = friction.coefficient;
  out.t -= mu * out.pressure * s;
  out.by_x -= mu * (s * pressure_by_x.transpose() + out.pressure * s_by_slip * slip_by_x);
  out.by_v -= mu * (s * pressure_by_v.transpose() + out.pressure * s_by_slip * tangential);
}

}  // namespace

Traction3 contact_traction(const PenaltyLaw& law, const Gap& gap, const Vector3d& v) {
  Traction3 out;
  const double g = -gap.value;
  if (!(g > 0)) return out;
  const double rate = -gap.normal.dot(v), damped = 1 + law.damping * rate;
  if (!(damped > 0)) return out;
  const auto [elastic, by_gap] = layer(law, gap.value);
  out.pressure = elastic * damped;
  out.t = out.pressure * gap.normal;
  const Vector3d pressure_by_x = by_gap * damped * gap.normal - elastic * law.damping * (gap.hessian * v);
  const Vector3d pressure_by_v = -elastic * law.damping * gap.normal;
  out.by_x = gap.normal * pressure_by_x.transpose() + out.pressure * gap.hessian;
  out.by_v = gap.normal * pressure_by_v.transpose();
  if (law.friction) add_friction(out, *law.friction, gap, v, pressure_by_x, pressure_by_v);
  return out;
}

Layer layer(const PenaltyLaw& law, double gap) {
  if (!(gap < 0)) return {0, 0};
  if (law.exponent == 1) return {-law.stiffness * gap, -law.stiffness};
  const double power = law.stiffness * std::pow(-gap, law.exponent - 1);
  return {-power * gap, -law.exponent * power};
}

double stored_energy(const PenaltyLaw& law, double gap) {
  if (!(gap < 0)) return 0;
  return -layer(law, gap).pressure * gap / (law.exponent + 1);
}

}  // namespace mb
