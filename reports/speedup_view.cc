// The table of what was won: times at equal error.
#include <cmath>

#include "reports/number.h"
#include "reports/speedup.h"
#include "reports/speedup_columns.h"
#include "reports/views.h"
#include "reports/words.h"

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

// The method's name where the mesh steps in another basis than its own nodes: "full Q2 1x4, step 0.001 s".
std::string rival_label(const Contender& rival, Theory theory) {
  const std::string method = rival.method == "full-order" ? "" : rival.method + " ";
  return joined({method + describe_size(rival, theory), describe_accuracy(rival)}, ", ");
}

std::vector<Cell> rival_cells(const Evaluation& evaluation, const SpeedUp& one) {
  if (one.rival.empty()) {
    std::vector<Cell> cells(9, text_cell(""));
    cells[0] = text_cell("none reached");
    cells[6] = ratio_cell(one);
    return cells;
  }
  const Contender& rival = one.rival[0].contender;
  return {text_cell(rival_label(rival, theory_of(evaluation, one.error.case_name, one.error.profile))),
          text_cell(describe_integrator(rival)),
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

std::vector<Cell> near_miss_cells(const Evaluation& evaluation, const SpeedUp& one) {
  if (one.near_miss.empty()) return {text_cell(""), text_cell(""), text_cell("")};
  const Theory theory = theory_of(evaluation, one.error.case_name, one.error.profile);
  return {text_cell(describe(one.near_miss[0].contender, theory)), record_cell(&one.near_miss[0]),
          miss_ratio_cell(one)};
}

std::vector<Column> speed_up_columns() {
  std::vector<Column> columns = speed_up_key_columns();
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
                                                  {"miss speed-up", "-", Kind::number},
                                                  {"limits", ""}}) {
    columns.push_back(column);
  }
  return columns;
}

}  // namespace

std::string range_text(const SpeedUp& one) {
  if (one.rival.empty()) return "";
  if (std::isnan(one.ratio_low)) return "single run";
  const std::string high = std::isfinite(one.ratio_high) ? format_number(one.ratio_high) : "unbounded";
  return format_number(one.ratio_low) + " to " + high;
}

Cell ratio_cell(const SpeedUp& one) {
  if (one.rival.empty()) return text_cell("none reached");
  std::string text = format_number(one.ratio) + " (" + range_text(one) + ")";
  if (is_within_noise(one)) text += ", within noise";
  if (has_perturbed_time(one)) text += ", perturbed";
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
                  "full-order contender at least as exact. Ratio with the range that both times allow: their "
                  "spreads, and of perturbed ones what else had the core. Between rival and near miss, neighbours of "
                  "this sweep, lies what exactly equal error costs, if cost rises with accuracy there; a finer or "
                  "wider sweep may find less. Limits: times that were perturbed, rivals at the edge of their sweep. "
                  "Within noise: the ranges leave open which is faster. Real-time factor in simulated seconds per "
                  "computing second, break-even in simulated seconds. data/speed-up-all.csv has every reduced run.",
              .columns = speed_up_columns(),
              .rows = {}};
  for (const SpeedUp& one : shown) {
    std::vector<Cell>& row = table.rows.emplace_back(speed_up_key_cells(one));
    append(row, {record_cell(&one.error), record_cell(&one.time), real_time_cell(evaluation, one, one.time)});
    append(row, rival_cells(evaluation, one));
    append(row, near_miss_cells(evaluation, one));
    row.push_back(text_cell(joined(limits_of(one), "; ")));
  }
  return table;
}

}  // namespace mb
