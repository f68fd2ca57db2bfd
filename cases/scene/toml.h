// A TOML document as plain values that know where they stand; toml.cc is the only file that sees the parser's types.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "cases/scene/diagnostics.h"

namespace mb {

struct TomlValue;
struct TomlEntry;

struct TomlTime {};  // dates and times: no key takes one
struct TomlArray {
  std::vector<TomlValue> items;
};
struct TomlTable {
  std::vector<TomlEntry> entries;  // sorted by key, keys unique
};

struct TomlValue {
  std::variant<bool, std::int64_t, double, std::string, TomlTime, TomlArray, TomlTable> value;
  Position where;  // a table: its header, or the braces
};
struct TomlEntry {
  std::string key;
  Position where;  // of the key
  TomlValue value;
};

const char* type_name(const TomlValue& value);  // "an integer", "a string", ...
Position last_place(const TomlTable& table);    // where the last key or table of it, or below it, stands in the file

// The root table, or nothing after one error in `findings`. The text must be valid UTF-8.
// Keys dotted deeper than 16 levels are refused: the parser's recursion would overflow the stack.
std::optional<TomlTable> parse_toml(std::string_view text, Findings& findings);

}  // namespace mb
