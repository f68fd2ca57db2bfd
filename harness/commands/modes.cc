#include <fmt/ostream.h>

#include <algorithm>

#include "cases/json/json.h"
#include "cases/scene/nearest.h"
#include "harness/commands/commands.h"
#include "harness/commands/find_cases.h"
#include "harness/study/truth.h"
#include "modal/bases/eigenmodes.h"
#include "reference/full_model.h"

namespace mb {

namespace {

const Body& find_body(const Scene& scene, const std::string& name) {
  if (name.empty()) return scene.bodies.front();
  std::vector<std::string> names;
  for (const Body& body : scene.bodies) {
    if (body.name == name) return body;
    names.push_back(body.name);
  }
  throw UsageError("unknown body '" + name + "'; " + suggestion(name, names, "bodies"));
}

// Of each mode the number of those that share its frequency, as far as they are known.
std::vector<Index> multiplicities(const Modes& modes) {
  const auto lambda = [&](Index i) { return modes.omega[i] * modes.omega[i]; };
  std::vector<Index> all;
  for (Index first = 0, next = 0; first < modes.size(); first = next) {
    for (++next; next < modes.size() && lambda(next) - lambda(next - 1) <= multiplet_gap * lambda(next);) ++next;
    all.insert(all.end(), static_cast<size_t>(next - first), next - first);
  }
  return all;
}

void print_table(const Modes& modes, Index count, std::ostream& out) {
  const std::vector<Index> multiplicity = multiplicities(modes);
  fmt::print(out, "{:>5}  {:>14}  {:>14}  {:>9}  {:>12}  kind\n", "mode", "omega [rad/s]", "f [Hz]", "residual",
             "multiplicity");
  for (Index i = 0; i < count; ++i)
    fmt::print(out, "{:>5}  {:>14.7g}  {:>14.7g}  {:>9.1e}  {:>12}  {}\n", i + 1, modes.omega[i],
               modes.omega[i] / (2 * pi), modes.residual[i], multiplicity[static_cast<size_t>(i)],
               i < modes.n_rigid ? "rigid" : "elastic");
}

void print_json(const Scene& scene, const Body& body, Index n_dofs, const Modes& modes, Index count,
                std::ostream& out) {
  const std::vector<Index> multiplicity = multiplicities(modes);
  Json list = Json::array();
  for (Index i = 0; i < count; ++i)
    list.push_back({{"omega", modes.omega[i]},
                    {"hertz", modes.omega[i] / (2 * pi)},
                    {"residual", modes.residual[i]},
                    {"multiplicity", multiplicity[static_cast<size_t>(i)]},
                    {"kind", i < modes.n_rigid ? "rigid" : "elastic"}});
  fmt::print(out, "{}\n",
             to_line({{"schema", 1}, {"case", scene.name}, {"body", body.name}, {"n_dofs", n_dofs}, {"modes", list}}));
}

}  // namespace

int modes_command(const ModesOptions& options, const Catalogue& catalogue, const Console& console) {
  const Scene scene = read_toml(find_case(options.case_name), catalogue.vocabulary());
  const Body& body = find_body(scene, options.body);
  const auto full = full_model(scene, body, body.resolution, modes_of_a_mesh);
  const System& system = full->system();
  const Index n = system.u0.size(), n_rigid = system.R.cols();
  const Index count = std::min<Index>(options.count, n);
  const int n_elastic = static_cast<int>(std::max<Index>(0, count - n_rigid));
  const Modes modes = lowest_modes(system, n_elastic, physical_shift(body));
  if (options.json)
    print_json(scene, body, n, modes, count, console.out);
  else
    print_table(modes, count, console.out);
  return 0;
}

}  // namespace mb
