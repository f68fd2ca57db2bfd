// Where linear theory ends: what an impact's linear answer is worth as the impact grows.
#include <cmath>

#include "harness/analysis/amplitude_sweep.h"
#include "harness/analysis/analyses.h"
#include "harness/analysis/modal_body.h"
#include "harness/analysis/power_law.h"

namespace mb {

namespace {

const std::vector<double> factors{1.0 / 16, 1.0 / 8, 1.0 / 4, 1.0 / 2, 1, 2};  // [-] of the scene's speed
const double limits[] = {0.01, 0.05};                                          // [-]

Finding sweep_table() {
  return table(
      "amplitude", "amplitude", "Where linear theory ends: one impact at several speeds",
      "The first body thrown without gravity at multiples of the speed that it has in the scene, in full order "
      "on one mesh with linear and with finite kinematics, and in the study's most modes with static shapes. "
      "Errors are of the first body's deformation in its best rigid frames, relative over space and time, from "
      "a quarter of Hertz's duration before the touch to twice that past it. Strain and deformation are the "
      "largest of the finite answer: principal strain, and displacement of the surface over the body's extent. "
      "Force, impulse and duration of the first contact are the finite answer's. Full order is at a tenth of the "
      "truth's tolerance; `of steps`: what linear full order is off by at the truth's own, beside which an error means "
      "something. Bars: that, of modes with what steps twice as long move; of strain, deformation, force, impulse and "
      "duration what the truth's own tolerance moves in linear full order, of ratios twice: all of that mesh, whatever "
      "another has.",
      {{"speed", "m/s"},
       {"speed/scene's", "-"},
       {"status", ""},
       {"largest strain", "-"},
       {"largest deformation", "-"},
       {"error of linear", "-"},
       {"of steps", "-"},
       {"modal against linear", "-"},
       {"modal against finite", "-"},
       {"peak force", "N"},
       {"linear/finite peak force", "-"},
       {"impulse", "N s"},
       {"linear/finite impulse", "-"},
       {"duration", "s"},
       {"linear/finite duration", "-"}});
}

Finding limit_table() {
  return table(
      "amplitude", "amplitude-limits", "The speed up to which linear theory holds",
      "Where the error of linear theory passes the limit, on lines in logarithms between the speeds tried. Bars: "
      "the distance to the farther of the two.",
      {{"error of linear", "-"},
       {"passed", ""},
       {"speed", "m/s"},
       {"speed/scene's", "-"},
       {"largest strain", "-"},
       {"largest deformation", "-"}});
}

Finding exponent_table() {
  return table(
      "amplitude", "amplitude-exponents", "How the error of linear theory grows",
      "Exponent p of error ~ x^p by least squares in logarithms. What linear kinematics leave out is of second "
      "order in displacement gradients: relative to the first, of order one.",
      {{"grows with", ""}, {"speeds fitted", ""}, {"exponent", "-"}, {"standard error", "-"}, {"expected", "-"}});
}

using Rows = std::vector<AmplitudeRow>;

VectorXd values(const Rows& rows, double AmplitudeRow::*what) {
  VectorXd all(std::ssize(rows));
  for (Index i = 0; i < all.size(); ++i) all[i] = rows[static_cast<std::size_t>(i)].*what;
  return all;
}

void add_row(Finding& found, const AmplitudeRow& row) {
  const FirstImpact &l = row.linear, &f = row.finite;
  found.rows.push_back({row.speed, row.factor, row.status, row.strain, row.deformation, row.of_linear, row.of_steps,
                        row.modal_linear, row.modal_finite, f.peak, l.peak / f.peak, f.impulse, l.impulse / f.impulse,
                        f.duration, l.duration / f.duration});
  const double steps = row.of_steps, modal = steps + row.of_modal_steps;
  const auto moved = [&](double FirstImpact::*what) { return std::abs(row.loose.*what / (l.*what) - 1); };
  const double peak = moved(&FirstImpact::peak), impulse = moved(&FirstImpact::impulse),
               duration = moved(&FirstImpact::duration);
  bar_last_row(found, {{"largest strain", row.strain_moved * row.strain},
                       {"largest deformation", row.deformation_moved * row.deformation},
                       {"error of linear", steps},
                       {"modal against linear", modal},
                       {"modal against finite", modal},
                       {"peak force", peak * f.peak},
                       {"linear/finite peak force", 2 * peak * l.peak / f.peak},
                       {"impulse", impulse * std::abs(f.impulse)},
                       {"linear/finite impulse", 2 * impulse * std::abs(l.impulse / f.impulse)},
                       {"duration", duration * f.duration},
                       {"linear/finite duration", 2 * duration * l.duration / f.duration}});
}

void add_limit(Finding& found, const Rows& rows, double limit) {
  const VectorXd error = values(rows, &AmplitudeRow::of_linear);
  const auto where = [&](double AmplitudeRow::*x) { return where_passed(values(rows, x), error, limit); };
  const double speed = where(&AmplitudeRow::speed).at;
  if (!(error.array() >= 0).any() || speed == 0 || std::isinf(speed)) {
    const char* side = !(error.array() >= 0).any() ? "unknown" : speed == 0 ? "below all speeds" : "beyond all speeds";
    found.rows.push_back({limit, side, not_applicable(), not_applicable(), not_applicable(), not_applicable()});
    return;
  }
  const Passed factor = where(&AmplitudeRow::factor), strain = where(&AmplitudeRow::strain),
               deformation = where(&AmplitudeRow::deformation);
  found.rows.push_back({limit, "between them", speed, factor.at, strain.at, deformation.at});
  bar_last_row(found, {{"speed", where(&AmplitudeRow::speed).bar},
                       {"speed/scene's", factor.bar},
                       {"largest strain", strain.bar},
                       {"largest deformation", deformation.bar}});
}

void add_fit(Finding& found, const Rows& rows, const char* with, double AmplitudeRow::*x, double expected) {
  const PowerLaw law = power_law(values(rows, x), values(rows, &AmplitudeRow::of_linear));
  found.rows.push_back({with, count(law.n_points), law.exponent, law.standard_error, expected});
}

}  // namespace

std::vector<Finding> amplitude(const AnalysisContext& context) {
  Finding sweep = sweep_table(), passed = limit_table(), exponents = exponent_table();
  const Rows rows = amplitude_sweep(context, factors);
  for (const AmplitudeRow& row : rows) add_row(sweep, row);
  for (const double limit : limits) add_limit(passed, rows, limit);
  const double nan = std::get<double>(not_applicable());
  add_fit(exponents, rows, "speed", &AmplitudeRow::speed, nan);
  add_fit(exponents, rows, "largest strain", &AmplitudeRow::strain, 1);
  add_fit(exponents, rows, "largest deformation", &AmplitudeRow::deformation, 1);
  return {sweep, passed, exponents};
}

}  // namespace mb
