#include "harness/store/hdf5.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

namespace mb {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

Hdf5Content example() {
  MatrixXd values(2, 3);
  values << 1, 2, 3, 4, 5, std::numeric_limits<double>::quiet_NaN();
  return {.counts = {{"schema", 1}, {"least", std::numeric_limits<long>::min()}},
          .texts = {{"status", "ok"}},
          .matrices = {{"values", {values, "m"}}, {"empty", {MatrixXd(3, 0), "-"}}}};
}

constexpr std::array<const char*, 6> signatures{"GCOL", "HEAP", "FRHP", "TREE", "BTHD", "SNOD"};

// Every bit is random, so that each of the eight byte planes is stored as it is: MatrixXd::Random leaves low bits zero.
MatrixXd random_bits(Index rows, Index cols, std::mt19937_64& generator) {
  return MatrixXd::NullaryExpr(rows, cols, [&] { return std::bit_cast<double>(generator()); });
}

// With the signature where a shuffle of each stride 1 ... n_strides puts its letters side by side; spread out, since
// letters more frequent than others would make a plane compressible.
MatrixXd with_signature(const char* signature, std::size_t plane, Index n_strides, MatrixXd values) {
  for (Index stride = 1; stride <= n_strides; ++stride) {
    const Index start = (stride - 1) * (values.size() / n_strides);
    for (Index j = 0; j < 4; ++j) {
      std::memcpy(reinterpret_cast<char*>(&values(start + stride * j)) + plane, signature + j, 1);
    }
  }
  return values;
}

// Bit for bit: some are not numbers.
bool comes_back(const MatrixXd& values) {
  const MatrixXd after = from_hdf5(to_hdf5({{}, {}, {{"a", {values, "m"}}}})).matrices.at("a").values;
  return after.rows() == values.rows() && after.cols() == values.cols() &&
         std::memcmp(after.data(), values.data(), static_cast<std::size_t>(values.size()) * sizeof(double)) == 0;
}

TEST(Hdf5, LoadsNoPlugins) {
  from_hdf5(to_hdf5(example()));
  EXPECT_TRUE(hdf5_plugins_are_off());
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

TEST(Hdf5, FullMantissasComeBack) {
  std::mt19937_64 generator(1);
  std::uniform_real_distribution<double> sign_and_size(-1, 1);
  for (int k = 0; k < 200; ++k) {
    MatrixXd values = random_bits(300, 60, generator);  // the 177th and the 198th hold a signature by chance
    for (double& value : values.reshaped()) {
      value = std::copysign(1.0, sign_and_size(generator)) *
              std::bit_cast<double>((std::bit_cast<std::uint64_t>(value) >> 12) | std::bit_cast<std::uint64_t>(1.0));
    }
    EXPECT_TRUE(comes_back(values)) << k;
  }
}

TEST(Hdf5, ValuesThatHoldASignatureOfARefusedStructureComeBack) {
  std::mt19937_64 generator(2);
  for (const char* signature : signatures) {
    for (std::size_t plane = 0; plane < sizeof(double); ++plane) {
      for (const Index n_strides : {1, 20}) {
        EXPECT_TRUE(comes_back(with_signature(signature, plane, n_strides, random_bits(100, 60, generator))))
            << signature << " in byte " << plane << ", strides up to " << n_strides;
      }
    }
  }
}

TEST(Hdf5, SignaturesThatNoStrideParts) {
  std::mt19937_64 generator(3);
  MatrixXd values = random_bits(200, 200, generator);
  // In two planes: the compressor cuts the bytes into blocks, and may cut a signature in two.
  for (const std::size_t plane : {1u, 5u}) values = with_signature("TREE", plane, 63, values);
  EXPECT_TRUE(comes_back(values));
  for (const std::size_t plane : {1u, 5u}) values = with_signature("TREE", plane, 64, values);
  const auto fails = ThrowsMessage<std::runtime_error>(HasSubstr("cannot be told from structures of HDF5"));
  EXPECT_THAT([&] { to_hdf5({{}, {}, {{"a", {values, "m"}}}}); }, fails);
  EXPECT_THAT([&] { to_hdf5({{}, {{"status", "a TREE"}}, {}}); }, fails);
}

TEST(Hdf5, SameContentSameBytes) { EXPECT_EQ(to_hdf5(example()), to_hdf5(example())); }

TEST(Hdf5, SmoothValuesAreCompressed) {
  const MatrixXd values = MatrixXd::Constant(100, 1000, 0.1);
  EXPECT_LT(to_hdf5({{}, {}, {{"a", {values, "m"}}}}).size(), 100u * 1000u);  // 1/8 of the plain size
}

TEST(Hdf5, WhatNoReaderTakesIsNotWritten) {
  const auto refuses = [](const Hdf5Content& content, const std::string& why) {
    EXPECT_THAT([&] { to_hdf5(content); }, ThrowsMessage<std::invalid_argument>(HasSubstr(why))) << why;
  };
  for (const std::string& text : {std::string(), std::string(4097, 'x'), std::string("a\0b", 3)}) {
    refuses({{}, {{"status", text}}, {}}, "text 'status' is not of 1 to 4096 bytes");
    refuses({{}, {}, {{"a", {MatrixXd(1, 1), text}}}}, "text 'a' is not of");
  }
  for (const std::string& name : {std::string(), std::string(65, 'x'), std::string("a/b"), std::string("a\0b", 3)}) {
    refuses({{{name, 1}}, {}, {}}, "a name of 1 to 64 bytes");
    refuses({{}, {{name, "x"}}, {}}, "a name of 1 to 64 bytes");
    refuses({{}, {}, {{name, {MatrixXd(1, 1), "m"}}}}, "a name of 1 to 64 bytes");
  }
  Hdf5Content large;  // never touched
  for (const char* name : {"a", "b"}) large.matrices[name] = {MatrixXd(Index{1} << 13, Index{1} << 12), "m"};
  large.matrices["c"] = {MatrixXd(1, 1), "m"};
  refuses(large, "67108865 values, more than 67108864 (512 MiB)");
}

std::string longest_name(Index i) {
  std::string name = "object_" + std::to_string(i);
  name.resize(hdf5_max_name, '_');
  return name;
}

TEST(Hdf5, AsManyMatricesAsAreWrittenAreRead) {
  Hdf5Content content;
  for (Index i = 0; i < hdf5_max_objects; ++i)
    content.matrices[longest_name(i)] = {MatrixXd::Constant(1, 2, static_cast<double>(i)),
                                         std::string(i % 100 ? 1 : hdf5_max_text, 'm')};
  const Hdf5Content after = from_hdf5(to_hdf5(content));
  ASSERT_EQ(after.matrices.size(), content.matrices.size());
  for (const auto& [name, matrix] : content.matrices) {
    EXPECT_EQ(after.matrices.at(name).values, matrix.values);
    EXPECT_EQ(after.matrices.at(name).unit, matrix.unit);
  }
  content.matrices["b"] = {MatrixXd(1, 1), "m"};
  EXPECT_THAT([&] { to_hdf5(content); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("1025 matrices, more than 1024")));
}

TEST(Hdf5, AsManyCountsAndTextsAsAreWrittenAreRead) {
  Hdf5Content content;
  for (Index i = 0; i < hdf5_max_objects; ++i) {
    if (i % 2 == 0) content.counts[longest_name(i)] = i;
    if (i % 2 == 1) content.texts[longest_name(i)] = std::string(hdf5_max_text, 'x');
  }
  const Hdf5Content after = from_hdf5(to_hdf5(content));
  EXPECT_EQ(after.counts, content.counts);
  EXPECT_EQ(after.texts, content.texts);
  content.counts["b"] = 1;
  EXPECT_THAT([&] { to_hdf5(content); }, ThrowsMessage<std::invalid_argument>(HasSubstr("1025 counts and texts")));
}

TEST(Hdf5, WhatFollowsTheEndIsRefused) {
  const std::string bytes = to_hdf5({.counts = {{"n", 3}}, .texts = {}, .matrices = {}});
  EXPECT_EQ(from_hdf5(bytes).counts.at("n"), 3);
  EXPECT_THROW(from_hdf5(bytes + "x"), std::runtime_error);
}

}  // namespace
}  // namespace mb
