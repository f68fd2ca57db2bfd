#include "harness/store/hdf5.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "harness/store/file.h"
#include "harness/store/hdf5_checksums_fuzz.h"

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

TEST(Hdf5, TheControlOfTheHostileFilesIsRead) {
  const Hdf5Content content = from_hdf5(fixture("plain"));
  EXPECT_EQ(content.matrices.at("t").values, MatrixXd::Constant(2, 2, 1.5));
}

TEST(Hdf5, HostileFilesAreRefusedForTheirOwnReason) {
  const std::map<std::string, std::string> reasons = {{"soft-link", "object 't' is a soft, external"},
                                                      {"external-link", "object 't' is a soft, external"},
                                                      {"external-storage", "holds a local heap"},
                                                      {"virtual", "holds a global heap"},
                                                      {"other-filter", "uses a filter other than"},
                                                      {"group", "object 't' is not a dataset"},
                                                      {"huge", "more than 8192 chunks"},
                                                      {"overflow", "more than 8192 chunks"},
                                                      {"huge-chunk", "chunks of more than 512 KiB"},
                                                      {"wrong-type", "dataset 't' does not hold little-endian doubles"},
                                                      {"three-dimensions", "dataset 't' is not a matrix"},
                                                      {"no-unit", "dataset 't' has no unit"},
                                                      {"variable-text", "holds a global heap"},
                                                      {"array-attribute", "attribute 'schema' is not a single value"},
                                                      {"dense-attributes", "damaged: a heap or B-tree"},
                                                      {"tiny-chunks", "damaged: a dataspace beyond its largest"},
                                                      {"attribute-name", "damaged: a name of another length"},
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

TEST(Hdf5, AChunkThatUnpacksToAnotherSizeIsRefused) {
  std::string bytes = to_hdf5({{}, {}, {{"a", {MatrixXd::Constant(4, 4, 0.1), "m"}}}});
  EXPECT_NO_THROW(from_hdf5(bytes));
  const std::string nothing("\x78\x9c\x03\0\0\0\0\x01", 8);  // zlib's stream of no bytes
  const std::size_t chunk = bytes.find("\x78\x01");          // that of the chunk begins so
  ASSERT_NE(chunk, std::string::npos);
  EXPECT_THAT([&] { from_hdf5(bytes.replace(chunk, nothing.size(), nothing)); },
              ThrowsMessage<std::runtime_error>(HasSubstr("a chunk of another size")));
}

// As a forger alters them: HDF5's own checksums are right again.
TEST(Hdf5, AlteredFilesWithRightChecksumsDoNotCrash) {
  for (const std::string& sound : {fixture("plain"), to_hdf5(example())}) {
    int n_refused = 0, n_read = 0;
    for (std::size_t i = 0; i < sound.size(); i += sound[i] == 0 ? 3 : 1) {
      for (const int mask : {0x01, 0x02, 0x10, 0x80, 0xff}) {
        std::string bytes = sound;
        bytes[i] = static_cast<char>(bytes[i] ^ mask);
        Hdf5Checksums(bytes).set_right();
        try {
          from_hdf5(bytes);
          ++n_read;
        } catch (const std::runtime_error&) {
          ++n_refused;
        }
      }
    }
    EXPECT_GT(n_refused, 0);
    EXPECT_GT(n_read, 0);  // a value, a letter of a name
  }
}

}  // namespace
}  // namespace mb
