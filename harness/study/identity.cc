#include "harness/study/identity.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cases/scene/read_toml.h"
#include "harness/store/hash.h"
#include "sources.h"

namespace mb {

std::string truth_hash(const Scene& scene, const Resolution& resolution, double relative_tolerance) {
  const bool has_ratios =
      std::ranges::any_of(scene.bodies, [](const Body& body) { return !body.damping_ratios.empty(); });
  const std::string modes = has_ratios ? sources::contenders : "";  // full order then damps the modes we find
  return content_hash(fmt::format("truth\n{}\n{}\n{:a}\n{}{}\n{}\n", canonical(scene), to_string(resolution),
                                  relative_tolerance, sources::reference, modes, sources::libraries));
}

std::set<std::string> truth_hashes(const Scene& scene) {
  const TruthSettings& t = scene.truth;
  const Resolution own = own_meshes(scene);
  return {truth_hash(scene, t.finer, t.relative_tolerance), truth_hash(scene, t.coarser, t.relative_tolerance),
          truth_hash(scene, own, t.relative_tolerance), truth_hash(scene, own, t.relative_tolerance / 100)};
}

std::string run_hash(const Scene& scene, const Contender& c) {
  const bool rigid = c.settings.rotation == RotationCoupling::rigid;
  return content_hash(fmt::format("run\n{} {}\n{}\n{} {} {}\n{} {:a} {:a} {:a}{}\n{} {} {}\n", scene.name,
                                  scene.profile, canonical(scene), c.method, c.integrator, to_string(c.resolution),
                                  c.settings.modes, c.settings.time_step, c.settings.relative_tolerance,
                                  c.settings.load_tolerance,
                                  rigid ? "" : std::string(" ") + to_string(c.settings.rotation), sources::reference,
                                  sources::contenders, sources::libraries));
}

// What an analysis looks at besides the scene: the study's methods, mode counts, steppings and load tolerance.
std::string analysis_hash(const Scene& scene, const std::string& analysis) {
  std::string study = fmt::format("{} {:a}\n", fmt::join(scene.study.methods, ","), scene.study.load_tolerance);
  for (const int r : scene.study.modes) study += fmt::format("{} ", r);
  for (const double h : scene.study.contact_steps) study += fmt::format("{:a} ", h);
  for (const Stepping& s : scene.study.steppings) {
    study += fmt::format("\n{} {} {}", s.integrator, fmt::join(s.methods, ","), fmt::join(s.modes, ","));
    for (const double x : s.time_steps) study += fmt::format(" {:a}", x);
    for (const double x : s.relative_tolerances) study += fmt::format(" {:a}", x);
  }
  return content_hash(fmt::format("analysis {}\n{} {}\n{}\n{}\n{} {} {} {}\n", analysis, scene.name, scene.profile,
                                  canonical(scene), study, sources::reference, sources::contenders, sources::analyses,
                                  sources::libraries));
}

}  // namespace mb
