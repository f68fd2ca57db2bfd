#include "cases/scene/diagnostics.h"

#include <gtest/gtest.h>

namespace mb {
namespace {

TEST(Diagnostics, print_place_message_excerpt_carets_and_help) {
  const Diagnostic diagnostic{"bad.toml",
                              3,
                              1,
                              14,
                              "unknown key 'youngs_modulos' in [body.material]",
                              "youngs_modulos = 2.1e11",
                              "did you mean 'youngs_modulus'?"};
  EXPECT_EQ(to_string(diagnostic),
            "bad.toml:3:1: error: unknown key 'youngs_modulos' in [body.material]\n"
            "    3 | youngs_modulos = 2.1e11\n"
            "      | ^^^^^^^^^^^^^^\n"
            "  help: did you mean 'youngs_modulus'?\n");
}

TEST(Diagnostics, of_the_file_as_a_whole_have_no_excerpt) {
  EXPECT_EQ(to_string(Diagnostic{"bad.toml", 0, 0, 1, "the file is empty", "", ""}),
            "bad.toml: error: the file is empty\n");
}

TEST(Diagnostics, carets_count_characters_and_end_with_the_line) {
  const Diagnostic diagnostic{"a.toml", 12, 5, 99, "m", "\xc3\xa9 = 1", ""};
  EXPECT_EQ(to_string(diagnostic), "a.toml:12:5: error: m\n   12 | \xc3\xa9 = 1\n      |     ^\n");
  const Diagnostic beyond{"a.toml", 1, 500, 3, "m", "clipped...", ""};
  EXPECT_EQ(to_string(beyond), "a.toml:1:500: error: m\n    1 | clipped...\n");
}

TEST(Diagnostics, are_sorted_by_line_and_column) {
  const CaseErrors errors({{"a", 2, 1, 1, "third", "", ""},
                           {"a", 1, 9, 1, "second", "", ""},
                           {"a", 1, 2, 1, "first", "", ""},
                           {"a", 0, 0, 1, "whole", "", ""}});
  std::string order;
  for (const auto& diagnostic : errors.diagnostics()) order += diagnostic.message + " ";
  EXPECT_EQ(order, "whole first second third ");
  EXPECT_NE(std::string(errors.what()).find("a:1:2: error: first"), std::string::npos);
}

TEST(Findings, take_excerpts_from_the_text_with_either_line_end) {
  const std::string text = "one\r\ntwo\tx\nthree";
  Findings findings("f.toml", text);
  for (int line : {1, 2, 3, 4}) findings.error({line, 1, 1}, "m");
  ASSERT_EQ(findings.found().size(), 4u);
  EXPECT_EQ(findings.found()[0].excerpt, "one");
  EXPECT_EQ(findings.found()[1].excerpt, "two x");
  EXPECT_EQ(findings.found()[2].excerpt, "three");
  EXPECT_EQ(findings.found()[3].excerpt, "");
}

TEST(Printable, shows_no_character_that_moves_the_cursor_or_hides) {
  EXPECT_EQ(printable("a\x1b[31mb\x7f"), "a?[31mb?");
  EXPECT_EQ(printable("\xe2\x80\xae"
                      "abc"),
            "?abc")
      << "right-to-left override";
  EXPECT_EQ(printable("a\xff"
                      "b"),
            "a?b")
      << "not UTF-8";
  EXPECT_EQ(printable("\xc2\x9b"
                      "31m"),
            "?31m")
      << "C1 control sequence introducer";
  EXPECT_EQ(printable("tab\tnewline\n"), "tab newline?");
  EXPECT_EQ(printable("h\xc3\xa9"), "h\xc3\xa9");
  EXPECT_EQ(printable(std::string(100, 'a'), 3), "aaa...");
}

TEST(Printable, is_known_by_the_first_character_that_is_not) {
  EXPECT_FALSE(unprintable("a line, h\xc3\xa9"));
  EXPECT_FALSE(unprintable("two\r\nlines\n\tand a tab", true));
  EXPECT_EQ(unprintable("two\nlines"), U'\n');
  EXPECT_EQ(unprintable("back\rover", true), U'\r') << "alone it writes over the line";
  EXPECT_EQ(unprintable("a\x1b[2J", true), 0x1bu);
  EXPECT_EQ(unprintable("\xc2\x9b"), 0x9bu);
  EXPECT_EQ(unprintable("\xe2\x80\xae"), 0x202eu);
  EXPECT_EQ(unprintable("\xff"), 0xfffdu);
  for (const char* invisible : {"\u115f", "\u180e", "\u2800", "\u3164", "\ufe0f", "\uffa0", "\ufff9"})
    EXPECT_TRUE(unprintable(invisible)) << invisible;
  EXPECT_FALSE(unprintable("\u1161\u2801\u3163\ufffc")) << "their neighbours";
  EXPECT_EQ(unprintable(std::string_view("\0", 1), true), 0u);
}

TEST(Printable, is_one_line_of_any_text) {
  EXPECT_EQ(one_line("two\r\nlines \x1b[31m", 100), "two  lines ?[31m");
  EXPECT_EQ(one_line("h\xc3\xa9", 2), "h?") << "cut within a character";
  EXPECT_EQ(one_line("", 5), "");
}

}  // namespace
}  // namespace mb
