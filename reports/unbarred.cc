#include "reports/unbarred.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "reports/runs.h"
#include "reports/words.h"

namespace mb {

namespace {

constexpr const char* stated = "stated by the case or the study, or a multiple of that";
constexpr const char* chosen = "chosen, by this mesh's frequencies or the contact's duration; exact as it was run";
constexpr const char* itself = "is an uncertainty itself";
constexpr const char* clocked = "measured on one machine at one time; its table says how often";
constexpr const char* theory =
    "theory on the matrices that are stepped, as the cells beside it: rounding, and where a limit is searched for 1e-9 "
    "of it, 3e-12 zeta where that is more, 1e-3 for kicks in contact; of a finer mesh's limits see step-limits";
constexpr const char* counted = "counted, which repeats";
constexpr const char* missed = "of steps that miss a touch which a motion a third as large has, or the other way round";
constexpr const char* unstepped = "known to no bar: steps twice as long are past their limit, or miss this contact";
constexpr const char* nothing = "of an answer of nothing, or of none of it: off by all of whatever truth";
constexpr const char* unpaired = "unknown, and said to be: of a mode like which none of the finer mesh moves";
constexpr const char* flown =
    "of a body that flies to its first touch, which is known to rounding; or of steps that miss this contact";
constexpr const char* on_steps =
    "of a first touch after a flight, known to rounding; of a later one that begins and ends with a step, to a step";
constexpr const char* on_line = "of numbers that lie on the line to rounding, whose standard error is 0";
constexpr const char* met = "asked of this very mode, and met to rounding";
constexpr const char* fitted = "of this mesh's modes on the same samples; rounding times the condition beside it";
constexpr const char* conserved =
    "an error itself, of 0 that exact motion keeps, by this mesh and these steps; after impacts other rounding changes "
    "it, several-fold at times";
constexpr const char* momentum =
    "an error itself, of 0 that exact motion keeps, by this mesh, whose mass falls short of the shape's, and these "
    "steps";
constexpr const char* drift =
    "an error itself, of 0 that exact motion keeps, by these steps: rounding, but of Euler's, between whose ends a "
    "cubic makes of velocities of first order up to 3/4 h g";
constexpr const char* once = "a single run, taken once; times that are compared have the spread of repetitions";
constexpr const char* by_auto = "stated, or `auto` by a closed form of the first touch";

struct Reason {
  const char *table, *column, *why;  // table: "*": any
  bool some = false;                 // of some of its numbers, never of all: others have a bar
};

constexpr Reason reasons[] = {
    {"*", "dt", chosen},
    {"*", "busy", clocked},
    {"*", "standard error", itself},
    {"*", "standard error of time", itself},
    {"*", "standard error of tests", itself},
    {"*", "claimed", stated},
    {"aliasing", "frame rate", stated},
    {"aliasing", "frame error", nothing, true},
    {"aliasing", "low-band error", nothing, true},
    {"aliasing-claim", "frame rate", stated},
    {"aliasing-claim", "frame error cut modal", nothing, true},
    {"aliasing-claim", "low-band error cut modal", nothing, true},
    {"aliasing-modes", "apparent frequency", unpaired, true},
    {"aliasing-modes", "energy above F/2", unpaired, true},
    {"aliasing-modes", "frame rate", stated},
    {"aliasing-modes", "frequency", unpaired, true},
    {"amplitude", "speed", "of the rigid body at its first touch, in closed form"},
    {"amplitude", "speed/scene's", stated},
    {"amplitude", "of steps", itself},
    {"amplitude-exponents", "expected", "theory"},
    {"amplitude-limits", "error of linear", stated},
    {"aspect", "largest residual", itself},
    {"budget", "K norm", nothing, true},
    {"budget", "M norm", nothing, true},
    {"contact-conditions", "condition of duration", unstepped, true},
    {"contact-conditions", "condition of impulse", unstepped, true},
    {"contact-conditions", "condition of peak force", unstepped, true},
    {"contact-conditions", "condition of start", unstepped, true},
    {"contact-conditions", "factor", stated},
    {"collision-cost", "building", clocked},
    {"collision-cost", "depth error", "of the body's polygons against its shape, in double precision"},
    {"collision-cost", "memory", counted},
    {"collision-cost", "spread", itself},
    {"collision-cost", "time", clocked},
    {"collision-cost", "time a point", clocked},
    {"collision-cost-claim", "exponent analytic", on_line, true},
    {"collision-cost-claim", "exponent rival", on_line, true},
    {"collision-cost-crossover", "time ratio", clocked},
    {"collision-cost-exponents", "exponent of tests", on_line, true},
    {"collision-cost-exponents", "theory", "theory"},
    {"contact-forces", "depth", stated},
    {"contact-forces", "error of exact", itself},
    {"contact-forces-orders", "depth", stated},
    {"contact-geometry", "condition", fitted},
    {"contact-geometry", "residual", fitted},
    {"contact-geometry", "worst mode", fitted},
    {"contact-geometry", "largest", fitted},
    {"contact-meetings", "stiffness", by_auto},
    {"contact-meetings", "E*", stated},
    {"contact-meetings", "a", "closed form of what the case states, and its speed"},
    {"contact-meetings", "k a/E*", "closed form of what the case states, and its speed"},
    {"contact-samples", "size / a", stated},
    {"contact-stability", "dt / limit", theory},
    {"contact-stability", "energy", missed, true},
    {"contact-stability", "limit", theory},
    {"contact-stability", "opening limit", theory},
    {"contact-stability", "spectral radius", theory},
    {"contact-stability", "stiffness factor", stated},
    {"contact-stability-summary", "unstable from", "the least of steps that are halves of each other"},
    {"contact-stiffness", "change of duration", unstepped, true},
    {"contact-stiffness", "change of impulse", unstepped, true},
    {"contact-stiffness", "change of peak force", unstepped, true},
    {"contact-stiffness", "duration", unstepped, true},
    {"contact-stiffness", "first touch", flown},
    {"contact-stiffness", "impulse", unstepped, true},
    {"contact-stiffness", "peak force", unstepped, true},
    {"contact-stiffness", "factor", stated},
    {"contact-stiffness", "k a/E*", by_auto},
    {"contact-stiffness", "stiffness", by_auto},
    {"contacts-in-turn", "duration", on_steps, true},
    {"contacts-in-turn", "start", on_steps},
    {"contact-time", "share", clocked},
    {"contact-time", "time", clocked},
    {"contact-time", "time a call", clocked},
    {"contact-time-runs", "real-time factor", clocked},
    {"contact-time-runs", "spread", itself},
    {"contact-time-runs", "time", clocked},
    {"contact-time-runs", "with displacements", clocked},
    {"corrected-stability", "dt / limit", theory},
    {"corrected-stability", "energy", missed, true},
    {"corrected-stability", "impulse error", missed, true},
    {"corrected-stability", "peak force error", missed, true},
    {"corrected-stability", "limit", theory},
    {"corrected-stability", "opening limit", theory},
    {"corrected-stability", "spectral radius", theory},
    {"corrected-stability", "stiffness factor", stated},
    {"corrected-stability-summary", "unstable from", "the least of steps that are halves of each other"},
    {"damping", "zeta asked", stated},
    {"damping", "zeta by decay", met, true},
    {"damping", "zeta full", met, true},
    {"damping-coupling-modes", "share of its energy", "of a complex mode of one undamped alone, all of it", true},
    {"damping-of-steps", "difference", met, true},
    {"damping-of-steps", "zeta asked", stated},
    {"damping-of-steps", "zeta of run", "of a mode that the finer mesh's run has no ratio of", true},
    {"flight-cost", "contact time", "as that run had it, whose cost it counts"},
    {"flight-cost", "flight time", chosen},
    {"flight-cost", "real-time factor", clocked},
    {"flight-cost", "spread", itself},
    {"flight-cost", "time", clocked},
    {"flight-cost", "time a step", clocked},
    {"flight-cost-exponents", "expected", "theory"},
    {"force-history", "normal force", unstepped, true},
    {"force-history", "time", stated},
    {"frequencies", "GCI", itself},
    {"frequencies", "reference", "published, or a closed form; its uncertainty is the bar of the errors against it"},
    {"frequency-response", "frequency", chosen},
    {"frequency-response", "phase", "of a real response, 0 or 180 degrees", true},
    {"instructions", "MIPS for real time", counted},
    {"instructions", "a step", counted},
    {"instructions", "instructions", counted},
    {"instructions", "real-time factor", clocked},
    {"instructions", "share counted", counted},
    {"instructions", "time", clocked},
    {"locking", "nu", stated},
    {"mode-amplitude-exponents", "theory", "theory"},
    {"records", "angular-drift", conserved},
    {"records", "assembly-time", once},
    {"records", "energy-defect", conserved},
    {"records", "energy-gain", conserved},
    {"records", "free-gain", conserved},
    {"records", "load-error", itself},
    {"records", "momentum-defect", momentum},
    {"records", "momentum-drift", drift},
    {"records", "offline-time", once},
    {"records", "online-time", once},
    {"records", "stepping-time", once},
    {"records", "touches", counted},
    {"slenderness", "bar", itself},
    {"slenderness", "length/width", stated},
    {"stability-map", "dt / limit", theory},
    {"stability-map", "limit", theory},
    {"stability-map", "spectral radius", theory},
    {"step-limit-runs", "dt / limit", stated},
    {"step-limit-runs", "growth by theory", theory},
    {"step-limit-exponents", "exponent", on_line, true},
    {"step-limits", "dt formula", "of full order: of this mesh's own frequency, to rounding; or a limit of 0", true},
    {"step-limits", "dt measured", "of a limit of 0, where no step is stable", true},
    {"step-limits", "omega deciding", "of full order: this mesh's own, to rounding", true},
    {"step-limits", "omega max", "of full order: this mesh's own, to rounding", true},
    {"step-limits", "zeta", "of full order: this mesh's own, to rounding", true},
};

struct Numbers {
  std::string unit = {};
  long n = 0, n_without = 0;

