// What every run looks up of a contact's samples, made once for all runs of a body: what belongs to a sample stands
// together.
#pragma once

#include "modal/frame/floating_body.h"

namespace mb {

struct SampleTables {
  MatrixXd Phi, Psi;              // r x 3 m, n_s x 3 m: the samples' own, transposed
  VectorXd largest_q, largest_s;  // r, n_s: max_i |Phi_ik|, max_i |Psi_ik|
};

SampleTables sample_tables(const SurfaceSamples& samples);
// The contact's own if it has them, else made.
std::shared_ptr<const SampleTables> tables_of(const SampledContact& contact);

// Bounds of each shape's displacement over all samples: max_i |Phi_ik|; shapes 3 m x r.
VectorXd largest_displacements(const MatrixXd& shapes);

}  // namespace mb
