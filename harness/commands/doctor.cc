#include <fmt/ostream.h>

#include <algorithm>

#include "cases/json/json.h"
#include "harness/commands/colour.h"
#include "harness/commands/commands.h"
#include "harness/commands/machine.h"

namespace mb {

namespace {

void print_table(const std::vector<Diagnosis>& all, std::ostream& out) {
  const bool coloured = shows_colour(out);
  for (const Diagnosis& d : all) {
    fmt::print(out, "{}  {:<18}  {}\n", d.ok ? green("ok     ", coloured) : yellow("warning", coloured), d.name,
               d.value);
    if (!d.ok) fmt::print(out, "{:29}{}\n", "", d.advice);
  }
}

void print_json(const std::vector<Diagnosis>& all, std::ostream& out) {
  Json list = Json::array();
  for (const Diagnosis& d : all)
    list.push_back({{"name", d.name}, {"value", d.value}, {"verdict", d.ok ? "ok" : "warning"}, {"advice", d.advice}});
  fmt::print(out, "{}\n", to_line({{"schema", 1}, {"diagnoses", list}}));
}

}  // namespace

int doctor_command(const DoctorOptions& options, const Console& console) {
  const std::vector<Diagnosis> all = diagnose(examine(options.store));
  if (options.json)
    print_json(all, console.out);
  else
    print_table(all, console.out);
  const auto n = std::count_if(all.begin(), all.end(), [](const Diagnosis& d) { return !d.ok; });
  fmt::print(console.err, "{} warning{}\n", n, n == 1 ? "" : "s");
  return 0;
}

}  // namespace mb
