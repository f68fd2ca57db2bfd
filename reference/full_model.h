// Full order: a body of the scene on hexahedra of degree 1 to 4 with curved boundary mapping (deal.II), consistent
// mass, full Gauss quadrature, supports and the hanging nodes of graded meshes condensed:
//
//   u_full = T u,   M = T^T M_full T,   K = T^T K_full T,   F = T^T F_full
//
// and so the lumped mass, T^T m_full T: positive definite for positive m_full whatever the weights in T, but diagonal
// only where no nodes hang.
//
// With driven supports u is relative to the moving base, on which all supports of the body ride: F has one more column,
// after the scene's loads, -T^T M_full r with r the rigid translation along the drive at all nodes, and s its
// acceleration.
#pragma once

#include <functional>
#include <memory>

#include "cases/contract/model.h"
#include "cases/contract/modes.h"

namespace mb {

// The lowest elastic modes of a system, at least as many as asked for: where a scene states damping ratios mode by
// mode, full order needs the modes of its own mesh (System::modal_damping), and gets them from who knows how to.
using ModeSolver = std::function<Modes(const System& system, const Body& body, int n_elastic)>;

// Mesh and matrices of one body of the scene at the resolution given; of a body of beam or plate theory its sine modes
// (theory/theory_model.h). Throws std::invalid_argument for supports which leave nothing free or contradict each other,
// discs off their face, resolutions out of range, graded ones of a body without contact, and damping ratios without a
// solver. Damping ratios beyond the last one given, in the rest of a multiplet, are the last one's.
std::shared_ptr<const FullModel> full_model(const Scene& scene, const Body& body, const Resolution& resolution,
                                            const ModeSolver& modes = {});

// Every body of the scene, with its observation at the evaluation points. resolution: of the whole scene, in the place
// of the bodies' own; one without contact takes it ungraded.
Model build_model(std::shared_ptr<const Scene> scene, const Resolution* resolution = nullptr,
                  const ModeSolver& modes = {});

// [-] sum over the bodies of |1 - V_h/V|, V the volume of the shape, V_h of its mesh: what that lacks of mass, too.
double missing_volume(const Scene& scene, const Resolution& resolution);

}  // namespace mb
