#include "reports/energy_warnings.h"

#include <gmock/gmock.h>

#include "cases/scene/one_body.h"

namespace mb {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Record gain(double value) {
  Record record{};  // a mesh of degree 0, as of what has none
  record.case_name = "one";
  record.profile = "quick";
  record.metric = "energy-gain";
  record.contender.method = "eigenmodes";
  record.contender.integrator = "exact";
  record.contender.settings.modes = 8;
  record.contender.settings.time_step = 1e-4;
  record.value = value;
  record.status = "ok";
  return record;
}

TEST(EnergyWarnings, AreOfWhatGainsMoreThanATenth) {
  Scene scene = one_body(Box{{1, 1, 1}}, {1e6, 0.3, 1000}, {1, {1, 1, 1}});
  scene.name = "one";
  scene.profile = "quick";
  EXPECT_THAT(energy_warnings({gain(0.09)}, scene), IsEmpty());
  EXPECT_THAT(energy_warnings({gain(0.319), gain(0.319)}, scene),
              ElementsAre(AllOf(HasSubstr("eigenmodes"), HasSubstr("gains 31.9 % of the energy"))));
  Record unstable = gain(2);
  unstable.status = "unstable";
  Record other = gain(0.5), profile = gain(0.5), metric = gain(0.5);
  other.case_name = "two";
  profile.profile = "full";
  metric.metric = "energy-defect";
  EXPECT_THAT(energy_warnings({unstable, other, profile, metric}, scene), IsEmpty());
}

}  // namespace
}  // namespace mb
