#include "reports/contender_columns.h"

#include "reports/runs.h"

namespace mb {

std::vector<Column> contender_columns() {
  constexpr Column::Kind number = Column::Kind::number;
  return {{"method", ""},         {"integrator", ""},         {"mesh", ""},          {"r", "", number},
          {"r used", "", number}, {"time step", "s", number}, {"rtol", "-", number}, {"unknowns", "", number}};
}

std::vector<Cell> contender_cells(const Contender& contender, int modes_used, long n_unknowns, Theory theory) {
  const Settings& settings = contender.settings;
  return {text_cell(describe_method(contender)),
          text_cell(describe_integrator(contender)),
          text_cell(describe_mesh(contender.resolution, theory)),
          takes_modes(contender) ? count_cell(settings.modes) : text_cell(""),
          is_reduced(contender) && modes_used >= 0 ? count_cell(modes_used) : text_cell(""),
          settings.time_step > 0 ? setting_cell(settings.time_step) : text_cell(""),
          takes_tolerance(contender) ? setting_cell(settings.relative_tolerance) : text_cell(""),
          n_unknowns > 0 ? count_cell(n_unknowns) : text_cell("")};
}

}  // namespace mb