  void add(const std::string& in, bool has_bar) {
    unit = in;
    ++n;
    n_without += !has_bar;
  }
};

using Columns = std::map<std::pair<std::string, std::string>, Numbers>;  // by the names of table and column

// A distance of 0 to what is beside a number tells nothing of how far that may be off, unless it is one itself.
bool is_bar(double bar, double number) { return std::isfinite(bar) && (bar > 0 || number == 0); }

void count(const Finding& finding, Columns& columns) {
  for (std::size_t i = 0; i < finding.rows.size(); ++i)
    for (std::size_t j = 0; j < finding.columns.size(); ++j) {
      const auto& [name, unit] = finding.columns[j];
      const double* number = std::get_if<double>(&finding.rows[i][j]);
      if (unit.empty() || !number || !std::isfinite(*number)) continue;
      columns[{finding.name, name}].add(unit, !finding.bars.empty() && is_bar(finding.bars[i][j], *number));
    }
}

}  // namespace

std::string reason_without_bar(const std::string& table, const std::string& column, bool of_all) {
  const auto* found = std::ranges::find_if(reasons, [&](const Reason& reason) {
    return (reason.table == std::string("*") || reason.table == table) && reason.column == column &&
           !(of_all && reason.some);
  });
  return found == std::end(reasons) ? "" : found->why;
}

Sheet unbarred_columns(const std::vector<Finding>& findings, const std::vector<Record>& records) {
  Columns columns;
  for (const Finding& finding : findings) count(finding, columns);
  for (const Record& record : records)
    if (is_usable(record)) columns[{"records", record.metric}].add(record.unit, record.error_bar.has_value());
  Sheet sheet{.name = "unbarred",
              .title = "Numbers without a bar",
              .note =
                  "Numbers of analyses' tables that have no error bar beside them, by column, and of the records, by "
                  "metric, and why they need none.",
              .columns = {{"table", ""},
                          {"column", ""},
                          {"unit", ""},
                          {"numbers", "", Column::Kind::number},
                          {"without a bar", "", Column::Kind::number},
                          {"why", ""}},
              .rows = {},
              .n_keys = 2};
  for (const auto& [of, numbers] : columns)
    if (numbers.n_without > 0)
      sheet.rows.push_back({text_cell(of.first), text_cell(of.second), text_cell(numbers.unit), count_cell(numbers.n),
                            count_cell(numbers.n_without),
                            text_cell(reason_without_bar(of.first, of.second, numbers.n == numbers.n_without))});
  return sheet;
}

}  // namespace mb
