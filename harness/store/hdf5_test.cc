#include "harness/store/hdf5.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "harness/store/file.h"

namespace mb {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

std::string fixture(const std::string& name) {
  return read_file(std::string(MB_SOURCE_DIR) + "/harness/store/hostile/" + name + ".h5", 1 << 20);
}

Hdf5Content example() {
  MatrixXd values(2, 3);
  values << 1, 2, 3, 4, 5, std::numeric_limits<double>::quiet_NaN();
  return {.counts = {{"schema", 1}, {"least", std::numeric_limits<long>::min()}},
          .texts = {{"status", "ok"}},
          .matrices = {{"values", {values, "m"}}, {"empty", {MatrixXd(3, 0), "-"}}}};
}

TEST(Hdf5, ContentComesBackBitForBit) {
  const Hdf5Content before = example();
  const Hdf5Content after = from_hdf5(to_hdf5(before));
  EXPECT_EQ(after.counts, before.counts);
  EXPECT_EQ(after.texts, before.texts);
  ASSERT_EQ(after.matrices.size(), 2u);
  EXPECT_EQ(after.matrices.at("values").unit, "m");
  EXPECT_EQ(after.matrices.at("values").values.topRows(1), before.matrices.at("values").values.topRows(1));
  EXPECT_TRUE(std::isnan(after.matrices.at("values").values(1, 2)));
  EXPECT_EQ(after.matrices.at("empty").values.rows(), 3);
  EXPECT_EQ(after.matrices.at("empty").values.cols(), 0);
}

TEST(Hdf5, ManyChunksComeBack) {
  // More rows than a chunk has, and more columns than a chunk has.
  for (const auto& [rows, cols] : {std::pair<Index, Index>{150001, 3}, {3, 50001}}) {
    const MatrixXd values = MatrixXd::Random(rows, cols);
    EXPECT_EQ(from_hdf5(to_hdf5({{}, {}, {{"a", {values, "m"}}}})).matrices.at("a").values, values);
  }
}

TEST(Hdf5, SameContentSameBytes) { EXPECT_EQ(to_hdf5(example()), to_hdf5(example())); }

TEST(Hdf5, SmoothValuesAreCompressed) {
  const MatrixXd values = MatrixXd::Constant(100, 1000, 0.1);
  EXPECT_LT(to_hdf5({{}, {}, {{"a", {values, "m"}}}}).size(), 100u * 1000u);  // 1/8 of the plain size
}

TEST(Hdf5, TheControlOfTheHostileFilesIsRead) {
  const Hdf5Content content = from_hdf5(fixture("plain"));
  EXPECT_EQ(content.matrices.at("t").values, MatrixXd::Constant(2, 2, 1.5));
}

TEST(Hdf5, HostileFilesAreRefusedForTheirOwnReason) {
  const std::map<std::string, std::string> reasons = {{"soft-link", "object 't' is a soft, external"},
                                                      {"external-link", "object 't' is a soft, external"},
                                                      {"external-storage", "holds a local heap"},
                                                      {"virtual", "holds a global heap"},
                                                      {"other-filter", "dataset 't' uses a filter other than"},
                                                      {"group", "object 't' is not a dataset"},
                                                      {"huge", "dataset 't' is too large"},
                                                      {"overflow", "dataset 't' is too large"},
                                                      {"huge-chunk", "dataset 't' has chunks of more than"},
                                                      {"wrong-type", "dataset 't' does not hold little-endian doubles"},
                                                      {"three-dimensions", "dataset 't' is not a matrix"},
                                                      {"no-unit", "dataset 't' has no unit"},
                                                      {"variable-text", "holds a global heap"},
                                                      {"array-attribute", "attribute 'schema' is not a single value"},
                                                      {"long-name", "name of a wrong length"}};
  for (const auto& [name, reason] : reasons) {
    EXPECT_THAT([&] { from_hdf5(fixture(name)); }, ThrowsMessage<std::runtime_error>(HasSubstr(reason))) << name;
  }
}

TEST(Hdf5, WhatIsNoHdf5IsRefused) {
  for (const std::string& bytes :
       {std::string(), std::string("\x89HDF\r\n\x1a\n"), fixture("plain").substr(0, 47), std::string(10000, '\0')}) {
    EXPECT_THROW(from_hdf5(bytes), std::runtime_error);
  }
}

TEST(Hdf5, TextsWithoutLengthCannotBeWritten) {
  EXPECT_THROW(to_hdf5({{}, {{"status", ""}}, {}}), std::invalid_argument);
  EXPECT_THROW(to_hdf5({{}, {{"status", std::string(4097, 'x')}}, {}}), std::invalid_argument);
}

TEST(Hdf5, AlteredHostileFilesDoNotCrash) {
  for (const char* name : {"plain", "virtual", "variable-text", "other-filter", "group"}) {
    const std::string sound = fixture(name);
    int n_refused = 0;
    for (std::size_t i = 0; i < sound.size(); i += sound[i] == 0 ? 7 : 1) {
      for (const int mask : {0x01, 0x80, 0xff}) {
        std::string bytes = sound;
        bytes[i] = static_cast<char>(bytes[i] ^ mask);
        try {
          from_hdf5(bytes);
        } catch (const std::runtime_error&) {
          ++n_refused;
        }
      }
    }
    EXPECT_GT(n_refused, 0) << name;
  }
}

}  // namespace
}  // namespace mb
