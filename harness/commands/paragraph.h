// Text broken into lines for a terminal.
#pragma once

#include <string>
#include <string_view>

namespace mb {

// Words of the text in lines of at most `width` columns (a longer word stands alone), the first after `first`, others
// after `indent`. UTF-8 code points count as one column;
// characters that would move the cursor, hide or reverse text become '?'.
std::string paragraph(std::string_view text, const std::string& first, const std::string& indent, int width = 100);

}  // namespace mb
