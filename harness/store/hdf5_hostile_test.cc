// Files from outside: refused for their own reason, whatever they claim, and never a crash.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "harness/store/file.h"
#include "harness/store/hdf5.h"
#include "harness/store/hdf5_checksums_fuzz.h"

namespace mb {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

std::string file_of(const std::string& folder, const std::string& name) {
  return read_file(std::string(MB_SOURCE_DIR) + "/harness/store/" + folder + "/" + name + ".h5", 1 << 20);
}
std::string fixture(const std::string& name) { return file_of("hostile", name); }
std::string seed(const std::string& name) { return file_of("trajectory_file_fuzz", name); }

Hdf5Content example() {
  return {{{"schema", 1}},
          {{"status", "ok"}},
          {{"values", {MatrixXd{{1, 2, 3}, {4, 5, 6}}, "m"}}, {"empty", {MatrixXd(3, 0), "-"}}}};
}

TEST(Hdf5Hostile, TheControlOfTheHostileFilesIsRead) {
  const Hdf5Content content = from_hdf5(fixture("plain"));
  EXPECT_EQ(content.matrices.at("t").values, MatrixXd::Constant(2, 2, 1.5));
}

TEST(Hdf5Hostile, FilesAreRefusedForTheirOwnReason) {
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
                                                      {"two-layouts", "a message that stands twice"},
                                                      {"empty-layout", "a message ends too early"},
                                                      {"fill-value", "a fill value of its own"},
                                                      {"no-filters", "filters without any"},
                                                      {"chunk-at-zero", "a chunk that skips filters"},
                                                      {"paged-at-zero", "a chunk that skips filters"},
                                                      {"wide-elements", "an array of chunks of another kind"},
                                                      {"unfiltered-edge", "chunks with other flags"},
                                                      {"long-chunk", "a chunk of another size"},
                                                      {"bomb", "holds more than 512 MiB of values"},
                                                      {"edge-bomb", "chunks larger than their datasets"},
                                                      {"many-chunks", "more than 8192 chunks"},
                                                      {"two-names", "an object with two names"},
                                                      {"long-name", "name of a wrong length"}};
  for (const auto& [name, reason] : reasons) {
    EXPECT_THAT([&] { from_hdf5(fixture(name)); }, ThrowsMessage<std::runtime_error>(HasSubstr(reason))) << name;
  }
}

TEST(Hdf5Hostile, WhatIsNoHdf5IsRefused) {
  for (const std::string& bytes :
       {std::string(), std::string("\x89HDF\r\n\x1a\n"), fixture("plain").substr(0, 47), std::string(10000, '\0')}) {
    EXPECT_THROW(from_hdf5(bytes), std::runtime_error);
  }
}

TEST(Hdf5Hostile, AChunkThatUnpacksToAnotherSizeIsRefused) {
  std::string bytes = to_hdf5({{}, {}, {{"a", {MatrixXd::Constant(4, 4, 0.1), "m"}}}});
  EXPECT_NO_THROW(from_hdf5(bytes));
  const std::string nothing("\x78\x9c\x03\0\0\0\0\x01", 8);  // zlib's stream of no bytes
  const std::size_t chunk = bytes.find("\x78\x01");          // that of the chunk begins so
  ASSERT_NE(chunk, std::string::npos);
  EXPECT_THAT([&] { from_hdf5(bytes.replace(chunk, nothing.size(), nothing)); },
              ThrowsMessage<std::runtime_error>(HasSubstr("a chunk of another size")));
}

// Arrays of two chunks, and of five in three pages, the second of which was never written.
TEST(Hdf5Hostile, ArraysOfChunksAreRead) {
  EXPECT_EQ(from_hdf5(seed("two-chunks")).matrices.at("t").values, MatrixXd::Constant(4, 2, 1.5));
  MatrixXd paged = MatrixXd::Constant(4, 5, 1.5);
  paged.middleCols(2, 2).setZero();
  EXPECT_EQ(from_hdf5(seed("paged")).matrices.at("t").values, paged);
}

std::string text_of(const std::string& file, const Hdf5Message& message) {
  return file.substr(message.at, message.prefix + message.size);
}

constexpr std::uint64_t attribute = 12;
// Dataspace, datatype, layout, filters.
bool stands_once(const Hdf5Message& m) { return m.type == 1 || m.type == 3 || m.type == 8 || m.type == 11; }
bool can_be_continued(const Hdf5Message& m) { return m.size >= 16; }  // it is large enough to name a place

// The library heeds the first of two, here one behind the other in what continues the header. Moved there alone they
// are sound.
TEST(Hdf5Hostile, AMessageThatStandsTwiceIsRefused) {
  int n_tried = 0;
  for (std::string sound : {fixture("plain"), seed("two-chunks"), seed("paged"), to_hdf5(example())}) {
    const MatrixXd values = from_hdf5(sound).matrices.rbegin()->second.values;
    for (const Hdf5Message& m : Hdf5Checksums(sound).messages()) {
      if (!stands_once(m) || !can_be_continued(m)) continue;
      const std::string message = text_of(sound, m);
      EXPECT_EQ(from_hdf5(continued(sound, m, message)).matrices.rbegin()->second.values, values) << m.type;
      EXPECT_THAT([&] { from_hdf5(continued(sound, m, message + message)); },
                  ThrowsMessage<std::runtime_error>(HasSubstr("a message that stands twice")))
          << m.type;
      ++n_tried;
    }
  }
  EXPECT_GE(n_tried, 4 * 3);
}

