// Typed values of a section.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <utility>

#include "cases/scene/name.h"
#include "cases/scene/nearest.h"
#include "cases/scene/number_text.h"
#include "cases/scene/section.h"

namespace mb {

namespace {

std::string array_of(const Count& count, const std::string& what) {
  return fmt::format("an array of {} {}", to_string(count), what);
}

bool is_vowel(char c) { return std::string_view("aeiou").find(c) != std::string_view::npos; }

std::string text_of(std::size_t longest) { return fmt::format("a text of at most {} bytes", longest); }

// Empty where there is none.
std::string text_problem(const std::string& text, std::size_t longest, bool prose) {
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) return "is blank";
  if (text.size() > longest) return fmt::format("has {} bytes: at most {}", text.size(), longest);
  const auto hidden = unprintable(text, prose);
  if (!hidden) return "";
  const bool layout = hidden == U'\n' || hidden == U'\t';
  return fmt::format("holds the character U+{:04X}, which {}", static_cast<unsigned>(*hidden),
                     layout ? "a line of text has not" : "does not print");
}

}  // namespace

void Section::wrong_type(const Item& item, const std::string& expected) {
  findings_->error(item.value->where,
                   fmt::format("{} must be {}, not {}", item.label, expected, type_name(*item.value)));
}

std::optional<double> Section::as_number(const Item& item, const Range& range) {
  double x = 0;
  if (const auto* integer = std::get_if<std::int64_t>(&item.value->value)) {
    x = static_cast<double>(*integer);
  } else if (const auto* real = std::get_if<double>(&item.value->value)) {
    x = *real;
  } else {
    wrong_type(item, "a number");
    return std::nullopt;
  }
  if (range.contains(x)) return x + 0.0;  // -0 becomes 0
  const auto* integer = std::get_if<std::int64_t>(&item.value->value);
  findings_->error(item.value->where,
                   fmt::format("{} is {}, outside {}", item.label,
                               integer == nullptr ? number_text(x) : fmt::format("{}", *integer), to_string(range)));
  return std::nullopt;
}

std::optional<int> Section::as_integer(const Item& item, const Range& range) {
  const auto* real = std::get_if<double>(&item.value->value);
  const bool too_long = real != nullptr && std::abs(*real) >= 0x1p63;  // what an override's twenty digits are read as
  if (!std::holds_alternative<std::int64_t>(item.value->value) && !too_long) {
    wrong_type(item, "an integer");
    return std::nullopt;
  }
  const auto x = as_number(item, range);
  return x ? std::optional(static_cast<int>(*x)) : std::nullopt;
}

std::optional<std::string> Section::as_text(const Item& item, std::size_t longest, bool prose) {
  const auto* text = std::get_if<std::string>(&item.value->value);
  if (text == nullptr) {
    wrong_type(item, "a string");
    return std::nullopt;
  }
  const std::string problem = text_problem(*text, longest, prose);
  if (problem.empty()) return *text;
  findings_->error(item.value->where, item.label + " " + problem);
  return std::nullopt;
}

std::optional<std::string> Section::as_word(const Item& item, const Words& words) {
  const auto* text = std::get_if<std::string>(&item.value->value);
  if (text == nullptr) {
    wrong_type(item, fmt::format("a string that names {} {}", is_vowel(words.one[0]) ? "an" : "a", words.one));
    return std::nullopt;
  }
  for (const std::string& known : words.known) {
    if (known == *text) return known;
  }
  findings_->error(item.value->where, fmt::format("unknown {} '{}'", words.one, printable(*text)),
                   suggestion(*text, words.known, words.many));
  return std::nullopt;
}

