// One row a record: the table that everything else can be made of again.
#include "reports/contender_columns.h"
#include "reports/views.h"

namespace mb {

Sheet records_table(const Evaluation& evaluation) {
  constexpr Column::Kind number = Column::Kind::number;
  Sheet table{.name = "records", .title = "Records", .note = "", .columns = {}, .rows = {}};
  table.columns = {{"run", ""}, {"case", ""}, {"profile", ""}};
  for (Column& column : contender_columns()) table.columns.push_back(std::move(column));
  for (Column& column : std::vector<Column>{{"metric", ""},
                                            {"subject", ""},
                                            {"truth", ""},
                                            {"value", "", Column::Kind::error},
                                            {"unit", ""},
                                            {"steps", "", number},
                                            {"factorisations", "", number},
                                            {"solves", "", number}}) {
    table.columns.push_back(std::move(column));
  }
  for (const Record& record : evaluation.input.records) {
    std::vector<Cell> row = {text_cell(record.run), text_cell(record.case_name), text_cell(record.profile)};
    for (Cell& cell : contender_cells(record.contender, record.modes_used, record.n_unknowns)) {
      row.push_back(std::move(cell));
    }
    for (Cell& cell : std::vector<Cell>{text_cell(record.metric), text_cell(record.subject), text_cell(record.truth),
                                        record_cell(&record), text_cell(record.unit), count_cell(record.work.steps),
                                        count_cell(record.work.factorisations), count_cell(record.work.solves)}) {
      row.push_back(std::move(cell));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace mb
