// The list of a report's files, one path a line, by which the next report removes those that it no longer has:
//
//   report.md | report.html | verification.md | data/NAME.{csv,jsonl,txt} | tables/NAME.tex | figures/NAME.vl.json
//
// NAME of letters, digits, '_' and '-', as reports name their files. The list may have been edited, and what it names
// is removed: a line of any other form names nothing.
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace mb {

// Paths relative to the report's folder.
std::set<std::string> listed_files(std::string_view list);

}  // namespace mb
