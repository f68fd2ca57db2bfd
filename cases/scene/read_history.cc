#include "cases/scene/read_history.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cases/scene/number_text.h"
#include "cases/scene/table_file.h"

namespace mb {

namespace {

const Range time_range{0, 1e5, "s"};
const Range length_range{0, 1e5, "s", true};
const Range phase_range{-1e3, 1e3, "rad"};
const Range omega_range{0, 1e9, "rad/s", true};
const Range sweep_range{0, 1e9, "rad/s"};
constexpr std::size_t most_entries = 10000;
constexpr double most_periods = 1e6;

// Times nearer than this are one to every integrator, and to adaptive ones a step they cannot make.
double apart(const HistoryContext& context) { return 1e-12 * context.longest_duration.value_or(0); }
bool has_ended(double t, const HistoryContext& context) {
  return context.longest_duration && t >= *context.longest_duration;
}
Range amplitude_range(const HistoryContext& context) { return {-1e6, 1e6, context.amplitude_unit}; }

std::optional<double> read_length(Section& section, const HistoryContext& context) {
  const auto length = section.number("duration", length_range);
  if (!length || *length >= apart(context)) return length;
  section.error("duration", fmt::format("a load lasts 1e-12 of the case at least, {} s: {} s",
                                        number_text(apart(context)), number_text(*length)));
  return std::nullopt;
}

struct Common {
  double amplitude, start;
};

Common read_common(Section& section, const HistoryContext& context) {
  const Common common{section.number("amplitude", amplitude_range(context), 1), section.number("start", time_range, 0)};
  if (has_ended(common.start, context)) {
    section.error("start", fmt::format("the load starts at {} s, but the case ends at {} s", number_text(common.start),
                                       number_text(*context.longest_duration)));
  }
  return common;
}

// Adaptive steps follow every period, some ten each: a million take days, and units are more likely wrong.
bool has_few_periods(Section& section, const char* key, double omega, const HistoryContext& context) {
  const double periods = omega * context.longest_duration.value_or(0) / (2 * std::numbers::pi);
  if (periods <= most_periods) return true;
  section.error(key, fmt::format("{} rad/s are {} periods until the case ends at {} s: at most {}", number_text(omega),
                                 number_beside(periods, most_periods), number_text(*context.longest_duration),
                                 number_text(most_periods)));
  return false;
}

std::optional<History> read_harmonic(Section& section, const Common& common, const HistoryContext& context) {
  const auto omega = section.number("omega", omega_range);
  const double phase = section.number("phase", phase_range, 0);
  if (!omega || !has_few_periods(section, "omega", *omega, context)) return std::nullopt;
  return Harmonic{*omega, phase, common.amplitude, common.start};
}

std::optional<History> read_chirp(Section& section, const Common& common, const HistoryContext& context) {
  const auto omega0 = section.number("omega0", sweep_range);
  const auto omega1 = section.number("omega1", sweep_range);
  const auto duration = read_length(section, context);
  if (!omega0 || !omega1 || !duration) return std::nullopt;
  if (!has_few_periods(section, "omega0", *omega0, context) || !has_few_periods(section, "omega1", *omega1, context))
    return std::nullopt;
  return Chirp{*omega0, *omega1, *duration, common.amplitude, common.start};
}

template <class Shaped>
std::optional<History> read_shaped(Section& section, const Common& common, const HistoryContext& context) {
  const auto duration = read_length(section, context);
  if (!duration) return std::nullopt;
  return Shaped{*duration, common.amplitude, common.start};
}

// A table and how its entries are called. What a file holds is never told, not even its times.
struct NamedTable {
  TableFile read;
  std::string key;   // at which its problems are reported
  std::string file;  // empty: stated in the case itself

