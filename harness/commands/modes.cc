#include <fmt/ostream.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "cases/json/json.h"
#include "cases/scene/nearest.h"
#include "harness/analysis/modal_body.h"
#include "harness/commands/commands.h"
#include "harness/commands/find_cases.h"
#include "harness/study/estimate.h"
#include "harness/study/memory.h"
#include "harness/study/truth.h"
#include "modal/bases/eigenmodes.h"
#include "modal/bases/participation.h"
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
    for (++next; next < modes.size() && are_one_multiplet(lambda(next - 1), lambda(next), modes.lambda_max);) ++next;
    all.insert(all.end(), static_cast<size_t>(next - first), next - first);
  }
  return all;
}

// What is told of the modes, one entry or row a mode.
struct Told {
  Modes modes;
  Index count;  // of modes to be told of
  std::vector<Index> multiplicity;
  std::vector<int> degree;
  MatrixXd participation;  // count x 3
  VectorXd bar;            // [rad/s] of the frequencies
};

// Of a body on the case's other mesh.
struct Beside {
  const Body& body;
  double bar_per_distance;
};

// Of the mesh (another_mesh), infinity where the other has no such mode, and rounding.
VectorXd bars(const Modes& modes, const VectorXd& omega_of_other, double bar_per_distance, Index count) {
  VectorXd all = VectorXd::Zero(count);
  for (Index i = modes.n_rigid; i < count; ++i) {
    const double omega = modes.omega[i], off = std::abs(omega_of_other[i - modes.n_rigid] - omega);
    all[i] = std::isnan(off) ? std::numeric_limits<double>::infinity()
                             : bar_per_distance * off + rounding_of_frequency(modes, omega) * omega;
  }
  return all;
}

Told told(const Scene& scene, const Body& body, const FullModel& full, const Modes& modes, Index count,
          const VectorXd& bar) {
  const MatrixXd Phi = modes.Phi.leftCols(count);
  const MatrixXd Mr = translated_mass(full, evaluation_points(scene, body).volume, body.material.density);
  MatrixXd shares = participation(Phi, Mr, body.material.density * full.mesh_volume());
  shares = shares.unaryExpr([](double share) { return share < 1e-12 ? 0 : share; });  // rounding
  return {modes, count, multiplicities(modes), polynomial_degrees(full, Phi), shares, bar};
}

// The lowest modes of a body on its mesh, rigid ones among `most`.
struct Solved {
  std::shared_ptr<const FullModel> full;
  Modes modes;
  SeenModes seen(const Scene& scene, const Body& body) const {
    return seen_modes(*full, evaluation_points(scene, body).volume, modes);
  }
};
Solved solved(const Scene& scene, const Body& body, int most) {
  const std::shared_ptr<const FullModel> full = full_model(scene, body, body.resolution, modes_of_a_mesh);
  const System& system = full->system();
  const Index count = std::min<Index>(most, system.u0.size()), n_rigid = system.R.cols();
  return {full, lowest_modes(system, static_cast<int>(std::max<Index>(0, count - n_rigid)), physical_shift(body))};
}

Told computed(const Scene& scene, const Body& body, const Beside& beside, int most) {
  const SeenModes other = solved(scene, beside.body, most + more_of_other).seen(scene, beside.body);
  const Solved own = solved(scene, body, most);
  const Index count = std::min<Index>(most, own.full->system().u0.size());
  const VectorXd omega_of_other = paired_frequencies(own.seen(scene, body), other);
  return told(scene, body, *own.full, own.modes, count,
              bars(own.modes, omega_of_other, beside.bar_per_distance, count));
}

std::string degree_text(int degree) {
  return degree == beyond ? fmt::format("> {}", most_degree) : std::to_string(degree);
}

std::string share_text(double share) { return share < 5e-5 ? "0" : fmt::format("{:.4f}", share); }

std::string bar_text(double bar) { return std::isfinite(bar) ? fmt::format("{:.1e}", bar) : "unknown"; }

