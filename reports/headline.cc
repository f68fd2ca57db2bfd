// The table behind the headline: a case, its pair within the error target.
#include <cmath>

#include "reports/number.h"
#include "reports/speedup.h"
#include "reports/verdict.h"
#include "reports/words.h"

namespace mb {
namespace {

std::vector<Cell> row(double target, const SpeedUp& one) {
  const bool none = one.rival.empty();
  std::vector<std::string> limits = limits_of(one);
  if (is_within_noise(one)) limits.insert(limits.begin(), "within noise");
  return {text_cell(one.error.case_name),
          text_cell(one.error.profile),
          text_cell(percent(target)),
          text_cell(describe(one.error.contender)),
          record_cell(&one.error),
          text_cell(none ? "none within the target" : describe(one.rival[0].contender)),
          none ? text_cell("") : record_cell(&one.rival[0]),
          none ? text_cell("") : number_cell(one.ratio),
          text_cell(range_text(one)),
          miss_ratio_cell(one),
          text_cell(joined(limits, "; "))};
}

}  // namespace

Sheet headline_table(const Evaluation& evaluation) {
  using Kind = Column::Kind;
  Sheet table{.name = "speed-up-at-target",
              .title = "Speed-up at a target of displacement error",
              .note =
                  "Of every case the cheapest reduced and the cheapest full-order run whose displacement error "
                  "against exact, or finer where no closed form is known, is at most the target, error bar included. "
                  "Miss speed-up: of the dearest full-order run that is cheaper, which is outside the target or "
                  "may be. Cases of beam or plate theory are left out: their full-order runs are half waves, modes "
                  "too, and no finite elements. Equal errors are compared in the table of speed-ups at equal error.",
              .columns = {{"case", ""},
                          {"profile", ""},
                          {"target", ""},
                          {"reduced run", ""},
                          {"error", "-", Kind::error},
                          {"full-order run", ""},
                          {"full-order error", "-", Kind::error},
                          {"speed-up", "-", Kind::number},
                          {"range", ""},
                          {"miss speed-up", "-", Kind::quotient},
                          {"limits", ""}},
              .rows = {},
              .n_keys = 0};
  for (const double target : {error_target, looser_target}) {
    for (const SpeedUp& one : at_target(evaluation, headline_metric, target)) table.rows.push_back(row(target, one));
  }
  return table;
}

}  // namespace mb
