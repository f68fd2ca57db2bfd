#include "reports/linear_warnings.h"

#include <gmock/gmock.h>

#include "cases/scene/one_body.h"

namespace mb {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Record of_truth(const std::string& metric, double value) {
  Record record;
  record.case_name = "one";
  record.profile = "quick";
  record.metric = metric;
  record.subject = "body";
  record.value = value;
  record.status = "ok";
  return record;
}

Scene scene(Kinematics kinematics) {
  Scene one = one_body(Box{{1, 1, 1}}, {1e6, 0.3, 1000}, {1, {1, 1, 1}});
  one.name = "one";
  one.profile = "quick";
  one.bodies[0].kinematics = kinematics;
  return one;
}

TEST(LinearWarnings, AreOfWhatIsBeyondTheLimits) {
  const Scene linear = scene(Kinematics::linear);
  EXPECT_THAT(linear_warnings({of_truth("truth-strain", 0.0099), of_truth("truth-rotation", 0.099)}, linear),
              IsEmpty());
  EXPECT_THAT(linear_warnings({of_truth("truth-strain", 0.03), of_truth("truth-rotation", 0.25)}, linear),
              ElementsAre(HasSubstr("body: rotation 0.25 rad is beyond 0.1 rad"),
                          HasSubstr("body: strain 0.03 is beyond 0.01, where linear theory")));
  EXPECT_THAT(linear_warnings({of_truth("displacement-error", 0.5)}, linear), IsEmpty());
}

TEST(LinearWarnings, ReachAsFarAsBars) {
  Record strained = of_truth("truth-strain", 0.0095);
  strained.error_bar = 0.001;
  EXPECT_THAT(linear_warnings({strained}, scene(Kinematics::linear)),
              ElementsAre(HasSubstr("body: strain 0.0095 +- 0.0010 may be beyond 0.01, where linear theory")));
  strained.error_bar = 0.0004;
  EXPECT_THAT(linear_warnings({strained}, scene(Kinematics::linear)), IsEmpty());
}

TEST(LinearWarnings, SayWhoIsLinear) {
  const Record strained = of_truth("truth-strain", 0.03);
  EXPECT_THAT(linear_warnings({strained}, scene(Kinematics::linear)), ElementsAre(HasSubstr("no bar of a linear")));
  EXPECT_THAT(linear_warnings({strained}, scene(Kinematics::finite)), ElementsAre(HasSubstr("the truth is finite")));
}

TEST(LinearWarnings, AreOfThisCaseAndOfNumbersAlone) {
  const Scene linear = scene(Kinematics::linear);
  Record other = of_truth("truth-strain", 0.03), failed = other, profile = other;
  other.case_name = "two";
  failed.status = "failed: nothing";
  profile.profile = "full";
  EXPECT_THAT(linear_warnings({other, failed, profile}, linear), IsEmpty());
}

}  // namespace
}  // namespace mb
