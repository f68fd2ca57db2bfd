// The table of what was won.
#include <cmath>

#include "reports/number.h"
#include "reports/speedup.h"
#include "reports/views.h"

namespace mb {
namespace {

using Kind = Column::Kind;

const Record* offline_of(const Run* run) { return run && run->offline ? &*run->offline : nullptr; }

Cell break_even_cell(const Analysis& analysis, const SpeedUp& one, const Run* reduced, const Run* rival) {
  const Record* offline = offline_of(reduced);
  const Record* rival_offline = offline_of(rival);
  if (!offline || !rival_offline || !is_usable(*offline) || !is_usable(*rival_offline)) return text_cell("unknown");
  const std::optional<double> duration = simulated_seconds(analysis, *reduced);
  if (!duration) return text_cell("unknown");
  const auto seconds =
      break_even(offline->value, one.time.value / *duration, rival_offline->value, one.rival[1].value / *duration);
  return seconds ? number_cell(seconds) : text_cell("never");
}

std::vector<Cell> own_cells(const SpeedUp& one, const Run* run) {
  const Contender& contender = one.error.contender;
  return {text_cell(one.error.case_name), text_cell(one.error.profile), text_cell(one.error.truth),
          text_cell(one.error.subject),   text_cell(contender.method),  count_cell(contender.settings.modes),
          record_cell(&one.error),        record_cell(&one.time),       record_cell(offline_of(run))};
}

std::vector<Cell> rival_cells(const Analysis& analysis, const SpeedUp& one, const Run* run) {
  if (one.rival.empty()) {
    return {text_cell("none reached"), text_cell(""), text_cell(""), text_cell(""), text_cell(""),
            ratio_cell(one),           text_cell("")};
  }
  const Run* rival = run_of(analysis, one.rival[0]);
  return {text_cell(describe(one.rival[0].contender)),
          record_cell(&one.rival[0]),
          margin_cell(one),
          record_cell(&one.rival[1]),
          record_cell(offline_of(rival)),
          ratio_cell(one),
          break_even_cell(analysis, one, run, rival)};
}

std::vector<Cell> near_miss_cells(const SpeedUp& one) {
  if (one.near_miss.empty()) return {text_cell(""), text_cell(""), text_cell("")};
  return {text_cell(describe(one.near_miss[0].contender)), record_cell(&one.near_miss[0]), miss_ratio_cell(one)};
}

std::vector<Column> speed_up_columns() {
  return {{"case", ""},
          {"profile", ""},
          {"truth", ""},
          {"body", ""},
          {"method", ""},
          {"r", "", Kind::number},
          {headline_metric, "-", Kind::error},
          {"online time", "s", Kind::time},
          {"offline time", "s", Kind::time},
          {"rival", ""},
          {"rival error", "-", Kind::error},
          {"margin", "-", Kind::number},
          {"rival online", "s", Kind::time},
          {"rival offline", "s", Kind::time},
          {"speed-up", "-", Kind::number},
          {"break-even", "s", Kind::number},
          {"near miss", ""},
          {"miss error", "-", Kind::error},
          {"miss speed-up", "-", Kind::number}};
}

}  // namespace

Cell ratio_cell(const SpeedUp& one) {
  if (one.rival.empty()) return text_cell("none reached");
  const std::string ratio = format_number(one.ratio);
  if (std::isnan(one.ratio_low)) return {.text = ratio + " (single run)", .value = one.ratio};
  const std::string high = std::isfinite(one.ratio_high) ? format_number(one.ratio_high) : "unbounded";
  std::string text = ratio + " (" + format_number(one.ratio_low) + " to " + high + ")";
  if (one.ratio_low <= 1 && one.ratio_high >= 1) text += ", within noise";
  return {.text = text, .value = one.ratio};
}

Cell margin_cell(const SpeedUp& one) {
  if (one.rival.empty()) return text_cell("");
  const double margin = rival_margin(one);
  return std::isfinite(margin) ? number_cell(margin) : text_cell("unbounded");
}

Cell miss_ratio_cell(const SpeedUp& one) { return one.near_miss.empty() ? text_cell("") : number_cell(one.miss_ratio); }

Sheet speed_up_table(const Analysis& analysis) {
  Sheet table{.name = "speed-up",
              .title = "Speed-up at equal displacement error",
              .note =
                  "Ratio with the range that the spreads of both times allow, and the ratio over the near miss: "
                  "at exactly equal error "
                  "it lies between the two. Break-even in simulated seconds.",
              .columns = speed_up_columns(),
              .rows = {}};
  for (const SpeedUp& one : analysis.speed_ups) {
    const Run* run = run_of(analysis, one.error);
    std::vector<Cell>& row = table.rows.emplace_back(own_cells(one, run));
    for (Cell& cell : rival_cells(analysis, one, run)) row.push_back(std::move(cell));
    for (Cell& cell : near_miss_cells(one)) row.push_back(std::move(cell));
  }
  return table;
}

}  // namespace mb
