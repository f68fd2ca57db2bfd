#include "harness/study/identity.h"

#include <fmt/format.h>

#include "cases/scene/read_toml.h"
#include "harness/store/hash.h"
#include "sources.h"

namespace mb {

std::string truth_hash(const Scene& scene, const Resolution& resolution, double relative_tolerance) {
  return content_hash(fmt::format("truth\n{}\n{}\n{:a}\n{}\n{}\n", canonical(scene), to_string(resolution),
                                  relative_tolerance, sources::reference, sources::libraries));
}

std::string run_hash(const Scene& scene, const Contender& c) {
  return content_hash(fmt::format("run\n{} {}\n{}\n{} {} {}\n{} {:a} {:a} {:a}\n{} {} {}\n", scene.name, scene.profile,
                                  canonical(scene), c.method, c.integrator, to_string(c.resolution), c.settings.modes,
                                  c.settings.time_step, c.settings.relative_tolerance, c.settings.load_tolerance,
                                  sources::reference, sources::contenders, sources::libraries));
}

}  // namespace mb
