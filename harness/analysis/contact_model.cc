// What modal contact is made of: the layer that each obstacle meets, and the polynomials and samples that carry it.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "harness/analysis/contact_tables.h"

namespace mb {

namespace {

constexpr double touch_tolerance = 2e-12;  // [-] of the body's extent: gaps to which touches are told, and rounding

Finding meeting_table() {
  return table(
      "contact", "contact-meetings", "How the body comes to its obstacles",
      "Of the rigid body, in closed form, before anything deforms; sizes are Hertz's, of a flat end a bar's. "
      "Bar of a touch: 2e-12 of the body's extent at that speed; of the others what that makes of them, and rounding. "
      "Stiffness `auto` is 100 E*/a: the layer then adds 0.3 % to the approach of a sphere.",
      {{"obstacle", ""},
       {"law", ""},
       {"stiffness", "Pa/m"},
       {"stated", ""},
       {"E*", "Pa"},
       {"a", "m"},
       {"k a/E*", "-"},
       {"first touch", "s"},
       {"speed", "m/s"},
       {"approach", "m"},
       {"duration", "s"},
       {"force", "N"}});
}

Finding geometry_table() {
  return table(
      "contact", "contact-geometry", "Modes as polynomials, where contact sees them",
      "Every mode is fitted by monomials up to the degree offered; residuals are over the mode's own root mean "
      "square, and its largest value; coefficients below 1e-10 of it in sum are dropped. Condition: of the "
      "scaled, weighted monomials. Samples: points on the exact surface.",
      {{"body", ""},
       {"method", ""},
       {"modes r", ""},
       {"degree", ""},
       {"coefficients", ""},
       {"kept", ""},
       {"condition", "-"},
       {"residual", "-"},
       {"worst mode", "-"},
       {"largest", "-"},
       {"static shapes", ""},
       {"samples", ""}});
}

// Hertz's approach, duration and force go with the speed to the power of 4/5, -1/5 and 6/5, a bar's with less.
std::vector<std::pair<const char*, double>> bars_of_meeting(const Meeting& meeting, double extent, double gravity) {
  const ContactSize& size = meeting.size;
  const double touch = touch_tolerance * extent / size.speed;                                      // [s]
  const double speed = gravity * touch / size.speed + 8 * std::numeric_limits<double>::epsilon();  // [-]
  return {{"first touch", touch},
          {"speed", speed * size.speed},
          {"approach", 2 * speed * size.approach},
          {"duration", 2 * speed * size.duration},
          {"force", 2 * speed * size.force}};
}

}  // namespace

Finding contact_meetings(const Scene& scene) {
  Finding found = meeting_table();
  for (const Body& body : scene.bodies)
    for (const Meeting& meeting : touchdown(scene, body).meetings) {
      const ContactPair& pair = scene.contacts[meeting.contact];
      const ContactSize& size = meeting.size;
      const bool lumped = pair.law == ContactLaw::hertz;
      found.rows.push_back({pair.obstacle, lumped ? "hertz, lumped [N/m^1.5]" : "penalty per area", size.stiffness,
                            pair.stiffness != 0 ? "given" : "auto", size.modulus, size.radius,
                            lumped ? not_applicable() : number(size.stiffness * size.radius / size.modulus), meeting.t,
                            size.speed, size.approach, size.duration, size.force});
      bar_last_row(found, bars_of_meeting(meeting, extent(body.shape), scene.gravity.norm()));
    }
  return found;
}

namespace {

void add_geometry(Finding& found, const ContactContender& of, const FloatingBasis& basis) {
  const Regression& fit = basis.geometry;
  double square = 0, worst = 0, largest = 0, kept = 0;
  for (const ModeFit& mode : fit.modes) {
    square += mode.residual * mode.residual;
    worst = std::max(worst, mode.residual);
    largest = std::max(largest, mode.largest_residual);
    kept += static_cast<double>(mode.n_kept);
  }
  const double n = static_cast<double>(fit.modes.size());
  Index n_samples = 0;
  for (const SampledContact& contact : basis.body.contacts) n_samples += contact.samples.w.size();
  found.rows.push_back({basis.scene->bodies[basis.place].name, of.method, n, count(fit.basis.monomials().degree()),
                        3 * n * static_cast<double>(fit.n_monomials), kept, fit.condition,
                        n > 0 ? std::sqrt(square / n) : 0, worst, largest, count(basis.body.n_static()),
                        count(n_samples)});
}

}  // namespace

Finding contact_geometry(const std::vector<ContactBasis>& bases) {
  Finding found = geometry_table();
  for (const auto& [of, every] : bases)
    for (const FloatingBasis& basis : *every) add_geometry(found, of, basis);
  return found;
}

}  // namespace mb
