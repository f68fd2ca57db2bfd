// The visible list of what competes: methods (which system is stepped) and integrators (how). A new one is one line in
// catalogue.cc; an outside project appends its own and calls harness_main.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cases/contract/method.h"
#include "cases/scene/read_toml.h"

namespace mb {

struct Catalogue {
  std::vector<std::shared_ptr<const Method>> methods;
  std::vector<Integrator> integrators;

  const Method& method(const std::string& name) const;          // throws std::out_of_range naming it
  const Integrator& integrator(const std::string& name) const;  // likewise
  Vocabulary vocabulary() const;                                // names a case file may use
};

Catalogue default_catalogue();

}  // namespace mb
