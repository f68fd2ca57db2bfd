// Who is counted, and what of them: stepping and displacements at the frames, as online times have it, from the body's
// own meshes.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "harness/catalogue.h"

namespace mb {

struct CountedContender {
  std::string name;  // "rigid", "linear", "quadratic", "static-correction", "full order"
  std::string method, integrator;
  Settings settings;
  double until;  // [s] what is counted ends then: the duration, of full order less
};

// Rigid bodies; linear, and linear and quadratic modes; static-correction with 32 modes or the nearest count of the
// study: all with its largest step in contact. Full order by newmark with the largest step of its rivals, up to a
// twentieth of what is left after the first touch. Throws std::invalid_argument for a scene without contact.
std::vector<CountedContender> counted_contenders(const Scene& scene);

VectorXd counted_times(const Scene& scene, const CountedContender& contender);  // [s] frames, and the end
std::unique_ptr<Prepared> prepare(const CountedContender& contender, const Catalogue& catalogue, const Model& model);
Trajectory counted_work(const Prepared& prepared, const VectorXd& times);

// Under callgrind: each contender's work, counted by its name.
void count_contest(const std::shared_ptr<const Scene>& scene, const Catalogue& catalogue);

}  // namespace mb
