// The truth of a case and how far it may be off:
//
//   error bar of a metric =
//     against `finer`       F distance(finer, coarser) + distance(rtol, rtol/100 on the body's mesh) + s d
//                           or the distance to `exact` less its own bar, where that is more; s: Metric::per_mass x size
//     against `same_mesh`   distance(rtol, rtol/100 on the body's mesh)
//     against `exact`       relative error of the closed form's series x size of the truth in this metric
//
// Distances are taken in the metric's own measure; F: what that of two meshes tells (mesh_bar.h).
// d = max(0, d_f - |d_c - d_f|), d_h = |1 - V_h/V|, V_h: volume of the finer and of the coarser mesh, V of the shapes:
// what both lack of it, and of mass, no distance between them shows, and graded ones lack about as
// much. Size (Metric::size): 1 where a metric is relative to the whole truth, the largest displacement [m] for
// positions, that over the radius of gyration [rad] for rotations, the same to a probe's own signal for probes. Truths
// but the exact one are full order, stepped by SUNDIALS, and cached in the store.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "cases/contract/modes.h"
#include "cases/contract/record.h"
#include "harness/catalogue.h"
#include "harness/metrics/metric.h"
#include "harness/store/store.h"
#include "harness/study/mesh_bar.h"

namespace mb {

struct TruthSet {
  Trajectory finer, coarser;        // scene.truth.finer and its neighbour, at the scene's tolerance
  Trajectory same_mesh, loose;      // the body's mesh at a hundredth of the tolerance, and at the tolerance itself
  std::optional<Trajectory> exact;  // where the scene names a closed form
  double exact_bar = 0;             // [-] of its series, relative to its largest displacement
  double missing_volume = 0;        // [-] that both meshes lack
  PerDistance per_distance{safety_of_meshes};  // of `coarser` and `finer`
  const Trajectory& of(TruthKind kind) const;  // throws std::logic_error where there is none of that kind
};

using Progress = std::function<void(const std::string& line)>;

// What full-order models find their modes with where a scene states damping ratios: a ModeSolver.
Modes modes_of_a_mesh(const System& system, const Body& body, int n_elastic);

// Full-order models as the suite makes them: where a scene states damping ratios, with the modes of the mesh itself.
Model make_model(const std::shared_ptr<const Scene>& scene, const Resolution& resolution);

// Reads each from the store or computes it, two at a time. Throws std::runtime_error where an integration fails and,
// before anything is allocated, where what is to be read and computed is estimated to take more memory than there is or
// what is not stored would be more than a file of the store takes (storable.h); damaged files of the store are reported
// through progress and computed again. interrupted is asked before each is begun, from the thread that calls: nothing
// is returned where it said so, those that were done stand in the store.
std::optional<TruthSet> truths(const std::shared_ptr<const Scene>& scene, const Catalogue& catalogue,
                               const Store& store, const Progress& progress, const std::function<bool()>& interrupted);

// Reads all that the store has of a scene, and tells what is wrong with any.
void name_damaged_truths(const Scene& scene, const Store& store, const Progress& progress);

// Of a small value; of larger ones that are relative to the truth more (Metric::relative).
double error_bar(const Metric& metric, const TruthSet& truth, TruthKind kind, const MetricContext& context);

}  // namespace mb
