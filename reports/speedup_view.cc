// The tables of what was won: times at equal error, and what they are made of.
#include <cmath>

#include "reports/number.h"
#include "reports/speedup.h"
#include "reports/views.h"

namespace mb {
namespace {

using Kind = Column::Kind;

const Record* offline_of(const Run* run) { return run && run->offline ? &*run->offline : nullptr; }

// [s]; none where the scene is not known.
std::optional<double> duration_of(const Evaluation& evaluation, const SpeedUp& one) {
  const Run* run = run_of(evaluation, one.error);
  return run ? simulated_seconds(evaluation, *run) : std::nullopt;
}

Cell break_even_cell(const Evaluation& evaluation, const SpeedUp& one) {
  const Record* offline = offline_of(run_of(evaluation, one.error));
  const Record* rival_offline = offline_of(run_of(evaluation, one.rival[0]));
  const std::optional<double> duration = duration_of(evaluation, one);
  const bool known = duration && offline && rival_offline && is_usable(*offline) && is_usable(*rival_offline);
  if (!known) return text_cell("unknown");
  const auto seconds =
      break_even(offline->value, one.time.value / *duration, rival_offline->value, one.rival[1].value / *duration);
  return seconds ? number_cell(seconds) : text_cell("never");
}

Cell real_time_cell(const Evaluation& evaluation, const SpeedUp& one, const Record& time) {
  const std::optional<double> duration = duration_of(evaluation, one);
  return duration ? number_cell(real_time_factor(time, *duration)) : text_cell("unknown");
}

std::vector<Cell> key_cells(const SpeedUp& one) {
  const Record& e = one.error;
  return {text_cell(e.case_name),
          text_cell(e.profile),
          text_cell(e.truth),
          text_cell(e.metric),
          text_cell(e.subject),
          text_cell(e.contender.method),
          text_cell(e.contender.integrator),
          takes_modes(e.contender) ? count_cell(e.contender.settings.modes) : text_cell(""),
          text_cell(describe_accuracy(e.contender))};
}

std::vector<Column> key_columns() {
  return {{"case", ""},   {"profile", ""},    {"truth", ""},           {"norm", ""},    {"body", ""},
          {"method", ""}, {"integrator", ""}, {"r", "", Kind::number}, {"steps of", ""}};
}

void append(std::vector<Cell>& row, std::vector<Cell> cells) {
  for (Cell& cell : cells) row.push_back(std::move(cell));
}

std::vector<Cell> rival_cells(const Evaluation& evaluation, const SpeedUp& one) {
  if (one.rival.empty()) {
    std::vector<Cell> cells(9, text_cell(""));
    cells[0] = text_cell("none reached");
    cells[6] = ratio_cell(one);
    return cells;
  }
  const Contender& rival = one.rival[0].contender;
  const std::string steps = describe_accuracy(rival);
  return {text_cell(describe_size(rival) + (steps.empty() ? "" : ", " + steps)),
          text_cell(rival.integrator),
          record_cell(&one.rival[0]),
          margin_cell(one),
          record_cell(&one.rival[1]),
          real_time_cell(evaluation, one, one.rival[1]),
          ratio_cell(one),
          text_cell(is_within_noise(one) ? "within noise"
                    : one.ratio > 1      ? "faster"
                                         : "slower"),
          break_even_cell(evaluation, one)};
}

std::vector<Cell> near_miss_cells(const SpeedUp& one) {
  if (one.near_miss.empty()) return {text_cell(""), text_cell(""), text_cell("")};
  return {text_cell(describe(one.near_miss[0].contender)), record_cell(&one.near_miss[0]), miss_ratio_cell(one)};
}

std::vector<Column> speed_up_columns() {
  std::vector<Column> columns = key_columns();
  for (const Column& column : std::vector<Column>{{"error", "-", Kind::error},
                                                  {"online time", "s", Kind::time},
                                                  {"real-time factor", "-", Kind::number},
                                                  {"rival", ""},
                                                  {"rival integrator", ""},
                                                  {"rival error", "-", Kind::error},
                                                  {"margin", "-", Kind::number},
                                                  {"rival online", "s", Kind::time},
                                                  {"rival real-time factor", "-", Kind::number},
                                                  {"speed-up", "-", Kind::number},
                                                  {"reduced run is", ""},
                                                  {"break-even", "s", Kind::number},
                                                  {"near miss", ""},
                                                  {"miss error", "-", Kind::error},
                                                  {"miss speed-up", "-", Kind::number}}) {
    columns.push_back(column);
  }
  return columns;
}

// Offline and online times and the work of one side.
std::vector<Cell> phase_cells(const Run* run, const Record& error, const Record& time) {
  const Work& work = error.work;
  return {record_cell(offline_of(run)), record_cell(&time), count_cell(work.steps), count_cell(work.solves),
          count_cell(work.factorisations)};
}

}  // namespace

Cell ratio_cell(const SpeedUp& one) {
  if (one.rival.empty()) return text_cell("none reached");
  std::string text = format_number(one.ratio);
  if (std::isnan(one.ratio_low)) {
    text += " (single run)";
  } else {
    const std::string high = std::isfinite(one.ratio_high) ? format_number(one.ratio_high) : "unbounded";
    text += " (" + format_number(one.ratio_low) + " to " + high + ")";
  }
  if (is_within_noise(one)) text += ", within noise";
  return {.text = text, .value = one.ratio};
}

Cell margin_cell(const SpeedUp& one) {
  if (one.rival.empty()) return text_cell("");
  const double margin = rival_margin(one);
  return std::isfinite(margin) ? number_cell(margin) : text_cell("unbounded");
}

Cell miss_ratio_cell(const SpeedUp& one) { return one.near_miss.empty() ? text_cell("") : number_cell(one.miss_ratio); }

Sheet speed_up_table(const Evaluation& evaluation, const std::vector<SpeedUp>& shown) {
  Sheet table{.name = "speed-up",
              .title = "Speed-up at equal error",
              .note =
                  "Reduced runs that no other reduced run beats in both error and time. The rival is the cheapest "
                  "full-order contender at least as exact. Ratio with the range that the spreads of both times "
                  "allow; at exactly equal error it lies between miss speed-up and speed-up. Within noise: the "
                  "spreads leave open which is faster. Real-time factor in simulated seconds per computing second, "
                  "break-even in simulated seconds. data/speed-up-all.csv has every reduced run.",
              .columns = speed_up_columns(),
              .rows = {}};
  for (const SpeedUp& one : shown) {
    std::vector<Cell>& row = table.rows.emplace_back(key_cells(one));
    append(row, {record_cell(&one.error), record_cell(&one.time), real_time_cell(evaluation, one, one.time)});
    append(row, rival_cells(evaluation, one));
    append(row, near_miss_cells(one));
  }
  return table;
}

Sheet phases_table(const Evaluation& evaluation, const std::vector<SpeedUp>& shown) {
  Sheet table{.name = "phases",
              .title = "What the times are made of",
              .note =
                  "Of every pair in the table of speed-ups. Offline: assembly, factorisation, eigensolve, "
                  "projection of the loads; online: stepping and reconstruction at the frame times. Work is counted "
                  "over the run that was graded, at the sample times.",
              .columns = key_columns(),
              .rows = {}};
  for (const std::string side : {"", "rival "}) {
    if (!side.empty()) table.columns.push_back({"rival", ""});
    table.columns.push_back({side + "offline", "s", Kind::time});
    table.columns.push_back({side + "online", "s", Kind::time});
    for (const char* count : {"steps", "solves", "factorisations"}) {
      table.columns.push_back({side + count, "", Kind::number});
    }
  }
  for (const SpeedUp& one : shown) {
    if (one.rival.empty()) continue;
    std::vector<Cell>& row = table.rows.emplace_back(key_cells(one));
    append(row, phase_cells(run_of(evaluation, one.error), one.error, one.time));
    append(row, {text_cell(describe(one.rival[0].contender))});
    append(row, phase_cells(run_of(evaluation, one.rival[0]), one.rival[0], one.rival[1]));
  }
  return table;
}

}  // namespace mb
