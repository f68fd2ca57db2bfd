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

// In the first n modes, corrected, in closed form.
std::unique_ptr<Prepared> corrected(const AnalysisContext& context, const ModalBody& body, Index n) {
  Modes kept = body.modes;
  kept.omega.conservativeResize(n);
  kept.Phi.conservativeResize(Eigen::NoChange, n);
  const MatrixXd G_F = inertia_relief(body.system, body.shifted, body.system.F);
  std::vector<LinearBody> bodies;
  bodies.push_back(reduce(body.model, kept, residual_flexibility(kept, body.system.F, G_F)));
  const Scene& scene = *context.scene;
  Settings settings;
  settings.load_tolerance = scene.study.load_tolerance;
  return prepare_linear(std::move(bodies), context.catalogue.integrator("exact"), settings, scene.duration,
                        static_cast<int>(n - kept.n_rigid));
}

}  // namespace

RecordedMotions recorded_motions(const AnalysisContext& context, int n_elastic, double f) {
  const Scene& scene = *context.scene;
  ModalBody body = body_reaching(context, n_elastic, 2 * pi * f);
  const VectorXd& w = body.model.points.volume.weights;
  VectorXd scale = (scene.bodies.front().material.density * w.replicate(1, 3).transpose().reshaped()).cwiseSqrt();
  const SparseMatrix at_points = scale.asDiagonal() * body.model.displacement.topRows(scale.size());
  MatrixXd rigid = is_free(context) ? MatrixXd(at_points * body.system.R) : MatrixXd(scale.size(), 0);

  const Trajectory& truth = context.truth.same_mesh;
  const MatrixXd x = without_rigid(scale.asDiagonal() * truth.bodies.front().displacement.topRows(scale.size()), rigid);
  auto reduced = std::make_unique<System>(project(body.system, body.modes));
  auto stepper = exact(*reduced, scene.duration, scene.study.load_tolerance);
  Recording modal{without_rigid(at_points * body.modes.Phi, rigid),
                  PaddedSpectrum(stepper->run(truth.t).u, scene.samples_per_second)};
  VectorXd zeta = damping_ratios(body.system, body.modes);
  return {truth.t,
          std::move(body),
          std::move(scale),
          std::move(rigid),
          recording(x, VectorXd::Ones(x.rows()), scene.samples_per_second),
          std::move(modal),
          std::move(zeta),
          std::move(reduced),
          std::move(stepper)};
}

CorrectedMotion::CorrectedMotion(const AnalysisContext& context, const RecordedMotions& motions, Index n)
    : motions_(motions),
      prepared_(corrected(context, motions.body, n)),
      samples_(
          recording(shown(motions.t, 0), VectorXd::Ones(motions.scale.size()), context.scene->samples_per_second)) {}

MatrixXd CorrectedMotion::shown(const VectorXd& t, double shutter) const {
  const Trajectory answer = prepared_->simulate({.t = t, .strain = false, .shutter = shutter});
  const VectorXd& scale = motions_.scale;
  return without_rigid(scale.asDiagonal() * answer.bodies.front().displacement.topRows(scale.size()), motions_.rigid);
}

}  // namespace mb
