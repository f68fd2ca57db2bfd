#include "harness/analysis/recorded_motions.h"

#include <algorithm>
#include <cmath>

#include "mechanics/system/exact.h"
#include "modal/bases/eigenmodes.h"
#include "modal/methods/projection.h"

namespace mb {

namespace {

ModalBody body_reaching(const AnalysisContext& context, int n_elastic, double omega) {
  ModalBody body = modal_body(context, n_elastic);
  const double reached = body.modes.omega(body.modes.size() - 1);
  const int most = std::min(256, static_cast<int>(body.system.K.rows() / 3));
  if (reached >= omega || n_elastic >= most) return body;
  // The number of modes below omega grows at most as its cube (Weyl 1911, Math. Ann. 71); from few modes by guess.
  const double more = std::max(16.0, 1.2 * n_elastic * std::pow(omega / reached, 3));
  body.modes = lowest_modes(body.system, static_cast<int>(std::min<double>(most, more)), body.shifted);
  return body;
}

MatrixXd without_rigid(const MatrixXd& x, const MatrixXd& rigid) {
  if (rigid.cols() == 0) return x;
  return x - rigid * (rigid.transpose() * rigid).ldlt().solve(rigid.transpose() * x);
}

}  // namespace

RecordedMotions recorded_motions(const AnalysisContext& context, int n_elastic, double f) {
  const Scene& scene = *context.scene;
  const ModalBody body = body_reaching(context, n_elastic, 2 * pi * f);
  const VectorXd& w = body.model.points.volume.weights;
  const VectorXd scale = (scene.bodies.front().material.density * w.replicate(1, 3).transpose().reshaped()).cwiseSqrt();
  const SparseMatrix at_points = scale.asDiagonal() * body.model.displacement.topRows(scale.size());
  const MatrixXd rigid = is_free(context) ? MatrixXd(at_points * body.system.R) : MatrixXd(scale.size(), 0);

  const Trajectory& truth = context.truth.same_mesh;
  const MatrixXd x = without_rigid(scale.asDiagonal() * truth.bodies.front().displacement.topRows(scale.size()), rigid);
  auto reduced = std::make_unique<System>(project(body.system, body.modes));
  auto stepper = exact(*reduced, scene.duration, scene.study.load_tolerance);
  Recording modal{without_rigid(at_points * body.modes.Phi, rigid),
                  PaddedSpectrum(stepper->run(truth.t).u, scene.samples_per_second)};
  return {truth.t,
          recording(x, VectorXd::Ones(scale.size()), scene.samples_per_second),
          std::move(modal),
          body.modes,
          damping_ratios(body.system, body.modes),
          std::move(reduced),
          std::move(stepper)};
}

}  // namespace mb
