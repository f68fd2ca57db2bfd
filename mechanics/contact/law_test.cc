#include "mechanics/contact/law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace mb {
namespace {

// A sphere of radius R about the origin, by hand: gap = |x| - R.
Gap sphere_gap(double R, const Vector3d& x) {
  const Vector3d n = x.normalized();
  return {x.norm() - R, n, (Eigen::Matrix3d::Identity() - n * n.transpose()) / x.norm()};
}

const PenaltyLaw plain{2e9, 0, {}}, damped{2e9, 0.3, {}}, rough{2e9, 0.3, Friction{0.4, 0.05}},
    hertz{2e9, 0.3, {}, 1.5};
const Vector3d inside(0.06, -0.03, 0.0719), v(0.4, 1.1, -0.8);

TEST(ContactLaw, NothingOutsideAndNeverAdhesive) {
  const Gap outside = sphere_gap(0.1, {0.2, 0, 0});
  EXPECT_EQ(contact_traction(rough, outside, v).t, Vector3d::Zero());
  // Leaving faster than 1/d: the layer does not pull.
  const Gap within = sphere_gap(0.1, {0.099, 0, 0});
  const Traction3 leaving = contact_traction(damped, within, {1 / 0.3 + 1e-9, 0, 0});
  EXPECT_EQ(leaving.pressure, 0);
  EXPECT_EQ(leaving.t, Vector3d::Zero());
  EXPECT_EQ(stored_energy(plain, 1e-3), 0);
  EXPECT_DOUBLE_EQ(stored_energy(plain, -1e-3), 0.5 * 2e9 * 1e-6);
}

TEST(ContactLaw, PressureIsHuntAndCrossleys) {
  const Gap g = sphere_gap(0.1, inside);
  ASSERT_LT(g.value, 0);
  const double rate = -g.normal.dot(v);
  EXPECT_NEAR(contact_traction(damped, g, v).pressure, 2e9 * -g.value * (1 + 0.3 * rate), 1e-9 * 2e9 * -g.value);
  EXPECT_NEAR(contact_traction(plain, g, v).t.norm(), 2e9 * -g.value, 1e-9 * 2e9 * -g.value);
}

TEST(ContactLaw, FrictionOpposesSlipAndStaysWithinTheCone) {
  const Gap g = sphere_gap(0.1, inside);
  const Traction3 t = contact_traction(rough, g, v);
  const Vector3d slip = v - g.normal * g.normal.dot(v), tangential = t.t - t.pressure * g.normal;
  EXPECT_NEAR(tangential.dot(g.normal), 0, 1e-12 * t.pressure);
  EXPECT_LT(tangential.dot(slip), 0);
  EXPECT_LT(tangential.norm(), 0.4 * t.pressure);
  EXPECT_GT(tangential.norm(), 0.399 * t.pressure);  // slip is 26 times the speed of regularisation
  EXPECT_EQ(contact_traction(rough, g, Vector3d::Zero()).t.cross(g.normal).norm() < 1e-9 * t.pressure, true);
}

// Derivatives against central differences, whose own error is about the cube root of rounding squared: 1e-10 relative.
TEST(ContactLaw, DerivativesAreThoseOfTheTraction) {
  for (const PenaltyLaw& law : {plain, damped, rough, hertz}) {
    const Traction3 at = contact_traction(law, sphere_gap(0.1, inside), v);
    ASSERT_GT(at.pressure, 0);
    for (int j = 0; j < 3; ++j) {
      const Vector3d e = Vector3d::Unit(j);
      const double h = 1e-8, s = 1e-5;
      const Vector3d by_x = (contact_traction(law, sphere_gap(0.1, inside + h * e), v).t -
                             contact_traction(law, sphere_gap(0.1, inside - h * e), v).t) /
                            (2 * h);
      const Vector3d by_v = (contact_traction(law, sphere_gap(0.1, inside), v + s * e).t -
                             contact_traction(law, sphere_gap(0.1, inside), v - s * e).t) /
                            (2 * s);
      EXPECT_LT((by_x - at.by_x.col(j)).norm(), 1e-6 * at.by_x.norm());
      EXPECT_LT((by_v - at.by_v.col(j)).norm(), 1e-6 * (at.by_v.norm() + at.pressure));
    }
  }
}

TEST(ContactLaw, StoredEnergyIsTheWorkOfTheLayer) {
  for (const PenaltyLaw& law : {plain, hertz}) {
    const double g = 3e-4, h = 1e-9;
    EXPECT_NEAR((stored_energy(law, -g - h) - stored_energy(law, -g + h)) / (2 * h), layer(law, -g).pressure,
                1e-6 * layer(law, -g).pressure);
    EXPECT_NEAR((layer(law, -g + h).pressure - layer(law, -g - h).pressure) / (2 * h), layer(law, -g).by_gap,
                1e-6 * std::abs(layer(law, -g).by_gap));
  }
  EXPECT_EQ(layer(hertz, 1e-5).pressure, 0);
}

TEST(ContactLaw, NanStaysOutOfTheForce) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(contact_traction(plain, {nan, Vector3d::UnitZ(), Eigen::Matrix3d::Zero()}, v).t, Vector3d::Zero());
}

}  // namespace
}  // namespace mb
