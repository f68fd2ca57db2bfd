#include "harness/store/seal.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace mb {
namespace {

TEST(Seal, TextComesBack) {
  for (const char* text : {"", "a\n", "{\"checksum\":\"0\"}\n"}) EXPECT_EQ(unsealed(sealed(text)), text);
  EXPECT_TRUE(sealed("a\n").starts_with("a\n{\"checksum\":\""));
}

TEST(Seal, EveryFlippedBitAndEveryCutIsRefused) {
  const std::string whole = sealed("{\"value\":0.0123}\n{\"value\":0.0124}\n");
  for (std::size_t n = 0; n < whole.size(); ++n) {
    EXPECT_THROW(unsealed(whole.substr(0, n)), std::runtime_error) << n;
    for (int bit = 0; bit < 8; ++bit) {
      std::string flipped = whole;
      flipped[n] = static_cast<char>(flipped[n] ^ (1 << bit));
      EXPECT_THROW(unsealed(flipped), std::runtime_error) << n;
    }
  }
  EXPECT_THROW(unsealed(whole + "\n"), std::runtime_error);
  EXPECT_THROW(unsealed(whole + whole), std::runtime_error);
}

}  // namespace
}  // namespace mb
