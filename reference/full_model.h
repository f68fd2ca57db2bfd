// Full order: a body of the scene on hexahedra of degree 1 to 4 with curved boundary mapping (deal.II), consistent
// mass, full Gauss quadrature, supports condensed:
//
//   u_full = T u,   M = T^T M_full T,   K = T^T K_full T,   F = T^T F_full
#pragma once

#include <memory>

#include "cases/contract/model.h"

namespace mb {

// Mesh and matrices of one body of the scene at the resolution given. Throws std::invalid_argument for supports which
// leave nothing free or patches that touch no quadrature point.
std::shared_ptr<const FullModel> full_model(const Scene& scene, const Body& body, const Resolution& resolution);

// Every body of the scene, with its observation at the evaluation points. resolution: overrides that of every body.
Model build_model(std::shared_ptr<const Scene> scene, const Resolution* resolution = nullptr);

}  // namespace mb
