#include "modal/contact/sample_tables.h"

#include <cmath>

namespace mb {

SampleTables sample_tables(const SurfaceSamples& samples) {
  return {samples.Phi.transpose(), samples.Psi.transpose(), largest_displacements(samples.Phi),
          largest_displacements(samples.Psi)};
}

std::shared_ptr<const SampleTables> tables_of(const SampledContact& contact) {
  return contact.tables ? contact.tables : std::make_shared<const SampleTables>(sample_tables(contact.samples));
}

VectorXd largest_displacements(const MatrixXd& shapes) {
  VectorXd largest(shapes.cols());
  for (Index k = 0; k < shapes.cols(); ++k)
    largest[k] = shapes.rows() == 0
                     ? 0
                     : std::sqrt(shapes.col(k).reshaped(3, shapes.rows() / 3).colwise().squaredNorm().maxCoeff());
  return largest;
}

}  // namespace mb
