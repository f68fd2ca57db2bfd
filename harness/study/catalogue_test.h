// Catalogues for tests of what goes wrong: a contender that throws, truths that do.
#pragma once

#include <stdexcept>

#include "harness/catalogue.h"

namespace mb {

// The reduced method "breaks" takes no mode count and throws when it is prepared.
class Breaks : public Method {
 public:
  std::string name() const override { return "breaks"; }
  std::string doc() const override { return "for tests"; }
  bool takes_modes() const override { return false; }
  std::unique_ptr<Prepared> prepare(const Model&, const Settings&, const Integrator&) const override {
    throw std::runtime_error("broken on purpose");
  }
};

inline Catalogue with_a_method_that_breaks() {
  Catalogue catalogue = default_catalogue();
  catalogue.methods.push_back(std::make_shared<Breaks>());
  return catalogue;
}

// What every truth is stepped with, done otherwise.
inline Catalogue with_sundials(decltype(Integrator::prepare) prepare) {
  Catalogue catalogue = default_catalogue();
  for (Integrator& integrator : catalogue.integrators)
    if (integrator.name == "sundials") integrator.prepare = prepare;
  return catalogue;
}

inline std::unique_ptr<Stepper> broken_sundials(const System&, const Settings&, double) {
  throw std::runtime_error("no truth on purpose");
}

}  // namespace mb
