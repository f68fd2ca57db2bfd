// What times at equal error are made of, on both sides:
//
//   offline = assembly + preparation,   online = stepping + reconstruction
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

std::vector<Cell> side_cells(const Run* run) {
  std::vector<Cell> cells;
  const auto add = [&](const std::optional<Record>& time) { cells.push_back(record_cell(time ? &*time : nullptr)); };
  const Run none{};
  const Run& of = run ? *run : none;
  for (const auto& time :
       {of.assembly, rest(of.offline, of.assembly), of.offline, of.stepping, rest(of.online, of.stepping), of.online}) {
    add(time);
  }
  const Work work = of.online ? of.online->work : Work{};
  const bool takes_no_steps = of.contender.integrator == "exact";  // what is counted is modes times sample times
  cells.push_back(takes_no_steps ? text_cell("n/a") : count_cell(work.steps));
  for (const long n : {work.solves, work.factorisations}) cells.push_back(count_cell(n));
  return cells;
}

}  // namespace

Sheet phases_table(const Evaluation& evaluation, const std::vector<SpeedUp>& shown) {
  Sheet table{
      .name = "phases",
      .title = "What the times are made of",
      .note =
          "Of every pair in the table of speed-ups. Assembly: mesh, matrices and loads; preparation, the rest "
          "of offline: factorisation, eigensolve, projection of the loads; stepping: the online time without "
          "reconstruction at the evaluation points, which is the rest of it. A rest is a difference of two "
          "measurements; below their spreads together it prints as <= that. Stepping is timed apart in cheap "
          "runs alone. Work is that of the run whose online time stands beside it; a closed form takes no steps.",
      .columns = speed_up_key_columns(),
      .rows = {}};
  for (const std::string side : {"", "rival "}) {
    if (!side.empty()) table.columns.push_back({"rival", ""});
    for (Column& column : side_columns(side)) table.columns.push_back(std::move(column));
  }
  for (const SpeedUp& one : shown) {
    if (one.rival.empty()) continue;
    std::vector<Cell>& row = table.rows.emplace_back(speed_up_key_cells(one));
    append(row, side_cells(run_of(evaluation, one.error)));
    append(row, {text_cell(describe(one.rival[0].contender))});
    append(row, side_cells(run_of(evaluation, one.rival[0])));
  }
  return table;
}

}  // namespace mb
