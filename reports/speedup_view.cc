// Tables about what was won and what went wrong.
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

}  // namespace

Cell ratio_cell(const SpeedUp& one) {
  if (one.rival.empty()) return text_cell("none reached");
  const std::string high = std::isfinite(one.ratio_high) ? format_number(one.ratio_high) : "unbounded";
  std::string text = format_number(one.ratio) + " (" + format_number(one.ratio_low) + " to " + high + ")";
  if (one.ratio_low <= 1 && one.ratio_high >= 1) text += ", within noise";
  return {.text = text, .value = one.ratio};
}

Sheet speed_up_table(const Analysis& analysis) {
  Sheet table{.name = "speed-up",
              .title = "Speed-up at equal displacement error",
              .note = "Ratio with the range that the spreads of both times allow; break-even in simulated seconds.",
              .columns = {},
              .rows = {}};
  table.columns = {{"case", ""},
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
                   {"rival online", "s", Kind::time},
                   {"rival offline", "s", Kind::time},
                   {"speed-up", "-", Kind::number},
                   {"break-even", "s", Kind::number}};
  for (const SpeedUp& one : analysis.speed_ups) {
    const Run* run = run_of(analysis, one.error);
    const Contender& contender = one.error.contender;
    std::vector<Cell> row = {
        text_cell(one.error.case_name), text_cell(one.error.profile), text_cell(one.error.truth),
        text_cell(one.error.subject),   text_cell(contender.method),  count_cell(contender.settings.modes),
        record_cell(&one.error),        record_cell(&one.time),       record_cell(offline_of(run))};
    if (one.rival.empty()) {
      for (Cell& cell : std::vector<Cell>{text_cell("none reached"), text_cell(""), text_cell(""), text_cell(""),
                                          ratio_cell(one), text_cell("")}) {
        row.push_back(std::move(cell));
      }
    } else {
      const Run* rival = run_of(analysis, one.rival[0]);
      row.push_back(text_cell(describe(one.rival[0].contender)));
      row.push_back(record_cell(&one.rival[0]));
      row.push_back(record_cell(&one.rival[1]));
      row.push_back(record_cell(offline_of(rival)));
      row.push_back(ratio_cell(one));
      row.push_back(break_even_cell(analysis, one, run, rival));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

Sheet failures_table(const Analysis& analysis) {
  Sheet table{.name = "failures", .title = "Failures", .note = "", .columns = {}, .rows = {}};
  table.columns = {{"case", ""}, {"profile", ""}, {"truth", ""}, {"contender", ""}, {"metric", ""}, {"status", ""}};
  for (const Record& record : analysis.input.records) {
    if (is_usable(record)) continue;
    table.rows.push_back({text_cell(record.case_name), text_cell(record.profile), text_cell(record.truth),
                          text_cell(describe(record.contender)), text_cell(record.metric),
                          text_cell(record.status == "ok" ? "not_finite" : record.status)});
  }
  return table;
}

Sheet records_table(const Analysis& analysis) {
  Sheet table{.name = "records", .title = "Records", .note = "", .columns = {}, .rows = {}};
  table.columns = {{"run", ""},
                   {"case", ""},
                   {"profile", ""},
                   {"method", ""},
                   {"integrator", ""},
                   {"mesh", ""},
                   {"r", "", Kind::number},
                   {"r used", "", Kind::number},
                   {"time step", "s", Kind::number},
                   {"rtol", "-", Kind::number},
                   {"unknowns", "", Kind::number},
                   {"metric", ""},
                   {"subject", ""},
                   {"truth", ""},
                   {"value", "", Kind::error},
                   {"unit", ""},
                   {"steps", "", Kind::number},
                   {"factorisations", "", Kind::number},
                   {"solves", "", Kind::number}};
  for (const Record& record : analysis.input.records) {
    const Contender& contender = record.contender;
    table.rows.push_back({text_cell(record.run), text_cell(record.case_name), text_cell(record.profile),
                          text_cell(contender.method), text_cell(contender.integrator),
                          text_cell(to_string(contender.resolution)), count_cell(contender.settings.modes),
                          count_cell(record.modes_used), setting_cell(contender.settings.time_step),
                          setting_cell(contender.settings.relative_tolerance), count_cell(record.n_unknowns),
                          text_cell(record.metric), text_cell(record.subject), text_cell(record.truth),
                          record_cell(&record), text_cell(record.unit), count_cell(record.work.steps),
                          count_cell(record.work.factorisations), count_cell(record.work.solves)});
  }
  return table;
}

}  // namespace mb
