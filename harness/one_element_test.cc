// cases/hard/one-element.toml: two probes in one place say the same.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "cases/json/record_json.h"
#include "harness/program_test.h"
#include "harness/store/scratch_folder_test.h"

namespace mb {
namespace {

using Mark = std::tuple<std::string, std::string, std::string>;  // run, metric, truth
struct Answer {
  double value, bar;  // NaN: none
  std::string status;
};

std::map<Mark, Answer> marks_of(const std::string& probe, const std::vector<Record>& records) {
  std::map<Mark, Answer> marks;
  for (const Record& r : records)
    if (r.subject == probe) marks[{r.run, r.metric, r.truth}] = {r.value, r.error_bar.value_or(std::nan("")), r.status};
  return marks;
}

// Not bit for bit: truths are stored as factors cut at 1e-12 of their largest value (trajectory_file.h), which leaves
// each row a rounding of its own; marks are relative to the probe's signal, a few times smaller than that value.
void expect_same(double a, double b, const std::string& what) {
  EXPECT_EQ(std::isnan(a), std::isnan(b)) << what;
  if (!std::isnan(a)) {
    EXPECT_NEAR(a, b, 1e-11 * std::max(1.0, std::abs(a))) << what;
  }
}

TEST(OneElementCases, TwoProbesInOnePlaceSayTheSame) {
  const ScratchFolder scratch;
  const fs::path file = fs::path(MB_SOURCE_DIR) / "cases/hard/one-element.toml";
  const Said said = modalbench(scratch.path(), {"run", file.string(), "--profile", "quick", "--untimed"});
  EXPECT_EQ(said.code, 0) << said.out << said.err;
  const auto records = read_records(scratch / "results/results.jsonl").records;
  const auto one = marks_of("corner", records), other = marks_of("corner-again", records);
  ASSERT_EQ(one.size(), other.size());
  int n_numbers = 0;
  for (const auto& [mark, answer] : one) {
    const auto& [run, metric, truth] = mark;
    ASSERT_TRUE(other.contains(mark)) << metric << truth;
    const Answer& beside = other.at(mark);
    EXPECT_EQ(answer.status, beside.status) << metric << truth;
    expect_same(answer.value, beside.value, run + metric + truth);
    expect_same(answer.bar, beside.bar, "bar of " + run + metric + truth);
    n_numbers += answer.status == "ok" && std::isfinite(answer.value);
  }
  EXPECT_GE(n_numbers, 30);  // ten contenders and more, several metrics of a probe each
}

}  // namespace
}  // namespace mb
