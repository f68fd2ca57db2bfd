#include "harness/study/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>
#include <tuple>

#include "harness/analysis/analysis.h"
#include "harness/study/identity.h"

namespace mb {

namespace {

// One contender for each time step or tolerance.
void append(std::vector<Contender>& all, Contender contender, const std::vector<double>& time_steps,
            const std::vector<double>& tolerances) {
  for (const double step : time_steps) {
    contender.settings.time_step = step;
    all.push_back(contender);
  }
  for (const double tolerance : tolerances) {
    contender.settings.relative_tolerance = tolerance;
    all.push_back(contender);
  }
}

// The mode counts a method is run at: the one entry 0 where it takes none.
std::vector<int> mode_counts(const Method& method, const std::vector<int>& modes) {
  return method.takes_modes() ? modes : std::vector{0};
}

std::vector<Contender> closed_form(const Scene& scene, const Catalogue& catalogue) {
  std::vector<Contender> all;
  for (const auto& method : scene.study.methods)
    for (const int modes : mode_counts(catalogue.method(method), scene.study.modes))
      for (const RotationCoupling rotation : scene.study.rotations) {
        Contender contender{method, "exact", own_meshes(scene), {}};
        contender.settings.modes = modes;
        contender.settings.rotation = rotation;
        if (scene.contacts.empty()) {
          contender.settings.load_tolerance = scene.study.load_tolerance;
          all.push_back(contender);
        } else {  // the closed form is that of the flight
          append(all, contender, scene.study.contact_steps, {});
        }
      }
  return all;
}

void append(std::vector<Contender>& all, const Stepping& stepping, const Scene& scene, const Catalogue& catalogue) {
  for (const auto& method : stepping.methods)
    for (const int modes : mode_counts(catalogue.method(method), stepping.modes)) {
      Contender contender{method, stepping.integrator, own_meshes(scene), {}};
      contender.settings.modes = modes;
      append(all, contender, stepping.time_steps, stepping.relative_tolerances);
    }
}

// The i-th mesh of a rival, of the whole scene.
Resolution mesh_of(const Rival& rival, size_t i, int degree, const Scene& scene) {
  Resolution all{degree, rival.cells[i], rival.graded};
  all.others = own_meshes(scene).others;
  if (!rival.second_cells.empty()) all.others.at(0) = {degree, rival.second_cells[i], rival.graded};
  return all;
}

void append(std::vector<Contender>& all, const Rival& rival, const Scene& scene) {
  if (rival.cells.empty())
    append(all, {"full-order", rival.integrator, own_meshes(scene), {}}, rival.time_steps, rival.relative_tolerances);
  for (size_t i = 0; i < rival.cells.size(); ++i)
    for (const int degree : rival.degrees)
      append(all, {"full-order", rival.integrator, mesh_of(rival, i, degree, scene), {}}, rival.time_steps,
             rival.relative_tolerances);
}

}  // namespace

std::vector<Contender> contenders(const Scene& scene, const Catalogue& catalogue) {
  std::vector<Contender> all = closed_form(scene, catalogue);
  for (const Stepping& stepping : scene.study.steppings) append(all, stepping, scene, catalogue);
  for (const Rival& rival : scene.study.rivals) append(all, rival, scene);
  std::stable_sort(all.begin(), all.end(), [](const Contender& a, const Contender& b) {
    const auto key = [](const Resolution& r) { return std::tuple(r.cells, r.degree, r.graded, to_string(r)); };
    return key(a.resolution) < key(b.resolution);
  });
  return all;
}

std::vector<Contender> truth_contenders(const Scene& scene) {
  std::vector<Contender> all;
  for (const Resolution& resolution : {scene.truth.finer, own_meshes(scene)}) {
    all.push_back({"full-order", "sundials", resolution, {}});
    all.back().settings.relative_tolerance = scene.truth.relative_tolerance;
  }
  return all;
}

std::vector<Job> jobs(const Scene& scene, const Catalogue& catalogue) {
  std::vector<Job> all;
  for (const Contender& contender : contenders(scene, catalogue))
    all.push_back({Job::Kind::marks, run_hash(scene, contender), label(contender), contender, ""});
  for (const std::string& analysis : scene.study.analyses)
    all.push_back({Job::Kind::analysis, analysis_hash(scene, analysis), analysis, {}, analysis});
  std::set<std::string> known;
  std::erase_if(all, [&](const Job& job) { return !known.insert(job.hash).second; });
  return all;
}

std::optional<Shard> parse_shard(const std::string& text) {
  Shard shard;
  const char* const end = text.data() + text.size();
  const auto [slash, first] = std::from_chars(text.data(), end, shard.i);
  if (first != std::errc() || slash == end || *slash != '/') return {};
  const auto [rest, second] = std::from_chars(slash + 1, end, shard.n);
  if (second != std::errc() || rest != end || shard.i < 1 || shard.i > shard.n || shard.n > most_shards) return {};
  return shard;
}

std::vector<Job> part(const std::vector<Job>& jobs, const Shard& shard) {
  std::vector<Job> mine;
  for (size_t k = static_cast<size_t>(shard.i - 1); k < jobs.size(); k += static_cast<size_t>(shard.n))
    mine.push_back(jobs[k]);
  return mine;
}

bool is_full_order(const Contender& contender) { return contender.method == "full-order"; }

bool steps_modes(const Contender& contender) {
  return !is_full_order(contender) && contender.method != "full" && contender.integrator != "exact";
}

bool takes_times(const Job& job) { return job.kind == Job::Kind::analysis && analysis(job.analysis).timed; }

std::string label(const Contender& c) {
  std::string text = c.method;
  if (c.settings.modes > 0) text += fmt::format(" r={}", c.settings.modes);
  if (c.settings.rotation != RotationCoupling::rigid)
    text += std::string(" rotation ") + to_string(c.settings.rotation);
  text += " " + c.integrator;
  if (c.settings.time_step > 0) text += fmt::format(" dt={:.3g} s", c.settings.time_step);
  if (c.integrator == "sundials") text += fmt::format(" rtol={:.0e}", c.settings.relative_tolerance);
  return text + " " + to_string(c.resolution);
}

}  // namespace mb