void print_table(const Told& all, std::ostream& out) {
  fmt::print(out, "{:>5}  {:>14}  {:>14}  {:>8}  {:>9}  {:>12}  {:>6}  {:>6}  {:>6}  {:>6}  kind\n", "mode",
             "omega [rad/s]", "f [Hz]", "+- [Hz]", "residual", "multiplicity", "degree", "x", "y", "z");
  for (Index i = 0; i < all.count; ++i) {
    const auto share = [&](Index d) { return share_text(all.participation(i, d)); };
    const double omega = all.modes.omega[i];
    fmt::print(out, "{:>5}  {:>14.7g}  {:>14.7g}  {:>8}  {:>9.1e}  {:>12}  {:>6}  {:>6}  {:>6}  {:>6}  {}\n", i + 1,
               omega, omega / (2 * pi), bar_text(all.bar[i] / (2 * pi)), all.modes.residual[i],
               all.multiplicity[static_cast<size_t>(i)], degree_text(all.degree[static_cast<size_t>(i)]), share(0),
               share(1), share(2), i < all.modes.n_rigid ? "rigid" : "elastic");
  }
  fmt::print(
      out,
      "\n+-: twice the distance to the frequency of what moves alike on the truth's finer mesh, where nothing does of "
      "the same place (once, to the coarser, where the body has that itself), and rounding\ndegree: the least of a "
      "polynomial displacement in x, y, z, as the supports admit "
      "it, that holds {:g} % of the mode's M norm squared\nx, y, z: participation, the effective modal mass along the "
      "axis as a share "
      "of the body's mass\n",
      100 * degree_share);
}

void print_json(const Scene& scene, const Body& body, const Told& all, std::ostream& out) {
  Json list = Json::array();
  for (Index i = 0; i < all.count; ++i) {
    const auto entry = static_cast<size_t>(i);
    const auto share = [&](Index d) { return all.participation(i, d); };
    list.push_back({{"omega", all.modes.omega[i]},
                    {"hertz", all.modes.omega[i] / (2 * pi)},
                    {"bar_hertz", std::isfinite(all.bar[i]) ? Json(all.bar[i] / (2 * pi)) : Json(nullptr)},
                    {"residual", all.modes.residual[i]},
                    {"multiplicity", all.multiplicity[entry]},
                    {"polynomial_degree", all.degree[entry] == beyond ? Json(nullptr) : Json(all.degree[entry])},
                    {"participation", {share(0), share(1), share(2)}},
                    {"kind", i < all.modes.n_rigid ? "rigid" : "elastic"}});
  }
  fmt::print(out, "{}\n",
             to_line({{"schema", 3},
                      {"case", scene.name},
                      {"body", body.name},
                      {"n_dofs", all.modes.Phi.rows()},
                      {"modes", list}}));
}

}  // namespace

int modes_command(const ModesOptions& options, const Catalogue& catalogue, const Console& console) {
  const Scene scene = read_toml(find_case(options.case_name), catalogue.vocabulary());
  const Body& body = find_body(scene, options.body);
  const auto [meshes, bar_per_distance] = another_mesh(scene);
  const Scene other = on_meshes(scene, meshes);
  const Beside beside{other.bodies[static_cast<size_t>(&body - scene.bodies.data())], bar_per_distance};
  const double needed = std::max(memory_of_modes(scene, body, options.count),
                                 memory_of_modes(scene, beside.body, options.count + more_of_other));
  try {
    require_memory(needed, available_memory());
    const Told all = computed(scene, body, beside, options.count);
    options.json ? print_json(scene, body, all, console.out) : print_table(all, console.out);
  } catch (const std::exception& error) {
    throw std::runtime_error(
        fmt::format("{} · {} modes of '{}': {}", scene.name, options.count, body.name, failure_text(error, needed)));
  }
  return 0;
}

}  // namespace mb
