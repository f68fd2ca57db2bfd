// What times at equal error are made of, on both sides:
//
//   offline = assembly + preparation,   online = stepping + reconstruction
#include <map>

#include "reports/speedup_columns.h"
#include "reports/views.h"

namespace mb {
namespace {

// [s] whole - part, the spreads of both added: a difference of separate measurements may come out below its bar, or
// below zero. None where one was not measured.
std::optional<Record> rest(const std::optional<Record>& whole, const std::optional<Record>& part) {
  if (!whole || !part || !is_usable(*whole) || !is_usable(*part)) return std::nullopt;
  Record difference = *whole;
  difference.value = whole->value - part->value;
  if (part->error_bar) difference.error_bar = whole->error_bar.value_or(0) + *part->error_bar;
  return difference;
}

std::vector<Column> side_columns(const std::string& side) {
  std::vector<Column> columns;
  for (const char* phase : {"assembly", "preparation", "offline", "stepping", "reconstruction", "online"}) {
    columns.push_back({side + phase, "s", Column::Kind::time});
  }
  for (const char* count : {"steps", "solves", "factorisations"}) {
    columns.push_back({side + count, "", Column::Kind::number});
  }
  return columns;
}

// All empty where there is no run.
std::vector<Cell> side_cells(const Run* run) {
  if (!run) return std::vector<Cell>(side_columns("").size(), text_cell(""));
  const Run& of = *run;
  std::vector<Cell> cells;
  const auto add = [&](const std::optional<Record>& time) { cells.push_back(record_cell(time ? &*time : nullptr)); };
  for (const auto& time :
       {of.assembly, rest(of.offline, of.assembly), of.offline, of.stepping, rest(of.online, of.stepping), of.online}) {
    add(time);
  }
  const Work work = of.online ? of.online->work : Work{};
  // What is counted in closed form is modes times sample times; in contact it is the steps there.
  const bool takes_no_steps = of.contender.integrator == "exact" && !steps_in_contact(of.contender);
  cells.push_back(takes_no_steps ? text_cell("n/a") : count_cell(work.steps));
  for (const long n : {work.solves, work.factorisations}) cells.push_back(count_cell(n));
  return cells;
}

// By the headline's norm before others, against the best truth before others, then the most exact, then the cheapest.
bool tells_more(const Evaluation& evaluation, const SpeedUp& a, const SpeedUp& b) {
  const auto rank = [&](const SpeedUp& one) {
    const Run* run = run_of(evaluation, one.error);
    const bool best = run && one.error.truth == best_truth(*run, one.error.metric);
    return std::tuple(one.error.metric != headline_metric, !best, counted_error(one.error), one.time.value);
  };
  return rank(a) < rank(b);
}

// Those with a rival; of a case and profile without any the one that tells most.
std::vector<const SpeedUp*> with_phases(const Evaluation& evaluation, const std::vector<SpeedUp>& shown) {
  using Case = std::pair<std::string, std::string>;  // name, profile
  std::map<Case, const SpeedUp*> alone;              // nullptr: some run of the case has a rival
  for (const SpeedUp& one : shown) {
    const SpeedUp*& entry = alone.try_emplace({one.error.case_name, one.error.profile}, &one).first->second;
    if (!one.rival.empty()) entry = nullptr;
    if (entry && tells_more(evaluation, one, *entry)) entry = &one;
  }
  std::vector<const SpeedUp*> all;
  for (const SpeedUp& one : shown) {
    if (!one.rival.empty() || alone.at({one.error.case_name, one.error.profile}) == &one) all.push_back(&one);
  }
  return all;
}

// [description, phases] of the rival; where there is none the phases stay empty.
std::vector<Cell> rival_cells(const Evaluation& evaluation, const SpeedUp& one) {
  const bool none = one.rival.empty();
  const Theory theory = theory_of(evaluation, one.error.case_name, one.error.profile);
  std::vector<Cell> cells = {text_cell(none ? "none reached" : describe(one.rival[0].contender, theory))};
  append(cells, side_cells(none ? nullptr : run_of(evaluation, one.rival[0])));
  return cells;
}

}  // namespace

Sheet phases_table(const Evaluation& evaluation, const std::vector<SpeedUp>& shown) {
  Sheet table{
      .name = "phases",
      .title = "What the times are made of",
      .note =
          "Of every pair in the table of speed-ups; where no run of a case has a rival, its most exact reduced run "
          "alone, as no full-order contender reached its error. Assembly: mesh, matrices and loads; preparation, the "
          "rest of offline: factorisation, eigensolve, projection of the loads; stepping: the online time without "
          "reconstruction at the evaluation points, which is the rest of it. A rest is a difference of two "
          "measurements; below their spreads together it prints as <= that. Stepping is timed apart in cheap "
          "runs alone. Work is that of the run whose online time stands beside it; a closed form takes no steps, in "
          "scenes with contact those alone during which bodies touch.",
      .columns = speed_up_key_columns(),
      .rows = {}};
  for (const std::string side : {"", "rival "}) {
    if (!side.empty()) table.columns.push_back({"rival", ""});
    for (Column& column : side_columns(side)) table.columns.push_back(std::move(column));
  }
  for (const SpeedUp* one : with_phases(evaluation, shown)) {
    std::vector<Cell>& row = table.rows.emplace_back(speed_up_key_cells(*one));
    append(row, side_cells(run_of(evaluation, one->error)));
    append(row, rival_cells(evaluation, *one));
  }
  return table;
}

}  // namespace mb
