#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "harness/analysis/analyses.h"
#include "harness/analysis/limit_subjects.h"
#include "harness/analysis/modal_body.h"
#include "harness/analysis/power_law.h"
#include "mechanics/system/stepped_modes.h"
#include "modal/bases/mesh_radius.h"
#include "modal/methods/projection.h"

namespace mb {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Finding limits_table() {
  return table(
      "step-limits", "step-limits", "Largest stable time steps, by formula and measured",
      "Measured: bisection of the spectral radius of the one-step amplification of every mode kept, to 1e-9 and, of "
      "ratios zeta above 300, to 3e-12 zeta; the limit is the least over the modes. Formula: theory mode by mode, "
      "likewise the least. Damping ratios are those of the system's damping operator. Where single damping ratios "
      "are of other modes than those stepped, as of a lumped mass, that of the mesh itself, without a formula: the "
      "step at which 4 M + 2 s h C - h^2 K is singular, "
      "s = -1, 0, 1 for damping by the old, the mean, the new rate; none of explicit Euler. Full order otherwise: the "
      "highest mode of the mesh and the lowest ones that were solved for, with the consistent and with the lumped "
      "mass. Integrator: that which steps the system so. A limit of 0 means that every step is unstable. Over full "
      "order: the limit over that of the mesh with its consistent mass. Rigid modes drift as they should and set no "
      "limit. Bars: of reduced systems, twice the distance to what the same modes of the finer mesh of the case set, "
      "and rounding; limits of full order are the mesh's own.",
      {{"system", ""},
       {"modes r", ""},
       {"scheme", ""},
       {"integrator", ""},
       {"omega max", "rad/s"},
       {"zeta", "-"},
       {"formula", ""},
       {"dt formula", "s"},
       {"dt measured", "s"},
       {"measured / formula", "-"},
       {"omega deciding", "rad/s"},
       {"over full order", "-"}});
}

Finding runs_table() {
  return table(
      "step-limits", "step-limit-runs", "Step limits borne out by runs",
      "Runs of the catalogue's integrators from the deciding mode at 0.99 and 1.01 of the measured limit; "
      "where the limit is 0, at a hundredth of 1/omega; at 1.01 alone of the mesh itself. Theory: rho^n, rho "
      "the spectral radius. Observed: "
      "growth of the run's share in the eigenvector of the larger eigenvalue over the same n steps. Difference: "
      "of the logarithms of both, over that of theory or 1e-6, whichever is larger. A run confirms where it is "
      "within 1 %; it is too short to tell where the logarithm by theory is below 1e-8 and the mode turns by "
      "less than a radian. Steps are as many as growth or decay by 3 takes, within bounds of work: near its limit "
      "explicit Euler grows slowly. Bars: rounding of n steps; of the mesh itself also what other modes leave.",
      {{"system", ""},
       {"modes r", ""},
       {"scheme", ""},
       {"integrator", ""},
       {"dt / limit", "-"},
       {"dt", "s"},
       {"steps", ""},
       {"growth by theory", "-"},
       {"growth observed", "-"},
       {"difference of logarithms", "-"},
       {"verdict", ""}});
}

Finding summary_table() {
  return table(
      "step-limits", "step-limit-summary", "How many of these runs do what the amplification says",
      "Runs at 0.99 and 1.01 of the limit by what became of them, those of a reduced system at each mode count; the "
      "last row is of all. With the consistent mass and with the lumped one it is the mesh itself that is stepped, of "
      "whatever size, made linear where its kinematics are finite.",
      {{"system and scheme", ""}, {"runs", ""}, {"confirmed", ""}, {"not confirmed", ""}, {"too short to tell", ""}});
}

Finding summary_of(const Finding& runs) {
  Finding summary = summary_table();
  const auto add = [&](const FindingCell& stepped, const std::string& verdict) {
    auto sum = std::ranges::find(summary.rows, stepped, [](const auto& row) { return row.front(); });
    if (sum == summary.rows.end()) sum = summary.rows.insert(sum, {stepped, 0., 0., 0., 0.});
    const auto column = std::ranges::find(summary.columns, verdict, &FindingColumn::name);
    for (const auto j : {Index{1}, column - summary.columns.begin()})
      sum->at(static_cast<size_t>(j)) = std::get<double>(sum->at(static_cast<size_t>(j))) + 1;
  };
  for (const std::vector<FindingCell>& run : runs.rows)
    add(std::get<std::string>(run[0]) + ": " + std::get<std::string>(run[2]), std::get<std::string>(run.back()));
  for (const std::vector<FindingCell>& run : runs.rows) add("all", std::get<std::string>(run.back()));
  return summary;
}

Finding exponents_table() {
  return table("step-limits", "step-limit-exponents",
               "Claim C6: is the largest step inversely proportional to the "
               "highest frequency kept?",
               "Exponent p of dt ~ omega^p by least squares in logarithms over the mode counts, beside the -1 which is "
               "claimed. It agrees where it is within 0.05, or two standard errors, of that.",
               {{"claim", ""},
                {"scheme", ""},
                {"limits fitted", ""},
                {"exponent", "-"},
                {"standard error", "-"},
                {"claimed", "-"},
                {"verdict", ""}});
}

const Integrator* find_integrator(const AnalysisContext& context, const std::string& name) {
  for (const Integrator& integrator : context.catalogue.integrators)
    if (integrator.name == name) return &integrator;
  return nullptr;
}

// whole: the limit of the mesh
std::vector<FindingCell> limit_row(const LimitSubject& s, const Scheme& scheme, const SubjectLimit& limit,
                                   double whole) {
  const Index last = s.omega.size() - 1;
  const double ratio = limit.formula > 0 && std::isfinite(limit.formula) ? limit.dt / limit.formula : nan;
  return {s.name,        s.r,          scheme.name,         steps_as(scheme, s.system) ? scheme.integrator : "none",
          s.omega(last), s.zeta(last), scheme.formula_text, limit.formula,
          limit.dt,      ratio,        limit.omega,         whole > 0 && std::isfinite(whole) ? limit.dt / whole : nan};
}

double limit_of_mode(const Scheme& scheme, double omega, double zeta) {
  return measured_limit(scheme, VectorXd::Constant(1, omega), VectorXd::Constant(1, zeta)).dt;
}

// [-] Bars of the frequency of mode i and of what it limits the step to, relative; unknown where the other mesh has no
// such mode, of full order those of its own mesh alone. Limits go with 1/omega at one damping ratio, with 1/omega^2 at
// most where that falls with 1/omega.
struct RelativeBars {
  double frequency = infinity, limit = infinity;
  double zeta = infinity;  // [-] of the damping ratio, as it is
};
RelativeBars relative_bars(const Scheme& scheme, const LimitSubject& s, Index i) {
  if (std::isnan(s.r)) return {nan, 0, nan};
  if (i >= s.omega_beside.size()) return {};
  const double limit = limit_of_mode(scheme, s.omega(i), s.zeta(i));
  const double beside = limit_of_mode(scheme, s.omega_beside(i), s.zeta_beside(i));
  return {s.bar_per_distance * std::abs(s.omega_beside(i) / s.omega(i) - 1) + s.rounding(i),
          s.bar_per_distance * std::abs(beside / limit - 1) + 2 * s.rounding(i),
          s.bar_per_distance * std::abs(s.zeta_beside(i) - s.zeta(i)) + s.rounding(i) * s.zeta(i)};
}

void bar_limits(Finding& limits, const Scheme& scheme, const LimitSubject& s, const SubjectLimit& limit) {
  const Index last = s.omega.size() - 1;
  const auto top = relative_bars(scheme, s, last), deciding = relative_bars(scheme, s, limit.deciding);
  const auto cell = [&](const char* name) {
    const auto column = std::ranges::find(limits.columns, name, &FindingColumn::name) - limits.columns.begin();
    return std::get<double>(limits.rows.back().at(static_cast<size_t>(column)));
  };
  std::vector<std::pair<const char*, double>> bars{{"omega max", top.frequency * s.omega(last)},
                                                   {"zeta", top.zeta},
                                                   {"omega deciding", deciding.frequency * s.omega(limit.deciding)}};
  const double of_search = bar_of_limit(s.coupled ? 0 : s.zeta(limit.deciding));
  const auto add = [&](const char* name, double bar) {
    if (std::isfinite(cell(name)) && cell(name) > 0) bars.emplace_back(name, bar * cell(name));
  };
  add("dt formula", deciding.limit);
  add("dt measured", deciding.limit + of_search);
  add("measured / formula", of_search);
  add("over full order", deciding.limit + 2 * of_search);
  bar_last_row(limits, bars);
}

void add_runs(Finding& runs, const LimitSubject& s, const Scheme& scheme, const Integrator& integrator,
              const SubjectLimit& limit) {
  if (!limit.mode || !std::isfinite(limit.dt)) return;
  const std::vector<double> factors = limit.dt <= 0 ? std::vector{std::numeric_limits<double>::infinity()}
                                      : s.coupled   ? std::vector{1.01}
                                                    : std::vector{0.99, 1.01};
  for (const double factor : factors) {
    const double dt = limit.dt > 0 ? factor * limit.dt : 0.01 / limit.mode->omega;
    const GrowthRun run =
        s.coupled ? growth_run(s.system, *limit.mode, integrator, dt, mesh_radius(s.system, integrator.name, dt))
                  : growth_run(s.system, *limit.mode, scheme, integrator, dt, s.most_steps);
    runs.rows.push_back({s.name, s.r, scheme.name, integrator.name, factor, dt, static_cast<double>(run.n_steps),
                         run.theory, run.observed, difference_of_logarithms(run), growth_verdict(run)});
    bar_last_row(runs, {{"growth observed", bar_of_growth(run) * run.observed},
                        {"difference of logarithms", bar_of_difference(run)}});
  }
}

std::vector<FindingCell> exponent_row(const std::string& scheme, const std::vector<double>& omega,
                                      const std::vector<double>& dt) {
  const auto n = static_cast<Index>(omega.size());
  const PowerLaw law = power_law(Eigen::Map<const VectorXd>(omega.data(), n), Eigen::Map<const VectorXd>(dt.data(), n));
  std::string verdict =
      agrees(law, -1) ? "holds"
                      : fmt::format("does not hold: dt ~ omega^{:.2f}", std::round(100 * law.exponent) / 100 + 0.0);
  if (std::isnan(law.exponent)) verdict = "not decided: too few mode counts";
  if (n > 0 && *std::max_element(dt.begin(), dt.end()) == 0) verdict = "does not hold: no step is stable";
  return {"C6", scheme, count(law.n_points), law.exponent, law.standard_error, -1.0, verdict};
}

void expect_modes_apart(const ModalBody& body) {
  if (stepped_modes(project(body.system, body.modes)).coupled.K.size() > 0)
    throw std::invalid_argument(
        "step-limits are those of modes one by one, and damping couples these: stability-map tells of all together");
}

}  // namespace

