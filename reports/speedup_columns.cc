#include "reports/speedup_columns.h"

#include "reports/runs.h"

namespace mb {

std::vector<Column> speed_up_key_columns() {
  constexpr Column::Kind number = Column::Kind::number;
  return {{"case", ""},   {"profile", ""},    {"truth", ""},     {"norm", ""},    {"body", ""},
          {"method", ""}, {"integrator", ""}, {"r", "", number}, {"steps of", ""}};
}

std::vector<Cell> speed_up_key_cells(const SpeedUp& one) {
  const Record& e = one.error;
  return {text_cell(e.case_name),
          text_cell(e.profile),
          text_cell(e.truth),
          text_cell(e.metric),
          text_cell(e.subject),
          text_cell(e.contender.method),
          text_cell(describe_integrator(e.contender)),
          takes_modes(e.contender) ? count_cell(e.contender.settings.modes) : text_cell(""),
          text_cell(describe_accuracy(e.contender))};
}

void append(std::vector<Cell>& row, std::vector<Cell> cells) {
  for (Cell& cell : cells) row.push_back(std::move(cell));
}

}  // namespace mb
