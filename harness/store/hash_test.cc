#include "harness/store/hash.h"

#include <gtest/gtest.h>

namespace mb {
namespace {

TEST(ContentHash, AgreesWithThePublishedValueOfTheEmptyInput) {
  // xxHash's sanity vectors: XXH3 128 bit, length 0, seed 0.
  EXPECT_EQ(content_hash(""), "99aa06d3014798d86001c324468d497f");
}

TEST(ContentHash, EveryByteCounts) {
  const std::string content(1000, 'a');
  for (const std::size_t i : {0u, 499u, 999u}) {
    std::string other = content;
    other[i] ^= 1;
    EXPECT_NE(content_hash(other), content_hash(content));
  }
  EXPECT_NE(content_hash(std::string("a\0b", 3)), content_hash("a"));
  EXPECT_TRUE(is_content_hash(content_hash(content)));
}

TEST(ContentHash, OtherNamesAreNotMistakenForHashes) {
  for (const char* text : {"", "../../../../../../../etc/passwd.x", "99AA06D3014798D86001C324468D497F",
                           "99aa06d3014798d86001c324468d497", "99aa06d3014798d86001c324468d497f0"}) {
    EXPECT_FALSE(is_content_hash(text)) << text;
  }
}

}  // namespace
}  // namespace mb
