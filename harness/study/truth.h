// The truth of a case and how far it may be off:
//
//   error bar of a metric = distance(finer, coarser) + distance(rtol, rtol/100 on the body's mesh)      against `finer`
//                           distance(rtol, rtol/100 on the body's mesh)                                  against
//                           `same_mesh`
//
// Distances are taken in the metric's own measure. Truths are full order, stepped by SUNDIALS, and cached in the store.
#pragma once

#include <functional>
#include <string>

#include "cases/contract/record.h"
#include "harness/catalogue.h"
#include "harness/metrics/metric.h"
#include "harness/store/store.h"

namespace mb {

struct TruthSet {
  Trajectory finer, coarser;    // scene.truth.finer and its neighbour, at the scene's tolerance
  Trajectory same_mesh, loose;  // the body's mesh at a hundredth of the tolerance, and at the tolerance itself
  const Trajectory& of(TruthKind kind) const { return kind == TruthKind::finer ? finer : same_mesh; }
};

using Progress = std::function<void(const std::string& line)>;

// Reads each from the store or computes it, two at a time. Throws std::runtime_error where an integration fails;
// damaged files of the store are reported through progress and computed again.
TruthSet truths(const std::shared_ptr<const Scene>& scene, const Catalogue& catalogue, const Store& store,
                const Progress& progress);

double error_bar(const Metric& metric, const TruthSet& truth, TruthKind kind, const MetricContext& context);

}  // namespace mb
