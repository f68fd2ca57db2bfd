#include "reports/warnings.h"

#include <gmock/gmock.h>

#include "reports/synthetic.h"
#include "reports/verdict.h"
#include "reports/views.h"

namespace mb {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(Warnings, StepsOfUnknownGrowthAreNamedOnce) {
  const Scene scene = synthetic::scene();
  std::vector<Record> records{synthetic::record("displacement-error", 0.1, 0, synthetic::full(2, {1, 2}, 0.01)),
                              synthetic::record("strain-error", 0.1, 0, synthetic::full(2, {1, 2}, 0.01))};
  EXPECT_THAT(warnings(records, scene), IsEmpty());
  for (Record& record : records) record.provenance["growth"] = "unknown";
  EXPECT_THAT(warnings(records, scene), ElementsAre(HasSubstr("past their limit was looked for in vain")));
  for (Record& record : records) record.status = "unstable";
  EXPECT_THAT(warnings(records, scene), IsEmpty());
}

TEST(Verdict, NamesWhatWasDamaged) {
  ReportInput input = synthetic::input();
  for (int i = 0; i < 7; ++i) input.damaged.push_back(std::to_string(i) + ".jsonl: cut");
  EXPECT_THAT(verdict_of(evaluate(input)).sentences,
              Contains("7 damaged files of the store are left out, what stood there is missing here until it "
                       "is run again: 0.jsonl: cut; 1.jsonl: cut; 2.jsonl: cut; 3.jsonl: cut; 4.jsonl: "
                       "cut; and 2 more."));
}

}  // namespace
}  // namespace mb