  std::string entry(std::size_t i) const {
    return file.empty() ? fmt::format("entry {}", i + 1)
                        : fmt::format("line {} of '{}'", read.lines[i], printable(file, 255));
  }
};

std::optional<NamedTable> inline_table(Section& section, const HistoryContext& context) {
  const auto t = section.numbers("t", time_range, {2, most_entries});
  const auto s = section.numbers("s", amplitude_range(context), {2, most_entries});
  if (!t || !s) return std::nullopt;
  if (t->size() == s->size()) return NamedTable{{{*t, *s}, {}, ""}, "t", ""};
  section.error("s", fmt::format("'s' has {} entries where 't' has {}", s->size(), t->size()));
  return std::nullopt;
}

std::optional<NamedTable> table_of_file(Section& section, const HistoryContext& context) {
  const auto file = section.text("file", 255);
  for (const char* key : {"t", "s"}) {
    if (section.has(key))
      section.error(key, fmt::format("a table has either 'file' or 't' and 's', not '{}' as well", key));
  }
  if (!file) return std::nullopt;
  const auto rows = section.has("rows") ? section.integer("rows", {2, most_entries}) : std::nullopt;
  NamedTable named{read_table_file(context.folder, *file, most_entries), "file", *file};
  const std::size_t n = named.read.table.t.size();
  if (!named.read.problem.empty())
    section.error("file", named.read.problem);
  else if (rows && n != static_cast<std::size_t>(*rows))
    section.error("rows", fmt::format("'{}' has {} entries, not {}: it may be cut", printable(*file, 255), n, *rows));
  else
    return named;
  return std::nullopt;
}

bool ascends(const NamedTable& named, Section& section, const HistoryContext& context) {
  const std::vector<double>& t = named.read.table.t;
  for (std::size_t i = 1; i < t.size(); ++i) {
    const bool later = t[i] > t[i - 1];
    if (later && t[i] >= t[i - 1] + apart(context)) continue;
    const std::string found =
        named.file.empty()
            ? fmt::format("t = {} s at entry {} follows {} s", number_text(t[i]), i + 1, number_text(t[i - 1]))
            : named.entry(i) + (later ? " follows the entry before by less" : " does not follow the entry before");
    section.error(named.key, later ? fmt::format("times must be 1e-12 of the duration apart, {} s: {}",
                                                 number_text(apart(context)), found)
                                   : "times must ascend: " + found);
    return false;
  }
  return true;
}

bool within_ranges(const NamedTable& named, Section& section, const HistoryContext& context) {
  const auto& [t, s] = named.read.table;
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (time_range.contains(t[i]) && amplitude_range(context).contains(s[i])) continue;
    section.error(named.key, fmt::format("{} leaves t in {} or s in {}", named.entry(i), to_string(time_range),
                                         to_string(amplitude_range(context))));
    return false;
  }
  return true;
}

std::optional<History> read_table(Section& section, const HistoryContext& context) {
  const auto named = section.has("file") ? table_of_file(section, context) : inline_table(section, context);
  if (!named) return std::nullopt;
  const bool in_order = ascends(*named, section, context), in_range = within_ranges(*named, section, context);
  if (!in_order || !in_range) return std::nullopt;
  const Table& table = named->read.table;
  if (!has_ended(table.t.front(), context)) return table;
  const std::string end = number_text(*context.longest_duration);
  section.error(named->key, named->file.empty()
                                ? fmt::format("the load starts at {} s, but the case ends at {} s",
                                              number_text(table.t.front()), end)
                                : fmt::format("the load starts after the case has ended, at {} s", end));
  return std::nullopt;
}

std::optional<History> read_expression(Section& section, const HistoryContext& context) {
  const auto formula = section.text("formula", 256);
  if (!formula) return std::nullopt;
  const double duration = context.longest_duration.value_or(0);
  const std::string problem = expression_problem(*formula, duration, context.looked_at);
  if (!problem.empty()) {
    section.error("formula", printable(problem, 200));
    return std::nullopt;
  }
  const Expression expression{*formula};
  const Range range = amplitude_range(context);
  double largest = peak(expression, duration);
  const auto s = evaluator(expression);
  for (const double t : context.looked_at) largest = std::max(largest, std::abs(s(t)));
  if (range.contains(largest)) return expression;
  section.error("formula", fmt::format("the formula reaches {} in absolute value, outside {}",
                                       number_beside(largest, range.most), to_string(range)));
  return std::nullopt;
}

std::optional<History> read_kind(const std::string& kind, Section& section, const HistoryContext& context) {
  if (kind == "table") return read_table(section, context);
  if (kind == "expression") return read_expression(section, context);
  const Common common = read_common(section, context);
  if (kind == "step") return Step{common.amplitude, common.start};
  if (kind == "pulse") return read_shaped<Pulse>(section, common, context);
  if (kind == "ramp") return read_shaped<Ramp>(section, common, context);
  if (kind == "harmonic") return read_harmonic(section, common, context);
  return read_chirp(section, common, context);
}

}  // namespace

std::optional<History> read_history(Section section, const HistoryContext& context) {
  const Words words{
      {"step", "pulse", "ramp", "harmonic", "chirp", "table", "expression"}, "history kind", "history kinds"};
  const auto kind = section.choice("kind", words);
  if (!kind) {
    section.finish(false);
    return std::nullopt;
  }
  const auto history = read_kind(*kind, section, context);
  section.finish();
  return history;
}

}  // namespace mb
