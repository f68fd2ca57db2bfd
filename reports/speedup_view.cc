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
  if (!seconds) return text_cell("never");
  const Range range = break_even_range({*offline, one.time}, {*rival_offline, one.rival[1]}, *duration);
  return quotient_cell(*seconds, range.low, range.high);
}

Cell real_time_cell(const Evaluation& evaluation, const SpeedUp& one, const Record& time) {
  const std::optional<double> duration = duration_of(evaluation, one);
  if (!duration) return text_cell("unknown");
  const Range range = real_time_range(time, *duration);
  return quotient_cell(real_time_factor(time, *duration), range.low, range.high);
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
                                                  {"real-time factor", "-", Kind::quotient},
                                                  {"rival", ""},
                                                  {"rival integrator", ""},
                                                  {"rival error", "-", Kind::error},
                                                  {"margin", "-", Kind::quotient},
                                                  {"rival online", "s", Kind::time},
                                                  {"rival real-time factor", "-", Kind::quotient},
                                                  {"speed-up", "-", Kind::quotient},
                                                  {"reduced run is", ""},
                                                  {"break-even", "s", Kind::quotient},
                                                  {"near miss", ""},
                                                  {"miss error", "-", Kind::error},
                                                  {"miss speed-up", "-", Kind::quotient},
                                                  {"limits", ""}}) {
    columns.push_back(column);
  }
  return columns;
}

}  // namespace

std::string range_text(const SpeedUp& one) {
  if (one.rival.empty()) return "";
  return format_range(one.ratio_low, one.ratio_high);
}

Cell ratio_cell(const SpeedUp& one) {
  if (one.rival.empty()) return text_cell("none reached");
  Cell cell = quotient_cell(one.ratio, one.ratio_low, one.ratio_high);
  if (is_within_noise(one)) cell.text += ", within noise";
  if (has_perturbed_time(one)) cell.text += ", perturbed";
  return cell;
}

Cell margin_cell(const SpeedUp& one) {
  if (one.rival.empty()) return text_cell("");
  const double margin = rival_margin(one);
  if (!std::isfinite(margin)) return text_cell("unbounded");
  const Range range = margin_range(one);
  return quotient_cell(margin, range.low, range.high);
}

Cell miss_ratio_cell(const SpeedUp& one) {
  if (one.near_miss.empty()) return text_cell("");
  const Range range = ratio_range(one.time, one.near_miss[1]);
  return quotient_cell(one.miss_ratio, range.low, range.high);
}

Sheet speed_up_table(const Evaluation& evaluation, const std::vector<SpeedUp>& shown) {
  Sheet table{.name = "speed-up",
              .title = "Speed-up at equal error",
              .note =
                  "Reduced runs that no other reduced run beats in both error and time. The rival is the cheapest "
                  "full-order contender at least as exact. Quotients with the range that both parts allow: "
                  "error bars, spreads of times, and of perturbed ones what else had the core; single run: a time "
                  "behind it has none. Between rival and near miss, neighbours of "
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
