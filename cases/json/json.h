// The door of nlohmann/json.
//
// JSON that comes from outside goes through parse_json, which limits nesting; dump() throws on text that is not UTF-8,
// to_line does not.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "cases/json/json_type.h"

namespace mb {

// Throws std::runtime_error with one sentence (no text of the input in it) on anything that is not one JSON value, on
// nesting deeper than max_depth, on a key that occurs twice in one object and on numbers outside the range of double.
Json parse_json(std::string_view text, int max_depth = 32);

// One line without a line break; bytes that are not UTF-8 become U+FFFD, numbers that are not finite become null.
std::string to_line(const Json& json);

}  // namespace mb
