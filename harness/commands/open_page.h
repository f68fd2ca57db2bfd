// `report --open`: the page that was just written, shown by what the desktop shows pages with.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <vector>

namespace mb {

// Waits for xdg-open, which hands the page to a browser. A report is no worse for not being shown: where there is no
// page or nothing to show it with, a sentence on err says so.
void open_page(const std::vector<std::filesystem::path>& report, std::ostream& err);

}  // namespace mb
