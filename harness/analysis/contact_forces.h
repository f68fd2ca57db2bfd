// Tables of the contest of contact forces (contact_contest.h) and the verdict on claim C12; their columns stand in
// analyses.h.
#pragma once

#include "harness/analysis/analysis.h"
#include "harness/analysis/contact_contest.h"

namespace mb {

struct ContactSizes {
  std::vector<double> depths;  // [-] of the least half extent
  std::vector<int> edges;      // even; samples: about 6 k^2
  int n_orientations;
};
ContactSizes usual_contact_sizes();

// Of the body, if it is a sphere or a superquadric, else of the sphere of its size; and of the superquadric of its
// size.
std::vector<Finding> contact_forces(const Shape& body, const ContactSizes& sizes);

// Gains: error of vertices over that of the analytic contender, each > 1 where that is more accurate.
std::string contact_verdict(const std::vector<double>& gains);

}  // namespace mb
