#include "reports/page.h"

#include <gmock/gmock.h>

#include <limits>
#include <string>

#include "cases/json/json.h"
#include "reports/content.h"

namespace mb {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// The policy is what stands between a hostile name in a record and the reader's browser: nothing is loaded, no script
// runs but the page's own, known by its hash.
TEST(Page, CarriesAPolicyThatLetsNothingInButItsOwnScript) {
  if (!page_available()) GTEST_SKIP() << "the browser part was not built";
  const std::string page(page_template());
  const std::string head = "<meta http-equiv=\"Content-Security-Policy\" content=\"";
  const std::size_t at = page.find(head);
  ASSERT_NE(at, std::string::npos);
  const std::string policy = page.substr(at + head.size(), page.find('"', at + head.size()) - at - head.size());
  EXPECT_THAT(policy, HasSubstr("default-src 'none'"));
  EXPECT_THAT(policy, HasSubstr("script-src 'sha256-"));
  for (const char* open : {"unsafe-eval", "unsafe-inline' 'sha", "http:", "https:", "*"})
    EXPECT_THAT(policy, Not(HasSubstr(open))) << policy;
  EXPECT_LT(at, page.find("<script")) << "before anything it rules";
}

TEST(Page, DataCannotEndTheScriptTheyStandIn) {
  const std::string text = script_json(Json{{"name", "</script><script>alert(1)</script>"}});
  EXPECT_THAT(text, Not(HasSubstr("<")));
}

TEST(Page, NumbersOfAnySizeAreRounded) {
  EXPECT_EQ(rounded(1.0 / 3), 0.333333);
  EXPECT_EQ(rounded(5e-324), 5e-324);  // the least there is: reading one underflows
  EXPECT_TRUE(rounded(std::numeric_limits<double>::infinity()).is_null());
}

}  // namespace
}  // namespace mb
