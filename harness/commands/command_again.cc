#include "harness/commands/command_again.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cstring>

#include "cases/scene/printable.h"

namespace mb {

namespace {

// Within $'...', byte by byte: no terminal is told what a file's name says.
std::string escaped(const std::string& word) {
  std::string text;
  for (const unsigned char c : word)
    text += std::isalnum(c) ? std::string(1, static_cast<char>(c)) : fmt::format("\\x{:02x}", c);
  return text;
}

// A word as a shell takes it back.
std::string shell_word(const std::string& word) {
  const auto is_plain = [](unsigned char c) { return std::isalnum(c) || std::strchr("-_./=,:+@%", c) != nullptr; };
  if (!word.empty() && std::ranges::all_of(word, is_plain)) return word;
  if (unprintable(word)) return "$'" + escaped(word) + "'";
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

std::string command_again(const RunCommandOptions& options) {
  std::vector<std::string> words{"modalbench", "run"};
  const auto add = [&](std::initializer_list<std::string> more) { words.insert(words.end(), more); };
  for (const auto& name : options.cases) add({name});
  if (options.profile != "quick") add({"--profile", options.profile});
  if (options.store != "results") add({"--store", options.store});
  for (const auto& assignment : options.overrides) add({"--set", assignment});
  if (options.shard != "1/1") add({"--shard", options.shard});
  if (options.jobs != 1) add({"--jobs", std::to_string(options.jobs)});
  if (options.threads != 1) add({"--threads", std::to_string(options.threads)});
  if (options.untimed) add({"--untimed"});
  if (options.again) add({"--again"});
  if (options.quiet) add({"--quiet"});
  for (std::string& word : words) word = shell_word(word);
  return fmt::format("{}", fmt::join(words, " "));
}

}  // namespace

std::string words_of_interruption(const RunCommandOptions& options) {
  return fmt::format("interrupted; what is finished is kept. {}:\n  {}\n",
                     options.again ? "To start over, as --again says" : "To go on", command_again(options));
}

}  // namespace mb
