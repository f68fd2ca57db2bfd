#include "cases/exact/exact.h"

#include <stdexcept>

#include "cases/exact/rod_step.h"
#include "cases/exact/sphere_pulse.h"
#include "cases/exact/struck_beam.h"
#include "cases/exact/struck_plate.h"
#include "cases/exact/thrown_rod.h"
#include "cases/exact/thrown_sphere.h"

namespace mb {

const std::vector<ExactSolution>& exact_solutions() {
  static const std::vector<ExactSolution> solutions = {rod_step(),     sphere_radial_pulse(), struck_beam(),
                                                       struck_plate(), thrown_sphere(),       thrown_rod()};
  return solutions;
}

const ExactSolution& exact_solution(const std::string& name) {
  for (const ExactSolution& solution : exact_solutions())
    if (solution.name == name) return solution;
  throw std::out_of_range("no closed form is called " + name);
}

}  // namespace mb
