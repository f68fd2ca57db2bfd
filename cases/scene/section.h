// A table of a case file while it is read: every getter checks type and range and records what is wrong; keys that
// nobody asked for are errors when the section is finished.
//
//   Section material = *body.section("material");
//   auto E = material.number("youngs_modulus", {1, 1e13, "Pa"});   // nothing where missing or wrong, and recorded
//   material.finish();
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cases/scene/diagnostics.h"
#include "cases/scene/toml.h"
#include "mechanics/types.h"

namespace mb {

struct Range {
  double least, most;
  std::string unit = "";  // "" for counts and ratios
  bool open_least = false, open_most = false;
  bool contains(double x) const;  // false for NaN
};
std::string to_string(const Range& range);  // "[1, 1e13] Pa"

struct Count {
  std::size_t least, most;
};  // allowed number of entries of an array

// A closed list of words: {{"fixed", "sliding"}, "support kind", "support kinds"}.
struct Words {
  std::vector<std::string> known;
  std::string one, many;
};

template <class T>
struct Located {
  T value;
  Position where;
};

class Section {
 public:
  // path: "body.material", "" for the whole file. The table and the findings must outlive the section.
  Section(const TomlTable& table, Position where, std::string path, bool of_array, Findings& findings);

  // Required keys: nothing where missing or wrong. With a fallback: optional keys, the fallback where absent or wrong.
  std::optional<double> number(const std::string& key, const Range& range);
  double number(const std::string& key, const Range& range, double fallback);
  std::optional<double> number_or(const std::string& word, double meant, const std::string& key, const Range& range);
  std::optional<int> integer(const std::string& key, const Range& range);  // the range lies within that of int
  int integer(const std::string& key, const Range& range, int fallback);
  // Not blank, one line that prints (printable.h); prose may have several lines.
  std::optional<std::string> text(const std::string& key, std::size_t longest);
  std::string text(const std::string& key, std::size_t longest, const std::string& fallback);
  std::optional<std::string> prose(const std::string& key, std::size_t longest);
  std::string prose(const std::string& key, std::size_t longest, const std::string& fallback);
  std::optional<std::string> name(const std::string& key);  // [a-z0-9][a-z0-9-]{0,63}
  std::optional<std::string> choice(const std::string& key, const Words& words);
  std::optional<Vector3d> vector(const std::string& key, const Range& range);
  std::optional<Vector3d> vector_or_zero(const std::string& key, const Range& range);  // optional: zero where absent
  std::optional<std::vector<double>> numbers(const std::string& key, const Range& range, const Count& count);
  std::optional<std::vector<Located<int>>> integers(const std::string& key, const Range& range, const Count& count);
  std::optional<std::vector<Located<std::vector<int>>>> integer_lists(const std::string& key, const Range& range,
                                                                      const Count& lists, const Count& entries);
  std::optional<std::vector<Located<std::string>>> choices(const std::string& key, const Words& words,
                                                           const Count& count);
  std::optional<Section> section(const std::string& key, bool optional = false);  // [key] or key = { ... }
  std::vector<Section> sections(const std::string& key, const Count& count);      // [[key]]

  bool has(const std::string& key);  // the key is known from now on, present or not
  bool is_empty_array(const std::string& key) const;
  void not_yet(const std::string& key);                    // present, it is an error: understood, but not simulated yet
  void missing(const std::string& key, std::string what);  // reported by finish()

  Position where() const { return where_; }
  Position where(const std::string& key) const;  // of its value; of the header where absent
  Position where_key(const std::string& key) const;
  Position where_last() const { return last_place(*table_); }
  const std::string& title() const { return title_; }  // "[body.material]"
  void error(const std::string& key, const std::string& message, const std::string& help = "");
  Findings& findings() { return *findings_; }

  // Reports missing and unknown keys; a missing key whose misspelling is there is reported once, as a misspelling.
  // keys_known: false where the section's kind is wrong, so that what other keys it takes is not known.
  void finish(bool keys_known = true);

 private:
  struct Missing {
    std::string key, what;
  };
  struct Item {
    const TomlValue* value;
    std::string label;
  };  // label: "'modes'", "entry 2 of 'modes'": entries count from 1, as lines and columns do

  const TomlEntry* entry(const std::string& key) const;
  std::optional<std::vector<double>> as_numbers(const std::string& key, const Item& array, const Range& range,
                                                const Count& count);
  // what: what the key takes, for the list of all keys asked for (Findings::asked). The key is known from now on.
  std::optional<Item> find(const std::string& key, const std::string& what);
  std::optional<Item> required(const std::string& key, const std::string& what);
  std::optional<std::vector<Item>> items(const std::string& key, const Item& array, const Count& count,
                                         const std::string& what);
  std::optional<double> as_number(const Item& item, const Range& range);
  std::optional<int> as_integer(const Item& item, const Range& range);
  std::optional<std::string> as_text(const Item& item, std::size_t longest, bool prose);
  std::optional<std::string> as_word(const Item& item, const Words& words);
  void wrong_type(const Item& item, const std::string& expected);
  std::string path_of(const std::string& key) const;

  const TomlTable* table_;
  Position where_;
  std::string path_, title_;
  Findings* findings_;
  std::vector<std::string> known_, later_;
  std::vector<Missing> missing_;
};

std::string to_string(const Count& count);  // "3", "2 to 10000"

}  // namespace mb