std::vector<Finding> step_limits(const AnalysisContext& context) {
  const std::vector<int> counts = mode_counts(context);
  const Beside other = beside(context, counts.back());
  const ModalBody body = modal_body(context, counts.back());  // last: the context has one model at a time
  expect_modes_apart(body);
  std::vector<LimitSubject> subjects;
  for (const int r : counts) {
    subjects.push_back(reduced_subject(body, r, other));
    const size_t n = subjects.size();
    if (n > 1 && subjects[n - 1].r == subjects[n - 2].r) subjects.pop_back();  // one multiplet, or no more modes
  }
  const std::vector<LimitSubject> full = full_subjects(body);
  subjects.insert(subjects.end(), full.begin(), full.end());
  Finding limits = limits_table(), runs = runs_table(), exponents = exponents_table();
  for (const Scheme& scheme : explicit_schemes()) {
    std::vector<double> omega, dt;
    const double whole = limit_of(full.front(), scheme).dt;
    for (const LimitSubject& subject : subjects) {
      const SubjectLimit limit = limit_of(subject, scheme);
      limits.rows.push_back(limit_row(subject, scheme, limit, whole));
      bar_limits(limits, scheme, subject, limit);
      const Integrator* integrator = find_integrator(context, scheme.integrator);
      if (integrator && steps_as(scheme, subject.system)) add_runs(runs, subject, scheme, *integrator, limit);
      if (std::isnan(subject.r)) continue;
      omega.push_back(subject.omega(subject.omega.size() - 1));
      dt.push_back(limit.dt);
    }
    exponents.rows.push_back(exponent_row(scheme.name, omega, dt));
  }
  return {limits, runs, summary_of(runs), exponents};
}

}  // namespace mb
