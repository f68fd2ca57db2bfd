#include "harness/study/assignments.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "cases/scene/nearest.h"
#include "cases/scene/utf8.h"

namespace mb {

namespace {

template <class T>
std::optional<T> parsed(std::string_view text) {
  T value{};
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && rest == end ? std::optional(value) : std::nullopt;
}

// The part of a line from `first`, `size` long, as read and where it stands.
struct Part {
  std::string_view line;
  int number;
  std::size_t first, size;

  std::string_view text() const { return line.substr(first, size); }
  Position where() const {
    const auto columns = [&](std::size_t from, std::size_t n) {
      return static_cast<int>(n_code_points(line.substr(from, n)));
    };
    return {number, columns(0, first) + 1, columns(first, size)};
  }
  std::vector<Part> split(char separator) const {
    std::vector<Part> parts;
    for (std::size_t start = first; start <= first + size;) {
      const std::size_t end = std::min(line.find(separator, start), first + size);
      parts.push_back({line, number, start, end - start});
      start = end + 1;
    }
    return parts;
  }
};

TomlValue scalar(const Part& part) {
  if (const auto integer = parsed<std::int64_t>(part.text())) return {*integer, part.where()};
  if (const auto number = parsed<double>(part.text())) return {*number, part.where()};
  return {std::string(part.text()), part.where()};
}

TomlValue array(const Part& part, char separator, TomlValue (*entry)(const Part&)) {
  TomlArray all;
  for (const Part& one : part.split(separator)) all.items.push_back(entry(one));
  return {std::move(all), part.where()};
}

TomlValue mesh(const Part& part) { return array(part, 'x', &scalar); }

}  // namespace

const TomlValue* Assignments::find(std::string_view key) const {
  const auto found = std::ranges::find(values, key, &TomlEntry::key);
  return found == values.end() ? nullptr : &found->value;
}

Assignments read_assignments(const std::vector<std::string>& given, const std::vector<std::string>& known_keys,
                             const std::string& cells_key) {
  Assignments all;
  for (std::string line : given) {
    std::ranges::replace(line, '\n', ' ');
    all.text += line + "\n";
  }
  Findings findings("--set", all.text);
  for (std::size_t i = 0; i < given.size(); ++i) {
    const std::string& assignment = given[i];
    const int number = static_cast<int>(i + 1);
    const std::size_t equals = assignment.find('=');
    const std::string key = assignment.substr(0, equals);
    const Position where = Part{assignment, number, 0, key.size()}.where();
    if (std::ranges::find(known_keys, key) == known_keys.end()) {
      findings.error(where, fmt::format("unknown key '{}'", printable(key)), suggestion(key, known_keys, "keys"));
    } else if (equals == std::string::npos) {
      findings.error(where, fmt::format("'{}' has no value: KEY=VALUE[,VALUE...]", key));
    } else if (all.find(key) != nullptr) {
      findings.error(where, fmt::format("'{}' is set twice", key));
    } else {
      const Part values{assignment, number, equals + 1, assignment.size() - equals - 1};
      all.values.push_back({key, where, array(values, ',', key == cells_key ? &mesh : &scalar)});
    }
  }
  if (!findings.empty()) throw CaseErrors(findings.found());
  return all;
}

}  // namespace mb
