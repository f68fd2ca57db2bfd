// What a terminal, a page or an editor may be shown of a text from outside: no character that moves the cursor, sets a
// title, reverses the text or hides. Refused are control characters (C0, DEL, C1), invisible and bidirectional ones,
// and bytes that are not UTF-8.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace mb {

// The text with '?' in the place of each of them, and blanks for tabs; clipped to so many characters.
std::string printable(std::string_view text, std::size_t most = 64);

// One line of it: line ends are blanks as well; cut to so many bytes before.
std::string one_line(std::string_view text, std::size_t most_bytes);

// The first of them, U+FFFD for a byte that is not UTF-8; nothing where the text is none but printable. prose: text
// that may have line ends and tabs.
std::optional<char32_t> unprintable(std::string_view text, bool prose = false);

}  // namespace mb
