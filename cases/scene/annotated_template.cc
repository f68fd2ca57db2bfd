#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "cases/scene/keys.h"

namespace mb {

namespace {

constexpr std::size_t width = 110;  // [characters] of a comment line

// A comment, broken at blanks.
std::string comment(const std::string& text) {
  std::istringstream words(text);
  std::string out, line = "#";
  for (std::string word; words >> word;) {
    if (line.size() + 1 + word.size() > width) {
      out += line + "\n";
      line = "#  ";
    }
    line += " " + word;
  }
  return out + line + "\n";
}

std::string table_of(const std::string& path) {
  const std::size_t dot = path.rfind('.');
  return dot == std::string::npos ? "" : path.substr(0, dot);
}

bool is_table(const KeyDoc& key) { return key.type == "a table" || key.type.ends_with("tables"); }

std::string header_of(const std::string& table) {
  const KeyDoc* doc = find_key(table);
  const bool is_array = doc != nullptr && doc->type.ends_with("tables");
  return fmt::format("\n{0}{2}{1}\n", is_array ? "[[" : "[", is_array ? "]]" : "]", table);
}

bool has_example(const KeyGroup& group, const std::string& below) {
  return std::any_of(group.keys.begin(), group.keys.end(),
                     [&](const KeyDoc& key) { return !key.example.empty() && key.path.starts_with(below); });
}

bool is_shown(const KeyGroup& group) { return has_example(group, ""); }

// Whether the template has the table: by its header, and so its comment needs none.
bool stands(const KeyDoc& table) {
  return std::any_of(key_groups().begin(), key_groups().end(),
                     [&](const KeyGroup& group) { return has_example(group, table.path + "."); });
}

std::string note_of(const KeyDoc& key) {
  const bool has_default = !key.fallback.starts_with("required") && !key.fallback.starts_with("this or");
  return fmt::format("{}; {}{}: {}", takes(key), has_default ? "default " : "", key.fallback, key.meaning);
}

std::string shown(const KeyGroup& group) {
  std::string out, table;
  for (const KeyDoc& key : group.keys) {
    if (key.example.empty() && is_table(key) && stands(key)) continue;
    if (table_of(key.path) != table && !key.example.empty()) {
      table = table_of(key.path);
      out += header_of(table);
    }
    const std::string name = key.path.substr(key.path.rfind('.') + 1);  // the whole path where it has no dot
    if (key.example.empty()) {
      out += comment(fmt::format("{}: {}", table_of(key.path) == table ? name : key.path, note_of(key)));
    } else {
      out += comment(note_of(key)) + fmt::format("{} = {}\n", name, key.example);
    }
  }
  return out;
}

// Keys that no table of the template holds: of histories, discs and meshes, or of tables that a case may leave out.
std::string commented(const KeyGroup& group) {
  std::string out = "\n" + comment("-- " + group.title);
  for (const KeyDoc& key : group.keys) out += comment(fmt::format("{}: {}", key.path, note_of(key)));
  return out;
}

}  // namespace

std::string annotated_template() {
  std::string out = comment("A case: what happens, how it is looked at, who answers, what must hold. SI units.");
  for (const KeyGroup& group : key_groups()) {
    if (is_shown(group)) out += shown(group);
  }
  for (const KeyGroup& group : key_groups()) {
    if (!is_shown(group)) out += commented(group);
  }
  return out + header_of("end");
}

}  // namespace mb