TEST(Hdf5Hostile, AMessageThatStandsAgainInAContinuationIsRefused) {
  int n_tried = 0;
  for (std::string sound : {fixture("plain"), seed("two-chunks"), seed("paged"), to_hdf5(example())}) {
    const std::vector<Hdf5Message> all = Hdf5Checksums(sound).messages();
    for (const Hdf5Message& unit : all) {
      if (unit.type != attribute || !can_be_continued(unit)) continue;
      const std::string moved = text_of(sound, unit);
      EXPECT_NO_THROW(from_hdf5(continued(sound, unit, moved)));
      for (const Hdf5Message& m : all) {
        if (m.header != unit.header || !stands_once(m)) continue;
        EXPECT_THAT([&] { from_hdf5(continued(sound, unit, moved + text_of(sound, m))); },
                    ThrowsMessage<std::runtime_error>(HasSubstr("a message that stands twice")))
            << m.type;
        ++n_tried;
      }
    }
  }
  EXPECT_GE(n_tried, 4 * 3);
}

// The library keeps all of them in memory and looks through all for each.
TEST(Hdf5Hostile, TooManyMessagesAreRefused) {
  std::string sound = seed("two-chunks");
  for (const Hdf5Message& m : Hdf5Checksums(sound).messages()) {
    if (!stands_once(m) || !can_be_continued(m)) continue;
    const std::string message = text_of(sound, m), nil(m.prefix, '\0');
    std::string few = message, many = message;
    for (int i = 0; i < 1000; ++i) few += nil;
    for (int i = 0; i < 40000; ++i) many += nil;
    EXPECT_NO_THROW(from_hdf5(continued(sound, m, few)));
    EXPECT_THAT([&] { from_hdf5(continued(sound, m, many)); },
                ThrowsMessage<std::runtime_error>(HasSubstr("too many messages")));
  }
}

// Every byte of [from, to) altered, HDF5's own checksums set right or left as they are.
struct Tried {
  int n_read = 0, n_refused = 0;
};
Tried altered(const std::string& sound, std::size_t from, std::size_t to, const std::vector<int>& masks, bool right) {
  Tried tried;
  for (std::size_t i = from; i < to; i += sound[i] == 0 && to - from > 500 ? 3 : 1) {
    for (const int mask : masks) {
      std::string bytes = sound;
      bytes[i] = static_cast<char>(bytes[i] ^ mask);
      if (right) Hdf5Checksums(bytes).set_right();
      try {
        from_hdf5(bytes);
        ++tried.n_read;
      } catch (const std::runtime_error&) {
        ++tried.n_refused;
      }
    }
  }
  return tried;
}

TEST(Hdf5Hostile, AlteredHostileFilesDoNotCrash) {
  for (const char* name : {"plain", "virtual", "variable-text", "other-filter", "group"}) {
    const std::string file = fixture(name);
    EXPECT_GT(altered(file, 0, file.size(), {0x01, 0x80, 0xff}, false).n_refused, 0) << name;
  }
}

// As a forger alters them: HDF5's own checksums are right again.
TEST(Hdf5Hostile, AlteredFilesWithRightChecksumsDoNotCrash) {
  for (const std::string& sound : {fixture("plain"), to_hdf5(example()), seed("two-chunks"), seed("paged")}) {
    const Tried tried = altered(sound, 0, sound.size(), {0x01, 0x02, 0x10, 0x80, 0xff}, true);
    EXPECT_GT(tried.n_refused, 0);
    EXPECT_GT(tried.n_read, 0);  // a value, a letter of a name
  }
}

// Of our own writing: three chunks, and the array that names them.
TEST(Hdf5Hostile, AlteredArraysOfChunksDoNotCrash) {
  const std::string sound = to_hdf5({{}, {}, {{"a", {MatrixXd::Constant(3, 50001, 0.1), "m"}}}});
  for (const char* structure : {"FAHD", "FADB"}) {
    const std::size_t at = sound.find(structure);
    ASSERT_NE(at, std::string::npos);
    ASSERT_EQ(sound.find(structure, at + 1), std::string::npos);
    const std::size_t size = structure[2] == 'H' ? 28 : 14 + 3 * 16 + 4;
    const Tried tried = altered(sound, at, at + size, {0x01, 0xff}, true);
    EXPECT_GT(tried.n_refused, 4 * tried.n_read);  // but for checksums, nothing there may be altered
  }
}

TEST(Hdf5Hostile, NothingIsLeftOpen) {
  const std::string sound = to_hdf5(example());
  for (int i = 0; i < 3; ++i) from_hdf5(to_hdf5(example()));
  EXPECT_THROW(to_hdf5({{{"a", 1}}, {{"a", "of the same name"}}, {}}), std::runtime_error);
  altered(sound, 0, sound.size(), {0x01}, true);
  for (const char* name : {"group", "wrong-type", "three-dimensions", "no-unit", "array-attribute", "long-name"})
    EXPECT_THROW(from_hdf5(fixture(name)), std::runtime_error) << name;
  EXPECT_EQ(open_hdf5_objects(), 0);
}

}  // namespace
}  // namespace mb
