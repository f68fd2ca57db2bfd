#include "harness/commands/plan_table.h"

#include <fmt/ostream.h>

#include "cases/json/json.h"

namespace mb {

namespace {

Json contender_json(const Contender& c, const Catalogue& catalogue) {
  using Knob = Integrator::Knob;
  const Knob knob = catalogue.integrator(c.integrator).knob;
  const Settings& settings = c.settings;
  const auto number_if = [](bool applies, auto value) { return applies ? Json(value) : Json(nullptr); };
  return {{"method", c.method},
          {"integrator", c.integrator},
          {"modes", number_if(catalogue.method(c.method).takes_modes(), settings.modes)},
          {"time_step", number_if(knob == Knob::time_step, settings.time_step)},
          {"relative_tolerance", number_if(knob == Knob::tolerance, settings.relative_tolerance)},
          {"resolution", to_string(c.resolution)}};
}

}  // namespace

void print_plan_table(const std::vector<PlannedJob>& plan, std::ostream& out) {
  for (const PlannedJob& one : plan)
    fmt::print(out, "{}  {:<8} {} · {}\n", one.job.hash, one.stored ? "stored" : "to run", one.case_name,
               one.job.label);
}

void print_plan_json(const std::vector<PlannedJob>& plan, const Catalogue& catalogue, std::ostream& out) {
  Json list = Json::array();
  for (const auto& [case_name, profile, job, stored] : plan) {
    const bool marks = job.kind == Job::Kind::marks;
    Json json = {{"run", job.hash},    {"case", case_name},
                 {"profile", profile}, {"kind", marks ? "marks" : "analysis"},
                 {"label", job.label}, {"stored", stored}};
    if (marks) json.update(contender_json(job.contender, catalogue));
    list.push_back(std::move(json));
  }
  fmt::print(out, "{}\n", to_line({{"schema", 1}, {"jobs", list}}));
}

}  // namespace mb
