// The error budget of scenes with contact, body by body:
//
//   modal(h) -> modal(h/4) -> modes on the mesh's surface -> static shapes with mass -> full order, same mesh, linear
//     -> finer, linear -> finite
//
// Floating frames and points of the exact shape become small rotations and points of the mesh's surface in the second
// link (ContactVariants::prepare_on_mesh); the third is of static-correction alone, the last of scenes with a finite
// body. Links which linear kinematics cannot carry, as of a body that spins, are merged with their neighbours.
#pragma once

#include "harness/analysis/analysis.h"

namespace mb {

std::vector<Finding> contact_budget(const AnalysisContext& context);  // part of error_budget

}  // namespace mb
