// The door to toml++.
#include "cases/scene/toml.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <functional>
#include <tuple>

#include "cases/scene/key_depth.h"

namespace mb {

namespace {

Position position(const toml::source_region& region) {
  Position where{static_cast<int>(region.begin.line), static_cast<int>(region.begin.column), 1};
  if (region.end.line == region.begin.line && region.end.column > region.begin.column) {
    where.length = static_cast<int>(region.end.column - region.begin.column);
  }
  return where;
}

// No value of a case lies deeper than 8 levels: what lies below this many is left out, and its ancestors are unknown
// keys.
constexpr int deepest = 32;

TomlValue converted(const toml::node& node, int depth);

TomlTable converted_table(const toml::table& table, int depth) {
  TomlTable out;
  out.entries.reserve(table.size());
  for (const auto& [key, value] : table) {
    out.entries.push_back({std::string(key.str()), position(key.source()), converted(value, depth + 1)});
  }
  return out;
}

TomlArray converted_array(const toml::array& array, int depth) {
  TomlArray out;
  out.items.reserve(array.size());
  for (const toml::node& item : array) out.items.push_back(converted(item, depth + 1));
  return out;
}

TomlValue converted(const toml::node& node, int depth) {
  TomlValue out{TomlTime{}, position(node.source())};
  if (depth > deepest) return out;
  if (const auto* table = node.as_table()) {
    out.value = converted_table(*table, depth);
  } else if (const auto* array = node.as_array()) {
    out.value = converted_array(*array, depth);
  } else if (const auto* text = node.as_string()) {
    out.value = text->get();
  } else if (const auto* integer = node.as_integer()) {
    out.value = integer->get();
  } else if (const auto* number = node.as_floating_point()) {
    out.value = number->get();
  } else if (const auto* boolean = node.as_boolean()) {
    out.value = boolean->get();
  }
  return out;
}

}  // namespace

const char* type_name(const TomlValue& value) {
  static constexpr const char* names[] = {"a boolean",      "an integer", "a float", "a string",
                                          "a date or time", "an array",   "a table"};
  return names[value.value.index()];
}

Position last_place(const TomlTable& table) {
  Position last{};
  const auto take = [&](const Position& place) {
    if (std::tie(place.line, place.column) > std::tie(last.line, last.column)) last = place;
  };
  const std::function<void(const TomlValue&)> visit = [&](const TomlValue& value) {
    take(value.where);
    if (const auto* array = std::get_if<TomlArray>(&value.value)) std::ranges::for_each(array->items, visit);
    if (const auto* below = std::get_if<TomlTable>(&value.value)) take(last_place(*below));
  };
  for (const TomlEntry& entry : table.entries) {
    take(entry.where);
    visit(entry.value);
  }
  return last;
}

std::optional<TomlTable> parse_toml(std::string_view text, Findings& findings) {
  if (const auto deep = too_deep_key(text, 16)) {
    findings.error(*deep, "a key with more than 16 dotted parts");
    return std::nullopt;
  }
  try {
    return converted_table(toml::parse(text), 0);
  } catch (const toml::parse_error& error) {
    findings.error(position(error.source()), fmt::format("not valid TOML: {}", printable(error.description(), 200)));
    return std::nullopt;
  }
}

}  // namespace mb
