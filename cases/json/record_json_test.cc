#include "cases/json/record_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "cases/json/json.h"

namespace mb {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

Record example() {
  return {.run = "0123456789abcdef0123456789abcdef",
          .case_name = "cylinder-compression",
          .profile = "quick",
          .contender = {.method = "eigenmodes",
                        .integrator = "exact",
                        .resolution = {.degree = 4, .cells = {1, 4}},
                        .settings = {.modes = 15}},
          .modes_used = 16,
          .n_unknowns = 22,
          .metric = "displacement-error",
          .subject = "cylinder",
          .truth = "finer",
          .value = 0.1 + 0.2,  // needs all 17 digits
          .unit = "-",
          .error_bar = 4e-4,
          .status = "ok",
          .work = {.steps = 175, .rejected = 1, .factorisations = 2, .solves = 3, .load_evaluations = 4},
          .provenance = {{"commit", "abc"}, {"threads", "1"}}};
}

Json altered(const std::string& key, const Json& value) {
  Json json = to_json(example());
  json[key] = value;
  return json;
}

void expect_refused(const std::string& key, const Json& value) {
  EXPECT_THAT([&] { record_from_json(altered(key, value)); },
              ThrowsMessage<std::runtime_error>(HasSubstr("'" + key + "'")))
      << value;
}

class FileOf {
 public:
  explicit FileOf(const std::string& content) {
    path = std::filesystem::temp_directory_path() /
           ("mb_record_" + std::to_string(::getpid()) + "_" +
            ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".jsonl");
    std::ofstream(path, std::ios::binary) << content;
  }
  ~FileOf() { std::filesystem::remove(path); }
  std::filesystem::path path;
};

TEST(RecordJson, EveryFieldComesBackFromItsLine) {
  const Record before = example();
  const Record after = record_from_json(parse_json(to_line(to_json(before))));
  EXPECT_EQ(after.run, before.run);
  EXPECT_EQ(after.case_name, before.case_name);
  EXPECT_EQ(after.profile, before.profile);
  EXPECT_EQ(after.contender.method, before.contender.method);
  EXPECT_EQ(after.contender.integrator, before.contender.integrator);
  EXPECT_EQ(after.contender.resolution.degree, 4);
  EXPECT_EQ(after.contender.resolution.cells, before.contender.resolution.cells);
  EXPECT_EQ(after.contender.settings.modes, 15);
  EXPECT_EQ(after.modes_used, 16);
  EXPECT_EQ(after.n_unknowns, 22);
  EXPECT_EQ(after.metric, before.metric);
  EXPECT_EQ(after.subject, before.subject);
  EXPECT_EQ(after.truth, before.truth);
  EXPECT_EQ(after.value, before.value);  // bit for bit
  EXPECT_EQ(after.unit, before.unit);
  EXPECT_EQ(after.error_bar, before.error_bar);
  EXPECT_EQ(after.status, "ok");
  EXPECT_EQ(after.work.rejected, 1);
  EXPECT_EQ(after.work.load_evaluations, 4);
  EXPECT_EQ(after.provenance, before.provenance);
  EXPECT_EQ(to_line(to_json(after)), to_line(to_json(before)));
}

TEST(RecordJson, SettingsNameWhatMatters) {
  EXPECT_EQ(to_line(to_json(example())["settings"]), R"({"modes":15,"load_tolerance":1e-05})");
  Record newmark = example();
  newmark.contender = {"full-order", "newmark", {2, {1, 4}}, {.time_step = 1e-3}};
  newmark.modes_used = -1;
  EXPECT_EQ(to_line(to_json(newmark)["settings"]), R"({"time_step":0.001})");
  Record sundials = newmark;
  sundials.contender = {"full-order", "sundials", {2, {1, 4}}, {}};
  EXPECT_EQ(to_line(to_json(sundials)["settings"]), R"({"relative_tolerance":1e-06})");
}

TEST(RecordJson, WhatIsNotFiniteIsNullWithAStatus) {
  for (const double value : {not_a_number, infinity, -infinity}) {
    Record record = example();
    record.value = value;
    record.error_bar = value;
    const Json json = to_json(record);
    EXPECT_TRUE(json["value"].is_null());
    EXPECT_EQ(json["status"], "not_finite");
    const Record after = record_from_json(json);
    EXPECT_TRUE(std::isnan(after.value));
    EXPECT_FALSE(after.error_bar);
  }
  Record failed = example();
  failed.value = not_a_number;
  failed.status = "no_convergence";
  EXPECT_EQ(to_json(failed)["status"], "no_convergence");
  expect_refused("value", nullptr);  // the example's status is ok
}

TEST(RecordJson, WrongTypesAndRangesAreRefusedByName) {
  for (const char* key :
       {"schema", "run", "case", "profile", "method", "integrator", "degree", "cells", "settings", "modes_used",
        "n_unknowns", "metric", "subject", "truth", "value", "unit", "status", "work", "provenance"}) {
    for (const Json& wrong : {Json(true), Json(Json::array({Json::object()})), Json(infinity)}) {
      expect_refused(key, wrong);
    }
    Json without = to_json(example());
    without.erase(key);
    EXPECT_THROW(record_from_json(without), std::runtime_error) << key;
  }
  expect_refused("schema", 2);
  expect_refused("run", "../../etc/passwd");
  expect_refused("run", "0123456789ABCDEF0123456789ABCDEF");
  expect_refused("case", "Upper");
  for (const char* key : {"case", "method", "metric"}) {
    expect_refused(key, "");
    expect_refused(key, "--again");
  }
  for (const char* key : {"case", "method", "metric", "integrator", "subject"}) {
    expect_refused(key, std::string(65, 'a'));
    expect_refused(key, "=1+1");
    Json longest = to_json(example());
    longest[key] = std::string(64, 'a');
    EXPECT_NO_THROW(record_from_json(longest)) << key;
  }
  expect_refused("truth", "guess");
  expect_refused("degree", -1);
  expect_refused("cells", Json::array({1, 2, 3, 4}));
  expect_refused("modes_used", 3000000000);
  expect_refused("n_unknowns", 18446744073709551615u);
  expect_refused("n_unknowns", 1.5);
  expect_refused("error_bar", -1e-3);
  expect_refused("status", std::string(5000, 'x'));
  EXPECT_THROW(record_from_json(Json(nullptr)), std::runtime_error);
  EXPECT_THROW(record_from_json(altered("surprise", 1)), std::runtime_error);
}

// A terminal obeys what some characters say: title, colour, cursor, the direction of what follows.
TEST(RecordJson, WhatDoesNotPrintIsRefusedAndNeverWritten) {
  for (const char* hidden : {"failed: \x1b]0;title\x07",
                             "\xc2\x9b"
                             "31m",
                             "\xe2\x80\xae"
                             "abc",
                             "two\nlines", "a\tb"}) {
    for (const char* key : {"status", "unit"}) expect_refused(key, hidden);
    expect_refused("provenance", {{"commit", hidden}});
    expect_refused("provenance", {{hidden, "abc"}});
    Record told = example();
    told.status = hidden;
    EXPECT_NO_THROW(record_from_json(parse_json(to_line(to_json(told))))) << hidden;
  }
  Record failed = example();
  failed.status = "failed: one\nand \x1b[31mtwo";
  EXPECT_EQ(record_from_json(to_json(failed)).status, "failed: one and ?[31mtwo");
}

TEST(Json, HostileTextIsRefusedNotFollowed) {
  const std::string deep(1000000, '[');
  EXPECT_THAT([&] { parse_json(deep); }, ThrowsMessage<std::runtime_error>(HasSubstr("nested deeper")));
  EXPECT_THAT([] { parse_json(R"({"a":1,"a":2})"); }, ThrowsMessage<std::runtime_error>(HasSubstr("twice")));
  EXPECT_THAT([] { parse_json("1e999"); }, ThrowsMessage<std::runtime_error>(HasSubstr("range")));
  for (const char* text : {"", "NaN", "{", "[1,]", "{\"a\":1} {}", "\xff\xfe", "\"\x01\"", "'a'"}) {
    EXPECT_THROW(parse_json(text), std::runtime_error) << text;
  }
  EXPECT_EQ(parse_json("[[[1]]]", 3).size(), 1u);
  EXPECT_THROW(parse_json("[[[1]]]", 2), std::runtime_error);
  EXPECT_EQ(to_line(Json("a\xff\n")), "\"a\xEF\xBF\xBD\\n\"");  // U+FFFD, and no line break
}

TEST(RecordLines, DamagedLinesAreNamedAndTheRestIsKept) {
  const std::string good = to_line(to_json(example()));
  const FileOf file(good + "\n\n" + good.substr(0, 100) + "\n" + std::string(100000, 'x') + "\n" + good + "\r\n{}\n" +
                    good);  // the last line has no end
  const RecordLines lines = read_records(file.path);
  EXPECT_EQ(lines.records.size(), 3u);
  ASSERT_EQ(lines.refused.size(), 3u);
  EXPECT_EQ(lines.refused[0].line, 3);
  EXPECT_THAT(lines.refused[0].reason, HasSubstr("not valid JSON at byte 101"));
  EXPECT_EQ(lines.refused[1].line, 4);
  EXPECT_THAT(lines.refused[1].reason, HasSubstr("longer than 64 KiB"));
  EXPECT_EQ(lines.refused[2].line, 6);
  EXPECT_THAT(lines.refused[2].reason, HasSubstr("'schema' is missing"));
  EXPECT_EQ(lines.refused[2].file, file.path);
}

TEST(RecordLines, EveryTruncationAndEverySwappedByteIsRefusedOrARecord) {
  const std::string good = to_line(to_json(example()));
  for (std::size_t size = 1; size < good.size(); ++size) {
    EXPECT_THROW(record_from_json(parse_json(good.substr(0, size))), std::runtime_error);
  }
  int n_refused = 0;
  for (std::size_t i = 0; i < good.size(); ++i) {
    for (const char c : {'\0', '"', '{', '9', '\xff', 'e'}) {
      std::string text = good;
      text[i] = c;
      try {
        record_from_json(parse_json(text));
      } catch (const std::runtime_error&) {
        ++n_refused;  // anything else ends the test program
      }
    }
  }
  EXPECT_GT(n_refused, 0);
}

TEST(RecordLines, WhatIsNoFileIsRefusedAsAWhole) {
  for (const char* path : {"/nowhere/results.jsonl", "/dev/zero", "/tmp"}) {
    const RecordLines lines = read_records(path);
    EXPECT_TRUE(lines.records.empty());
    ASSERT_EQ(lines.refused.size(), 1u) << path;
    EXPECT_EQ(lines.refused[0].line, 0);
  }
}

TEST(TruthKind, NamesAreThoseOfTheStore) {
  EXPECT_STREQ(to_string(TruthKind::finer), "finer");
  EXPECT_STREQ(to_string(TruthKind::same_mesh), "same_mesh");
  EXPECT_STREQ(to_string(TruthKind::exact), "exact");
  EXPECT_STREQ(to_string(TruthKind::same_modes), "same_modes");
  for (const TruthKind kind : {TruthKind::finer, TruthKind::same_mesh, TruthKind::exact, TruthKind::same_modes}) {
    EXPECT_EQ(record_from_json(altered("truth", to_string(kind))).truth, to_string(kind));
  }
}

}  // namespace
}  // namespace mb
