#include "cases/json/finding_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "cases/json/json.h"

namespace mb {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

Finding example() {
  return {.run = "0123456789abcdef0123456789abcdef",
          .analysis = "step-limits",
          .name = "step-limits",
          .title = "Step limits, formula and measured",
          .note = "By bisection to 0.1 %.",
          .case_name = "cylinder-shear",
          .profile = "quick",
          .columns = {{"modes", ""}, {"limit", "s"}},
          .rows = {{8.0, 0.1 + 0.2}, {"full", infinity}, {"\"<é>", not_a_number}, {-0.0, -infinity}},
          .bars = {{0.0, 1e-3}, {not_a_number, 0.25}, {not_a_number, infinity}, {1.0, 2.0}},
          .footing = {"the formula", "property", "bisection, 0.1 %"},
          .provenance = {{"commit", "abc"}}};
}

Json altered(const std::string& key, const Json& value) {
  Json json = to_json(example());
  json[key] = value;
  return json;
}

void expect_refused(const std::string& key, const Json& value) {
  EXPECT_THAT([&] { finding_from_json(altered(key, value)); },
              ThrowsMessage<std::runtime_error>(HasSubstr("'" + key + "'")))
      << value;
}

TEST(FindingJson, every_field_comes_back_from_its_text) {
  const Finding before = example();
  const Finding after = finding_from_json(parse_json(to_line(to_json(before))));
  EXPECT_EQ(after.run, before.run);
  EXPECT_EQ(after.analysis, before.analysis);
  EXPECT_EQ(after.name, before.name);
  EXPECT_EQ(after.title, before.title);
  EXPECT_EQ(after.note, before.note);
  EXPECT_EQ(after.case_name, before.case_name);
  EXPECT_EQ(after.profile, before.profile);
  ASSERT_EQ(after.columns.size(), 2u);
  EXPECT_EQ(after.columns[1].name, "limit");
  EXPECT_EQ(after.columns[1].unit, "s");
  ASSERT_EQ(after.rows.size(), 4u);
  EXPECT_EQ(after.rows[0], before.rows[0]) << "bit for bit: all 17 digits";
  EXPECT_EQ(after.rows[1], before.rows[1]);
  EXPECT_EQ(after.rows[2][0], before.rows[2][0]);
  ASSERT_EQ(after.bars.size(), 4u);
  EXPECT_EQ(after.bars[0], before.bars[0]);
  EXPECT_TRUE(std::isnan(after.bars[1][0]));
  EXPECT_EQ(after.bars[1][1], 0.25);
  EXPECT_EQ(after.bars[2][1], infinity);
  EXPECT_EQ(after.footing.reference, before.footing.reference);
  EXPECT_EQ(after.footing.kind, before.footing.kind);
  EXPECT_EQ(after.footing.uncertainty, before.footing.uncertainty);
  EXPECT_EQ(after.provenance, before.provenance);
  EXPECT_EQ(to_line(to_json(after)), to_line(to_json(before)));
}

TEST(FindingJson, what_is_not_finite_is_named) {
  const Json json = to_json(example());
  EXPECT_EQ(to_line(json["rows"][1]), R"(["full",{"special":"inf"}])");
  EXPECT_EQ(to_line(json["rows"][2][1]), "null");
  EXPECT_EQ(to_line(json["rows"][3][1]), R"({"special":"-inf"})");
  const Finding after = finding_from_json(json);
  EXPECT_TRUE(std::isnan(std::get<double>(after.rows[2][1])));
  EXPECT_EQ(std::get<double>(after.rows[3][1]), -infinity);
}

TEST(FindingJson, a_table_without_rows_is_one) {
  Finding empty = example();
  empty.rows.clear();
  empty.bars.clear();
  EXPECT_TRUE(finding_from_json(parse_json(to_line(to_json(empty)))).rows.empty());
}

TEST(FindingJson, every_key_is_required_and_typed) {
  for (const char* key : {"schema", "run", "analysis", "name", "title", "note", "case", "profile", "columns", "rows",
                          "bars", "footing", "provenance"}) {
    for (const Json& wrong : {Json(true), Json(nullptr), Json(1.5), Json::array({Json::array({Json::object()})})}) {
      expect_refused(key, wrong);
    }
    Json without = to_json(example());
    without.erase(key);
    EXPECT_THAT([&] { finding_from_json(without); },
                ThrowsMessage<std::runtime_error>(HasSubstr(std::string("'") + key + "' is missing")));
  }
  EXPECT_THAT([] { finding_from_json(altered("surprise", 1)); },
              ThrowsMessage<std::runtime_error>(HasSubstr("does not know")));
  for (const Json& no_object : {Json(nullptr), Json::array(), Json("finding")}) {
    EXPECT_THROW(finding_from_json(no_object), std::runtime_error);
  }
}

TEST(FindingJson, hostile_values_are_refused) {
  expect_refused("schema", 2);
  expect_refused("run", "../../etc/passwd");
  expect_refused("run", "0123456789ABCDEF0123456789ABCDEF");
  expect_refused("analysis", "Upper case");
  expect_refused("name", "");
  expect_refused("name", std::string(65, 'a'));
  expect_refused("case", "../case");
  expect_refused("profile", "overnight");
  expect_refused("note", std::string(4097, 'x'));
  expect_refused("columns", Json::array());
  Json wide = Json::array();
  for (int i = 0; i < 65; ++i) wide.push_back({{"name", "a"}, {"unit", ""}});
  expect_refused("columns", wide);
  const Json row = {1, 2};
  expect_refused("rows", Json(100001, row));
  Json most = altered("rows", Json(100000, row));
  most["bars"] = Json::array();
  EXPECT_EQ(finding_from_json(most).rows.size(), 100000u);
}

TEST(FindingJson, rows_hold_texts_numbers_and_named_specials_alone) {
  for (const Json& cell :
       {Json({{"special", "nan"}}), Json(true), Json::array({1}), Json::object(), Json({{"special", "huge"}}),
        Json({{"special", "inf"}, {"more", 1}}), Json(std::string(4097, 'x')), Json(infinity)}) {
    expect_refused("rows", Json::array({Json::array({1, cell})}));
  }
  expect_refused("rows", Json::array({Json::array({1})}));
  expect_refused("rows", Json::array({Json::array({1, 2, 3})}));
}

TEST(FindingJson, bars_are_numbers_from_zero_or_null_one_a_cell) {
  const Json whole = to_json(example())["bars"];
  for (const Json& cell : {Json(-1e-9), Json("0.1"), Json(infinity), Json::array(), Json{{"special", "-inf"}}}) {
    Json wrong = whole;
    wrong[0][1] = cell;
    expect_refused("bars", wrong);
  }
  expect_refused("bars", Json::array({whole[0]}));
  Json ragged = whole;
  ragged[3].push_back(1);
  expect_refused("bars", ragged);
}

TEST(FindingJson, nothing_unreadable_is_written) {
  const auto with = [](auto change) {
    Finding finding = example();
    change(finding);
    return finding;
  };
  const Finding wrong[] = {with([](Finding& f) { f.rows[0].pop_back(); }),
                           with([](Finding& f) { f.columns.clear(); }),
                           with([](Finding& f) { f.columns.resize(65); }),
                           with([](Finding& f) { f.note = std::string(4097, 'x'); }),
                           with([](Finding& f) { f.rows[1][0] = std::string(4097, 'x'); }),
                           with([](Finding& f) { f.bars.pop_back(); }),
                           with([](Finding& f) { f.bars[0].pop_back(); }),
                           with([](Finding& f) { f.footing.reference = std::string(4097, 'x'); }),
                           with([](Finding& f) { f.rows.resize(100001, f.rows[0]); })};
  for (const Finding& finding : wrong) EXPECT_THROW(to_json(finding), std::invalid_argument);
}

// A terminal obeys what some characters say: title, colour, cursor, the direction of what follows.
TEST(FindingJson, what_does_not_print_is_refused_and_never_written) {
  for (const char* hidden : {"a\x1b]0;title\x07",
                             "\xc2\x9b"
                             "31m",
                             "\xe2\x80\xae"
                             "abc",
                             "two\nlines", "a\tb", "\x7f"}) {
    for (const char* key : {"title", "note"}) expect_refused(key, hidden);
    expect_refused("rows", Json::array({Json::array({1, hidden})}));
    EXPECT_THROW(finding_from_json(altered("columns", Json::array({Json({{"name", hidden}, {"unit", ""}})}))),
                 std::runtime_error);
    EXPECT_THROW(finding_from_json(altered("footing", {{"reference", hidden}, {"kind", ""}, {"uncertainty", ""}})),
                 std::runtime_error);
    Finding told = example();
    told.note = told.rows[1][0].emplace<std::string>(hidden);
    EXPECT_NO_THROW(finding_from_json(parse_json(to_line(to_json(told))))) << hidden;
  }
  Finding failed = example();
  failed.note = "failed: two\nlines";
  EXPECT_EQ(finding_from_json(to_json(failed)).note, "failed: two lines");
}

TEST(FindingJson, every_truncation_and_every_swapped_byte_is_refused_or_a_finding) {
  const std::string good = to_line(to_json(example()));
  for (std::size_t size = 1; size < good.size(); ++size) {
    EXPECT_THROW(finding_from_json(parse_json(good.substr(0, size))), std::runtime_error);
  }
  int n_refused = 0;
  for (std::size_t i = 0; i < good.size(); ++i) {
    for (const char c : {'\0', '"', '{', '9', '\xff', 'e'}) {
      std::string text = good;
      text[i] = c;
      try {
        finding_from_json(parse_json(text));
      } catch (const std::runtime_error&) {
        ++n_refused;  // anything else ends the test program
      }
    }
  }
  EXPECT_GT(n_refused, 0);
}

}  // namespace
}  // namespace mb