std::optional<std::vector<Section::Item>> Section::items(const std::string& key, const Item& array, const Count& count,
                                                         const std::string& what) {
  const auto* found = std::get_if<TomlArray>(&array.value->value);
  if (found == nullptr) {
    wrong_type(array, array_of(count, what));
    return std::nullopt;
  }
  if (found->items.size() < count.least || found->items.size() > count.most) {
    findings_->error(array.value->where, fmt::format("{} has {} entries: must be {}", array.label, found->items.size(),
                                                     array_of(count, what)));
    return std::nullopt;
  }
  std::vector<Item> out;
  for (const TomlValue& item : found->items) {
    out.push_back({&item, fmt::format("entry {} of '{}' in {}", out.size() + 1, key, title_)});
  }
  return out;
}

std::optional<double> Section::number(const std::string& key, const Range& range) {
  const auto item = required(key, "a number in " + to_string(range));
  return item ? as_number(*item, range) : std::nullopt;
}

double Section::number(const std::string& key, const Range& range, double fallback) {
  const auto item = find(key, "a number in " + to_string(range));
  return item ? as_number(*item, range).value_or(fallback) : fallback;
}

// The word stands for the value that it means: "auto" for 0.
std::optional<double> Section::number_or(const std::string& word, double meant, const std::string& key,
                                         const Range& range) {
  const std::string what = fmt::format("\"{}\" or a number", word);
  const auto item = required(key, fmt::format("{} in {}", what, to_string(range)));
  if (!item) return std::nullopt;
  if (const auto* text = std::get_if<std::string>(&item->value->value)) {
    if (*text == word) return meant;
    findings_->error(item->value->where, fmt::format("{} is '{}': must be {}", item->label, printable(*text), what),
                     nearest(*text, {word}) ? fmt::format("did you mean '{}'?", word) : "");
    return std::nullopt;
  }
  if (std::holds_alternative<std::int64_t>(item->value->value) || std::holds_alternative<double>(item->value->value)) {
    return as_number(*item, range);
  }
  wrong_type(*item, what);
  return std::nullopt;
}

std::optional<int> Section::integer(const std::string& key, const Range& range) {
  const auto item = required(key, "an integer in " + to_string(range));
  return item ? as_integer(*item, range) : std::nullopt;
}

int Section::integer(const std::string& key, const Range& range, int fallback) {
  const auto item = find(key, "an integer in " + to_string(range));
  return item ? as_integer(*item, range).value_or(fallback) : fallback;
}

std::optional<std::string> Section::text(const std::string& key, std::size_t longest) {
  const auto item = required(key, text_of(longest));
  return item ? as_text(*item, longest, false) : std::nullopt;
}

std::string Section::text(const std::string& key, std::size_t longest, const std::string& fallback) {
  const auto item = find(key, text_of(longest));
  return item ? as_text(*item, longest, false).value_or(fallback) : fallback;
}

std::optional<std::string> Section::prose(const std::string& key, std::size_t longest) {
  const auto item = required(key, text_of(longest));
  return item ? as_text(*item, longest, true) : std::nullopt;
}

std::string Section::prose(const std::string& key, std::size_t longest, const std::string& fallback) {
  const auto item = find(key, text_of(longest));
  return item ? as_text(*item, longest, true).value_or(fallback) : fallback;
}

std::optional<std::string> Section::name(const std::string& key) {
  const auto item = required(key, "a name of 1 to 64 of the characters a-z 0-9 -");
  if (!item) return std::nullopt;
  const auto* text = std::get_if<std::string>(&item->value->value);
  if (text == nullptr) {
    wrong_type(*item, "a string");
    return std::nullopt;
  }
  if (is_name(*text)) return *text;
  findings_->error(item->value->where,
                   fmt::format("{} is '{}': a name has 1 to 64 of the characters a-z 0-9 -, and begins with no -",
                               item->label, printable(*text)));
  return std::nullopt;
}

std::optional<std::string> Section::choice(const std::string& key, const Words& words) {
  const auto item = required(key, fmt::format("one of {}", fmt::join(words.known, ", ")));
  return item ? as_word(*item, words) : std::nullopt;
}

}  // namespace mb
