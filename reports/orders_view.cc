// Which runs make a curve, and the table of the orders seen along them.
#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "reports/number.h"
#include "reports/orders.h"

namespace mb {
namespace {

using Family = std::tuple<std::string, std::string, std::string, std::string>;  // case, profile, method, integrator
Family family(const Run& run) {
  return {run.case_name, run.profile, describe_method(run.contender), run.contender.integrator};
}

std::map<Family, double> finest_accuracy(const std::vector<Run>& runs) {
  std::map<Family, double> finest;
  for (const Run& run : runs) {
    const double own = accuracy(run.contender);
    const auto [entry, inserted] = finest.try_emplace(family(run), own);
    if (!inserted) entry->second = std::min(entry->second, own);
  }
  return finest;
}

double modes_of(const Run& run) { return run.modes_used >= 0 ? run.modes_used : run.contender.settings.modes; }

double h(const Run& run, Refinement refinement) {
  if (refinement == Refinement::modes) return modes_of(run) > 0 ? 1 / modes_of(run) : 0;
  return accuracy(run.contender);
}

using Basis = std::tuple<std::string, std::string, std::string, int>;  // case, profile, method, r
Basis basis(const Run& run) {
  return {run.case_name, run.profile, describe_method(run.contender), run.contender.settings.modes};
}

std::map<Basis, const Run*> in_closed_form(const std::vector<Run>& runs) {
  std::map<Basis, const Run*> found;
  for (const Run& run : runs) {
    if (run.contender.integrator == "exact" && !steps_in_contact(run.contender)) found.emplace(basis(run), &run);
  }
  return found;
}

// The same basis without time stepping: no smaller step goes below its error.
double floor_of(const Run& run, const Measure& measure, const std::map<Basis, const Run*>& closed_form) {
  const auto exact = closed_form.find(basis(run));
  if (exact == closed_form.end() || run.contender.method == "full-order") return 0;
  const auto entry = exact->second->measures.find(measure);
  return entry != exact->second->measures.end() && is_usable(entry->second) ? std::abs(entry->second.value) : 0;
}

Curve fitted(Curve curve, const std::map<Basis, const Run*>& closed_form) {
  std::stable_sort(curve.runs.begin(), curve.runs.end(), [&](const Run* a, const Run* b) {
    return h(*a, curve.refinement) > h(*b, curve.refinement);  // h = 0 (no elastic mode at all) goes last
  });
  curve.contender = curve.runs.back()->contender;
  std::vector<OrderPoint> points;
  for (const Run* run : curve.runs) {
    const Record& record = run->measures.at(curve.measure);
    const double value = is_usable(record) ? std::abs(record.value) : std::nan("");
    double hidden = record.error_bar.value_or(0);
    if (curve.refinement != Refinement::modes) hidden = std::max(hidden, floor_of(*run, curve.measure, closed_form));
    points.push_back({h(*run, curve.refinement), value, hidden});
  }
  curve.observed = fit_order(std::move(points));
  return curve;
}

// Everything but what is varied.
std::string fixed(const Run& run, Refinement refinement) {
  return refinement == Refinement::modes ? describe_accuracy(run.contender)
                                         : describe_size(run.contender) + to_string(run.contender.resolution);
}

struct Varied {
  const char *name, *unit;
};
Varied varied(Refinement refinement) {
  switch (refinement) {
    case Refinement::modes:
      return {"r", ""};
    case Refinement::step:
      return {"time step", "s"};
    case Refinement::tolerance:
      return {"tolerance", ""};
  }
  return {"", ""};
}

// As it was chosen: r, not 1/r.
Cell range_cell(const Curve& curve, double value) {
  if (!std::isfinite(value)) return text_cell("");
  if (curve.refinement == Refinement::modes) return count_cell(std::lround(1 / value));
  return setting_cell(value);
}

std::vector<Cell> row(const Curve& curve) {
  const ObservedOrder& o = curve.observed;
  const Contender& c = curve.contender;
  const bool none = std::isnan(o.order);
  const std::string size =
      curve.refinement == Refinement::modes ? describe_accuracy(c) : describe_size(c, curve.theory);
  return {text_cell(curve.case_name),
          text_cell(curve.profile),
          text_cell(curve.measure.truth),
          text_cell(curve.measure.subject),
          text_cell(curve.measure.metric),
          text_cell(varied(curve.refinement).name),
          text_cell(describe_method(c)),
          text_cell(describe_integrator(c)),
          text_cell(size),
          none ? text_cell("none") : Cell{.text = format_number(o.order), .value = o.order},
          none ? text_cell("") : Cell{.text = format_number(o.standard_error, 2), .value = o.standard_error},
          count_cell(o.n_points),
          count_cell(o.n_left_out),
          range_cell(curve, o.coarsest),
          range_cell(curve, o.finest),
          text_cell(o.why_none)};
}

}  // namespace

std::vector<Curve> curves(const Evaluation& evaluation) {
  using Key = std::tuple<Family, Refinement, std::string, Measure>;
  std::map<Key, Curve> found;
  const auto finest = finest_accuracy(evaluation.runs);
  const auto closed_form = in_closed_form(evaluation.runs);
  for (const Run& run : evaluation.runs) {
    const Contender& c = run.contender;
    std::vector<Refinement> refinements;
    if (takes_modes(c) && accuracy(c) <= finest.at(family(run))) refinements.push_back(Refinement::modes);
    if (c.settings.time_step > 0) refinements.push_back(Refinement::step);
    if (takes_tolerance(c)) refinements.push_back(Refinement::tolerance);
    for (const auto& [measure, record] : run.measures) {
      if (!is_norm(measure.metric)) continue;
      for (const Refinement one : refinements) {
        Curve& curve = found[Key{family(run), one, fixed(run, one), measure}];
        curve.case_name = run.case_name;
        curve.profile = run.profile;
        curve.theory = theory_of(evaluation, run.case_name, run.profile);
        curve.measure = measure;
        curve.refinement = one;
        curve.runs.push_back(&run);
      }
    }
  }
  std::vector<Curve> all;
  for (auto& [key, curve] : found) {
    if (curve.runs.size() >= 3) all.push_back(fitted(std::move(curve), closed_form));
  }
  return all;
}

Sheet orders_table(const std::vector<Curve>& all) {
  using Kind = Column::Kind;
  Sheet table{
      .name = "orders",
      .title = "Observed orders",
      .note =
          "error ~ r^-p, step^p or tolerance^p: least squares in log-log with the standard error of p. Points "
          "are left out above 0.5 (nothing is resolved), within 5 truth bars, within 5 times the error of the "
          "same basis in closed form, and where the curve has flattened: from the fine end, every point whose "
          "last step gains less than half the slope before it, then points within 3 times the least error "
          "so dropped. None: fewer than three points remain, or the error does not fall over them, as something else "
          "rules it.",
      .columns = {},
      .rows = {}};
  table.columns = {{"case", ""},
                   {"profile", ""},
                   {"truth", ""},
                   {"body", ""},
                   {"norm", ""},
                   {"in", ""},
                   {"method", ""},
                   {"integrator", ""},
                   {"at", ""},
                   {"order", "-", Kind::number},
                   {"standard error", "-", Kind::number},
                   {"points", "", Kind::number},
                   {"left out", "", Kind::number},
                   {"coarsest", "", Kind::number},
                   {"finest", "", Kind::number},
                   {"why none", ""}};
  for (const Curve& curve : all) table.rows.push_back(row(curve));
  return table;
}

std::vector<Drawn> drawn(const std::vector<Run>& runs) {
  const auto finest = finest_accuracy(runs);
  std::map<std::pair<Family, int>, double> largest;  // of r, or of unknowns on any mesh of a degree
  const auto key = [](const Run& run) {
    return std::pair(family(run), is_reduced(run.contender) ? 0 : run.contender.resolution.degree);
  };
  const auto size = [](const Run& run) {
    return is_reduced(run.contender) ? modes_of(run) : static_cast<double>(run.n_unknowns);
  };
  for (const Run& run : runs) {
    double& entry = largest[key(run)];
    entry = std::max(entry, size(run));
  }
  std::vector<Drawn> all;
  for (const Run& run : runs) {
    all.push_back({accuracy(run.contender) <= finest.at(family(run)), size(run) >= largest.at(key(run))});
  }
  return all;
}

}  // namespace mb
