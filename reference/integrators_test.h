// For tests: integrators as the catalogue has them, which stands above this folder.
#pragma once

#include "cases/contract/method.h"
#include "mechanics/contact/contact_steppers.h"
#include "mechanics/system/newmark.h"
#include "reference/sundials/sundials.h"

namespace mb::testing {

inline Integrator arkode() {
  return {"sundials",
          "",
          [](const System& s, const Settings& set, double T) { return sundials(s, set.relative_tolerance, T); },
          Integrator::Knob::tolerance,
          false,
          [](const System& s, const std::vector<Contact>& c, const Settings& set, double T) {
            return sundials(s, c, set.relative_tolerance, T);
          }};
}

inline Integrator average_acceleration() {
  return {"newmark",
          "",
          [](const System& s, const Settings& set, double) { return newmark(s, set.time_step); },
          Integrator::Knob::time_step,
          false,
          [](const System& s, const std::vector<Contact>& c, const Settings& set, double) {
            return newmark(s, c, set.time_step);
          }};
}

using ContactSteps = std::unique_ptr<Stepper>(const System&, const std::vector<Contact>&, double h);

template <ContactSteps* steps = &central_difference>
Integrator explicit_steps() {
  return {"explicit",
          "",
          [](const System&, const Settings&, double) { return std::unique_ptr<Stepper>(); },
          Integrator::Knob::time_step,
          true,
          [](const System& s, const std::vector<Contact>& c, const Settings& set, double) {
            return steps(s, c, set.time_step);
          }};
}

}  // namespace mb::testing
