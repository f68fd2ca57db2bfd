#include "harness/study/instability.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "harness/catalogue.h"

namespace mb {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();  // growth by theory

Record mark(const char* metric, double value, const char* status = "ok") {
  Record record;
  record.metric = metric;
  record.value = value;
  record.status = status;
  return record;
}

Scene in_flight() {
  Scene scene;
  scene.bodies.resize(1);
  return scene;
}

Scene in_contact() {
  Scene scene = in_flight();
  scene.contacts.resize(1);
  return scene;
}

bool is_past(const std::vector<Record>& marks, const Scene& scene, const char* integrator, double growth = unknown) {
  return is_past_its_limit(marks, scene, default_catalogue().integrator(integrator), growth);
}

TEST(Instability, OfExplicitStepsIsWhatIsNotFiniteFarOffOrGrowsByTheory) {
  const Scene scene = in_flight();
  for (const char* scheme : {"central-difference", "symplectic-euler", "explicit-euler"}) {
    EXPECT_TRUE(is_past({mark("strain-error", 0.1), mark("displacement-error", unknown, "not_finite")}, scene, scheme));
    EXPECT_TRUE(is_past({mark("displacement-error", 1001)}, scene, scheme));
    EXPECT_TRUE(is_past({mark("displacement-error", 0.1)}, scene, scheme, 10.1));
    EXPECT_FALSE(is_past({mark("displacement-error", 999)}, scene, scheme));
    EXPECT_FALSE(is_past({mark("displacement-error", 0.1)}, scene, scheme, 9.9));
    EXPECT_FALSE(is_past({mark("probe-error", 1001)}, scene, scheme));
  }
}

// What is off by so much without a limit is wrong, and a failure where it is not finite.
TEST(Instability, OfUnconditionallyStableStepsIsNoneWithoutContact) {
  for (const char* scheme : {"newmark", "exact", "sundials"})
    EXPECT_FALSE(is_past({mark("displacement-error", 1001), mark("energy-gain", 7)}, in_flight(), scheme, 99))
        << scheme;
}

TEST(Instability, InContactIsEnergyThatNothingBrought) {
  for (const char* scheme : {"newmark", "exact", "sundials", "central-difference"}) {
    EXPECT_TRUE(is_past({mark("impulse", 0.1), mark("energy-gain", 1.01)}, in_contact(), scheme)) << scheme;
    EXPECT_FALSE(is_past({mark("impulse", 7), mark("energy-gain", 0.99)}, in_contact(), scheme)) << scheme;
    EXPECT_FALSE(is_past({mark("energy-gain", unknown, "undefined: no contact")}, in_contact(), scheme)) << scheme;
  }
}

TEST(Instability, IsNotSeenByEnergyWhereLoadsOrMovingSupportsBringIt) {
  Scene loaded = in_contact();
  loaded.loads.resize(1);
  Scene driven = in_contact();
  driven.bodies.front().supports.push_back({Support::Kind::driven, Patch{}, Drive{}});
  for (const Scene& scene : {loaded, driven}) EXPECT_FALSE(is_past({mark("energy-gain", 7)}, scene, "newmark"));
}

TEST(Instability, LeavesNoValue) {
  std::vector<Record> marks{mark("impulse", 0.1), mark("energy-gain", 7)};
  name_unstable(marks);
  for (const Record& record : marks) {
    EXPECT_EQ(record.status, "unstable");
    EXPECT_TRUE(std::isnan(record.value));
  }
}

}  // namespace
}  // namespace mb
