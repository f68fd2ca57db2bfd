#include "cases/scene/section.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "cases/scene/nearest.h"
#include "cases/scene/number_text.h"

namespace mb {

bool Range::contains(double x) const {
  return (open_least ? x > least : x >= least) && (open_most ? x < most : x <= most);
}

std::string to_string(const Range& range) {
  return fmt::format("{}{}, {}{}{}{}", range.open_least ? '(' : '[', number_text(range.least), number_text(range.most),
                     range.open_most ? ')' : ']', range.unit.empty() ? "" : " ", range.unit);
}

std::string to_string(const Count& count) {
  return count.least == count.most ? fmt::format("{}", count.least) : fmt::format("{} to {}", count.least, count.most);
}

Section::Section(const TomlTable& table, Position where, std::string path, bool of_array, Findings& findings)
    : table_(&table), where_(where), path_(std::move(path)), findings_(&findings) {
  title_ = path_.empty() ? "the case" : fmt::format("{0}{2}{1}", of_array ? "[[" : "[", of_array ? "]]" : "]", path_);
}

std::string Section::path_of(const std::string& key) const { return path_.empty() ? key : path_ + "." + key; }

const TomlEntry* Section::entry(const std::string& key) const {
  for (const TomlEntry& candidate : table_->entries) {
    if (candidate.key == key) return &candidate;
  }
  return nullptr;
}

bool Section::has(const std::string& key) {
  if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.push_back(key);
  return entry(key) != nullptr;
}

std::optional<Section::Item> Section::find(const std::string& key, const std::string& what) {
  findings_->ask(path_of(key), what);
  if (!has(key)) return std::nullopt;
  return Item{&entry(key)->value, fmt::format("'{}' in {}", key, title_)};
}

std::optional<Section::Item> Section::required(const std::string& key, const std::string& what) {
  const auto found = find(key, what);
  if (!found) missing(key, what);
  return found;
}

bool Section::is_empty_array(const std::string& key) const {
  const TomlEntry* found = entry(key);
  const auto* array = found == nullptr ? nullptr : std::get_if<TomlArray>(&found->value.value);
  return array != nullptr && array->items.empty();
}

void Section::missing(const std::string& key, std::string what) {
  has(key);
  missing_.push_back({key, std::move(what)});
}

void Section::not_yet(const std::string& key) {
  later_.push_back(key);
  if (const TomlEntry* found = entry(key)) {
    findings_->error(found->where, fmt::format("'{}' in {} is understood, but cannot be simulated yet", key, title_));
  }
}

Position Section::where(const std::string& key) const {
  const TomlEntry* found = entry(key);
  return found == nullptr ? where_ : found->value.where;
}

Position Section::where_key(const std::string& key) const {
  const TomlEntry* found = entry(key);
  return found == nullptr ? where_ : found->where;
}

void Section::error(const std::string& key, const std::string& message, const std::string& help) {
  findings_->error(where(key), message, help);
}

void Section::finish(bool keys_known) {
  std::vector<std::string> words = known_;
  words.insert(words.end(), later_.begin(), later_.end());
  for (const TomlEntry& found : table_->entries) {
    if (std::find(words.begin(), words.end(), found.key) != words.end()) continue;
    const auto meant = nearest(found.key, words);
    const auto is_meant = [&](const Missing& absent) { return meant && absent.key == *meant; };
    if (!keys_known && std::none_of(missing_.begin(), missing_.end(), is_meant)) continue;
    findings_->error(found.where, fmt::format("unknown key '{}' in {}", printable(found.key), title_),
                     meant ? fmt::format("did you mean '{}'?", *meant) : suggestion(found.key, known_, "keys"));
    std::erase_if(missing_, is_meant);
  }
  for (const Missing& absent : missing_) {
    findings_->error(where_, fmt::format("missing key '{}' in {}: {}", absent.key, title_, absent.what));
  }
}

}  // namespace mb
