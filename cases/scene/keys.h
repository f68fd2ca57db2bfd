// Every key of a case file with what it takes and means: the one home of the format's documentation. The tables of
// cases/README.md, the annotated template and explanations of single keys come from here; tests hold it against what
// the reader asks for.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mb {

struct KeyDoc {
  // "body.material.density". Of what stands in several places once: history.*, disc.*, pose.*, mesh.*; NAME is a
  // profile.
  std::string path;
  std::string type;      // "a number", "an array of 3 numbers", "one of fixed, sliding", "a table"
  std::string range;     // "[1, 1e13]", or in words where it depends on the case; "" for none
  std::string unit;      // "Pa", "" for counts, ratios and text
  std::string fallback;  // value where the key is absent; "required", "required for a box", "none"
  std::string meaning;   // one line
  std::string example;   // TOML value in the template; "": an option or alternative that the template leaves out
};
std::string takes(const KeyDoc& key);  // "a number in [1, 1e13] Pa"

struct KeyGroup {
  std::string title;  // heading in cases/README.md: "`[[load]]`"
  std::vector<KeyDoc> keys;
};
const std::vector<KeyGroup>& key_groups();  // in the order of a case file

// The key at a path as a case file states it: "load.history.omega", "profile.quick.rival.cells",
// "profile.full.resolution.cylinder.degree" find history.omega, study.rival.cells, mesh.degree. nullptr: no such key.
const KeyDoc* find_key(std::string_view path);

std::string markdown_table(const KeyGroup& group);  // with its header rows, a line a key

// A whole case that reads, each key with what it takes, default and meaning; what it leaves out stands in comments.
std::string annotated_template();

}  // namespace mb
