// A table in the three text formats. Whatever stands in a cell prints as itself: it never becomes a tag, a formula of a
// spreadsheet or a TeX command.
#pragma once

#include <string>
#include <string_view>

#include "reports/sheet.h"

namespace mb {

// GitHub-flavoured Markdown.
std::string markdown_text(std::string_view text);  // for a cell, a heading or a paragraph
std::string markdown(const Sheet& table);          // without its title

// RFC 4180 with \n; numbers at full precision; error columns are followed by their bar and status. Text that begins
// with = + - @ or a control character gets a leading apostrophe, which spreadsheets drop.
std::string csv_text(std::string_view text);
std::string csv(const Sheet& table);

// booktabs: \usepackage{booktabs,longtable}; one longtable.
std::string latex_text(std::string_view text);
std::string latex(const Sheet& table);

}  // namespace mb
