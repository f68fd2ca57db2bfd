#include "cases/scene/nearest.h"

#include <gtest/gtest.h>

#include "cases/scene/utf8.h"

namespace mb {
namespace {

TEST(Edits, count_insertion_deletion_replacement_and_swap) {
  EXPECT_EQ(n_edits("", ""), 0);
  EXPECT_EQ(n_edits("gap", ""), 3);
  EXPECT_EQ(n_edits("gap", "gaps"), 1);
  EXPECT_EQ(n_edits("gap", "ap"), 1);
  EXPECT_EQ(n_edits("gap", "cap"), 1);
  EXPECT_EQ(n_edits("gap", "gpa"), 1);
  EXPECT_EQ(n_edits("kitten", "sitting"), 3);
  EXPECT_EQ(n_edits("modes", "method"), n_edits("method", "modes"));
}

TEST(Edits, compare_a_bounded_length) { EXPECT_EQ(n_edits(std::string(100000, 'a'), std::string(100000, 'b')), 64); }

TEST(Nearest, offers_the_closest_word_and_no_wild_guess) {
  const std::vector<std::string> known{"youngs_modulus", "poissons_ratio", "density"};
  EXPECT_EQ(nearest("youngs_modulos", known), "youngs_modulus");
  EXPECT_EQ(nearest("poison_ratio", known), "poissons_ratio");
  EXPECT_EQ(nearest("colour", known), std::nullopt);
  EXPECT_EQ(nearest("", known), std::nullopt);
  EXPECT_EQ(nearest("ab", {"cd"}), std::nullopt) << "nothing in common, however short";
  EXPECT_EQ(nearest("density", {}), std::nullopt);
}

TEST(Nearest, lists_what_is_known_otherwise) {
  EXPECT_EQ(suggestion("fixd", {"fixed", "sliding"}, "kinds"), "did you mean 'fixed'?");
  EXPECT_EQ(suggestion("glued", {"fixed", "sliding"}, "kinds"), "kinds: fixed, sliding");
  EXPECT_EQ(suggestion("glued", {}, "kinds"), "there are no kinds");
  EXPECT_EQ(suggestion("nope", {"\x1b[31mevil\x07"}, "cases"), "cases: ?[31mevil?") << "names of files";
  EXPECT_EQ(suggestion("\x1b[31mevi", {"\x1b[31mevil"}, "cases"), "did you mean '?[31mevil'?");
}

TEST(Utf8, decodes_one_to_four_bytes) {
  EXPECT_EQ(decode("a", 0).value, U'a');
  EXPECT_EQ(decode("\xc3\xa9", 0).value, U'\u00e9');
  EXPECT_EQ(decode("\xe2\x82\xac", 0).value, U'\u20ac');
  EXPECT_EQ(decode("\xf0\x9d\x84\x9e", 0).value, U'\U0001d11e');
  EXPECT_EQ(n_code_points("a\xc3\xa9\xe2\x82\xac\xf0\x9d\x84\x9e"), 4u);
}

TEST(Utf8, refuses_overlong_surrogate_truncated_and_stray_bytes) {
  for (const std::string_view bytes :
       {"\xc0\x80", "\xc1\xbf", "\xe0\x80\xaf", "\xf0\x80\x80\xaf", "\xed\xa0\x80", "\xf4\x90\x80\x80",
        "\xf8\x88\x80\x80\x80", "\x80", "\xff", "\xe2\x82", "\xc3", "\xe2\x28\xa1"}) {
    EXPECT_FALSE(decode(bytes, 0).valid) << ::testing::PrintToString(std::string(bytes));
    EXPECT_EQ(decode(bytes, 0).bytes, 1u);
  }
}

}  // namespace
}  // namespace mb
