#include "reports/render.h"

#include <gmock/gmock.h>

#include <limits>

#include "cases/json/json.h"
#include "reports/number.h"
#include "reports/page.h"
#include "reports/synthetic.h"

namespace mb {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Sheet table_of(const std::string& text) {
  return {.name = "t", .title = text, .note = "", .columns = {{text, ""}}, .rows = {{text_cell(text)}}};
}

TEST(Numbers, CarryThreeDigitsAndRoundAcrossPowersOfTen) {
  EXPECT_EQ(format_number(0), "0");
  EXPECT_EQ(format_number(0.012345), "0.0123");
  EXPECT_EQ(format_number(123.4), "123");
  EXPECT_EQ(format_number(99999.9), "1.00e5");
  EXPECT_EQ(format_number(9.9999), "10.0");
  EXPECT_EQ(format_number(-4.567e-5), "-4.57e-5");
  EXPECT_EQ(format_number(std::numeric_limits<double>::quiet_NaN()), "not finite");
}

TEST(Numbers, BelowTheirBarPrintWhatTheyMayBe) {
  EXPECT_EQ(format_with_bar(1e-5, 4e-4), "<= 4.1e-4");
  EXPECT_EQ(format_with_bar(-1e-5, 4e-4), "<= 4.1e-4");
  EXPECT_EQ(format_with_bar(5.4e-4, 4e-4), "5e-4");  // one digit is all the bar supports
  EXPECT_EQ(format_with_bar(0.0381, 4e-4), "0.0381");
  EXPECT_EQ(format_with_bar(0.0381, std::nullopt), "0.0381");
}

TEST(Numbers, FailedRecordsShowTheirStatusAndNoNumber) {
  Record record = synthetic::record("displacement-error", 0.5, 0, synthetic::reduced("eigenmodes", 8));
  record.status = std::string("too_many_steps");
  EXPECT_EQ(format_record(record), "failed (too_many_steps)");
  EXPECT_FALSE(record_cell(&record).value.has_value());
  record.status = std::string("ok");
  record.value = std::numeric_limits<double>::infinity();
  EXPECT_EQ(format_record(record), "failed (not finite)");
  EXPECT_EQ(record_cell(&record).status, "not_finite");
}

TEST(Numbers, PerturbedTimesSayIt) {
  Record time = synthetic::seconds("online-time", 0.5, synthetic::reduced("eigenmodes", 8));
  EXPECT_EQ(record_cell(&time).text, "0.50");
  time.provenance["busy"] = "0.7";
  EXPECT_EQ(record_cell(&time).text, "0.50, perturbed");
  EXPECT_EQ(record_cell(&time).status, "perturbed");
  EXPECT_EQ(record_cell(&time).value, 0.5);
}

TEST(Markdown, TextStaysText) {
  EXPECT_EQ(markdown_text("a|b"), "a\\|b");
  EXPECT_EQ(markdown_text("`x`"), "\\`x\\`");
  EXPECT_EQ(markdown_text("<script>"), "\\<script>");
  EXPECT_EQ(markdown_text("</b>&lt;"), "\\</b>\\&lt;");
  EXPECT_EQ(markdown_text("[a](b)"), "[a\\](b)");
  EXPECT_EQ(markdown_text("line\nbreak"), "line break");
  EXPECT_EQ(markdown_text("<= 1e-3 [m/s] not_finite"), "<= 1e-3 [m/s] not_finite");
  EXPECT_EQ(markdown_text("_a_ [x]: y"), "\\_a\\_ [x\\]: y");
  EXPECT_EQ(markdown_text("- x"), "\\- x");
  EXPECT_EQ(markdown_text("12. x"), "12\\. x");
  EXPECT_EQ(markdown_text("---"), "\\---");
  EXPECT_EQ(markdown_text("-"), "-");
  EXPECT_EQ(markdown_text("-1.5 - 2. x"), "-1.5 - 2. x");
  EXPECT_EQ(markdown_text(" # x"), "\\# x");
  EXPECT_EQ(markdown_text("\n\t    1. x "), "1\\. x ");
}

TEST(Markdown, EveryRowHasTheColumnsOfTheHeader) {
  const std::string text = markdown(table_of("a|b\nc"));
  EXPECT_EQ(text, "| a\\|b c |\n| --- |\n| a\\|b c |\n");
}

TEST(Csv, FormulasAreDefusedAndQuotesDoubled) {
  for (const std::string start : {"=", "+", "-", "@", "\t", "\r"}) {
    EXPECT_THAT(csv_text(start + "cmd"), ::testing::AnyOf(::testing::StartsWith("'"), ::testing::StartsWith("\"'")))
        << start;
  }
  EXPECT_EQ(csv_text("plain"), "plain");
  EXPECT_EQ(csv_text(std::string("a\x1b]0;t\x07"
                                 "b\0c\x7f",
                                 11)),
            "\"a ]0;t b c \"");
  EXPECT_EQ(csv_text("\x1b=cmd"), "' =cmd");
  EXPECT_EQ(csv_text("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_text("a;=b"), "\"a;=b\"") << "elsewhere a semicolon parts fields";
  for (const std::string start : {"\uff1d", "\u00a0=", "\u3000\uff0b", "\u2003@"})
    EXPECT_EQ(csv_text(start + "cmd"), "'" + start + "cmd");
  EXPECT_EQ(csv_text("\u00a0x=1"), "\u00a0x=1");
  EXPECT_EQ(csv_text("say \"x\""), "\"say \"\"x\"\"\"");
  EXPECT_EQ(csv_text("two\nlines"), "\"two\nlines\"");
}

TEST(Csv, NumbersReadBackExactlyAndFailuresAreEmpty) {
  const double third = 1.0 / 3;
  Sheet table{.name = "t", .title = "t", .note = "", .columns = {{"e", "-", Column::Kind::error}}, .rows = {}};
  table.rows.push_back({{.text = "0.333", .value = third, .bar = 0.1, .status = "ok"}});
  table.rows.push_back({{.text = "failed (x)", .value = {}, .bar = {}, .status = "x"}});
  const std::string text = csv(table);
  EXPECT_THAT(text, HasSubstr("e [-],e bar,e status\n"));
  EXPECT_EQ(std::stod(text.substr(text.find('\n') + 1)), third);
  EXPECT_THAT(text, HasSubstr("\n,,x\n"));
}

TEST(Latex, SpecialsAreEscaped) {
  EXPECT_EQ(latex_text("a_b & 50% $x$ #1 {y} \\input ~ ^"),
            "a\\_b \\& 50\\% \\$x\\$ \\#1 \\{y\\} \\textbackslash{}input \\textasciitilde{} \\textasciicircum{}");
  EXPECT_EQ(latex_text("<= 1 [x]"), "$\\le$ 1 {[}x{]}");
  EXPECT_EQ(latex_text("*"), "{*}");
  EXPECT_THAT(latex(table_of("\\end{longtable}\\input{/etc/passwd}")), Not(HasSubstr("\\input")));
}

TEST(Page, DataCannotLeaveTheirElement) {
  const std::string text = script_json(Json{{"name", "</script><!-- <script>alert(1)</script>"}});
  EXPECT_THAT(text, Not(HasSubstr("<")));
  EXPECT_EQ(Json::parse(text)["name"], "</script><!-- <script>alert(1)</script>");
}

TEST(Page, OpensOnTheCaseOfTheMedianSpeedUp) {
  ReportInput input;
  const auto add = [&](const std::string& name, const Contender& contender, double seconds) {
    input.records.push_back(synthetic::record("displacement-error", 5e-3, 0, contender));
    input.records.push_back(synthetic::seconds("online-time", seconds, contender));
    for (std::size_t i = input.records.size() - 2; i < input.records.size(); ++i) input.records[i].case_name = name;
  };
  for (const auto& [name, rival] : {std::pair{"a", 3.0}, {"b", 50.0}, {"c", 400.0}, {"without-rival", 0.0}}) {
    add(name, synthetic::reduced("eigenmodes", 8), 1);
    if (rival > 0) add(name, synthetic::full(2, {1, 2}, 0.01), rival);
  }
  EXPECT_EQ(page_json(evaluate(std::move(input)))["verdict"]["opening"], (Json{{"case", "b"}, {"profile", "quick"}}));
  EXPECT_EQ(page_json(evaluate(ReportInput{}))["verdict"]["opening"], nullptr);
}

TEST(Page, ATemplateWithoutAPlaceForTheDataIsRefused) {
  EXPECT_THROW(page(evaluate(synthetic::input()), "<html></html>"), std::logic_error);
  EXPECT_THAT(page(evaluate(ReportInput{}), "[@REPORTJSON@]"), ::testing::StartsWith("[{\"schema\":1"));
}

}  // namespace
}  // namespace mb
