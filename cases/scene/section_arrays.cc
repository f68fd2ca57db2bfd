// Arrays and tables of a section.
#include <fmt/format.h>

#include <utility>

#include "cases/scene/section.h"

namespace mb {

namespace {

std::string an_array(const Count& count, const std::string& what) {
  return fmt::format("an array of {} {}", to_string(count), what);
}

// All entries read, or nothing where one of them is wrong: each has been reported.
template <class T, class Items, class Read>
std::optional<std::vector<Located<T>>> each(const Items& items, Read read) {
  std::vector<Located<T>> out;
  for (const auto& item : items) {
    if (auto value = read(item)) out.push_back({std::move(*value), item.value->where});
  }
  return out.size() == items.size() ? std::optional(std::move(out)) : std::nullopt;
}

}  // namespace

std::optional<std::vector<double>> Section::as_numbers(const std::string& key, const Item& array, const Range& range,
                                                       const Count& count) {
  const auto found = items(key, array, count, "numbers");
  if (!found) return std::nullopt;
  std::vector<double> out;
  for (const Item& entry : *found) {
    if (const auto x = as_number(entry, range)) out.push_back(*x);
  }
  return out.size() == found->size() ? std::optional(std::move(out)) : std::nullopt;
}

std::optional<std::vector<double>> Section::numbers(const std::string& key, const Range& range, const Count& count) {
  const auto item = required(key, an_array(count, "numbers in " + to_string(range)));
  return item ? as_numbers(key, *item, range, count) : std::nullopt;
}

std::optional<Vector3d> Section::vector(const std::string& key, const Range& range) {
  const auto xyz = numbers(key, range, {3, 3});
  return xyz ? std::optional(Vector3d((*xyz)[0], (*xyz)[1], (*xyz)[2])) : std::nullopt;
}

std::optional<Vector3d> Section::vector_or_zero(const std::string& key, const Range& range) {
  const auto item = find(key, an_array({3, 3}, "numbers in " + to_string(range)));
  if (!item) return Vector3d::Zero();
  const auto xyz = as_numbers(key, *item, range, {3, 3});
  return xyz ? std::optional(Vector3d((*xyz)[0], (*xyz)[1], (*xyz)[2])) : std::nullopt;
}

std::optional<std::vector<Located<int>>> Section::integers(const std::string& key, const Range& range,
                                                           const Count& count) {
  const auto item = required(key, an_array(count, "integers in " + to_string(range)));
  const auto found = item ? items(key, *item, count, "integers") : std::nullopt;
  if (!found) return std::nullopt;
  return each<int>(*found, [&](const Item& entry) { return as_integer(entry, range); });
}

std::optional<std::vector<Located<std::vector<int>>>> Section::integer_lists(const std::string& key, const Range& range,
                                                                             const Count& lists, const Count& entries) {
  const std::string what = fmt::format("arrays of {} integers", to_string(entries));
  const auto item = required(key, an_array(lists, what + " in " + to_string(range)));
  const auto found = item ? items(key, *item, lists, what) : std::nullopt;
  if (!found) return std::nullopt;
  return each<std::vector<int>>(*found, [&](const Item& list) -> std::optional<std::vector<int>> {
    const auto inner = items(key, list, entries, "integers");
    if (!inner) return std::nullopt;
    std::vector<int> out;
    for (const Item& entry : *inner) {
      if (const auto x = as_integer(entry, range)) out.push_back(*x);
    }
    return out.size() == inner->size() ? std::optional(std::move(out)) : std::nullopt;
  });
}

std::optional<std::vector<Located<std::string>>> Section::choices(const std::string& key, const Words& words,
                                                                  const Count& count) {
  const auto item = required(key, an_array(count, words.many));
  const auto found = item ? items(key, *item, count, words.many) : std::nullopt;
  if (!found) return std::nullopt;
  return each<std::string>(*found, [&](const Item& entry) { return as_word(entry, words); });
}

std::optional<Section> Section::section(const std::string& key, bool optional) {
  const std::string what = fmt::format("a table [{}]", path_of(key));
  const auto item = optional ? find(key, what) : required(key, what);
  if (!item) return std::nullopt;
  if (const auto* table = std::get_if<TomlTable>(&item->value->value)) {
    return Section(*table, item->value->where, path_of(key), false, *findings_);
  }
  wrong_type(*item, what);
  return std::nullopt;
}

std::vector<Section> Section::sections(const std::string& key, const Count& count) {
  const std::string what = fmt::format("tables [[{}]]", path_of(key));
  std::vector<Section> out;
  const std::string counted = fmt::format("{} {}", to_string(count), what);
  const auto item = find(key, counted);
  if (!item) {
    if (count.least > 0) missing(key, counted);
    return out;
  }
  const auto found = items(key, *item, count, what);
  if (!found) return out;
  for (const Item& entry : *found) {
    if (const auto* table = std::get_if<TomlTable>(&entry.value->value)) {
      out.emplace_back(*table, entry.value->where, path_of(key), true, *findings_);
    } else {
      wrong_type(entry, fmt::format("a table [[{}]]", path_of(key)));
    }
  }
  return out;
}

}  // namespace mb
