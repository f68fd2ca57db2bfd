#include "harness/study/instability.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mb {
namespace {

constexpr double blown_up = 1e3;  // [-] error of a finite answer that has left the truth behind
// [-] of free vibration over the run, by theory: what small answers of so unstable steps show is how little was there
// to grow. Below it steps past their limit may be accurate: undamped explicit Euler's all are past it.
constexpr double grown = 10;
// [-] of the energy brought to the contact. Steps within their limit swing by some per cents of it and give them back;
// modes of a few shapes on a stiff layer by a third.
constexpr double fed = 1;

bool blew_up(const Record& r) {
  return r.status == "not_finite" || (r.metric == "displacement-error" && r.value > blown_up);
}

// Nothing but contact and weight, whose energy is counted, moves the bodies.
bool is_isolated(const Scene& scene) {
  const auto stands = [](const Support& support) { return !support.drive; };
  return !scene.contacts.empty() && scene.loads.empty() &&
         std::ranges::all_of(scene.bodies, [&](const Body& b) { return std::ranges::all_of(b.supports, stands); });
}

}  // namespace

bool is_past_its_limit(const std::vector<Record>& marks, const Scene& scene, const Integrator& integrator,
                       double growth) {
  const auto feeds = [](const Record& r) { return r.metric == "energy-gain" && r.value > fed; };
  return (integrator.conditionally_stable && (growth > grown || std::ranges::any_of(marks, &blew_up))) ||
         (is_isolated(scene) && std::ranges::any_of(marks, feeds));
}

void name_unstable(std::vector<Record>& marks) {
  for (Record& record : marks) record.status = "unstable", record.value = std::numeric_limits<double>::quiet_NaN();
}

}  // namespace mb
