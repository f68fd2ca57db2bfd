// How far linear theory is off, estimated from the stored energy alone (beyond_linear.h) and measured against finite
// deformation. Estimate = |v2 + v3| / |u|, in the M norm over the scene's samples.
#include <cmath>
#include <stdexcept>

#include "cases/contract/linear_limits.h"
#include "harness/analysis/analyses.h"
#include "harness/analysis/beyond_linear.h"
#include "harness/analysis/modal_body.h"
#include "harness/metrics/linearity.h"
#include "harness/metrics/signal.h"
#include "modal/methods/projection.h"

namespace mb {

namespace {

constexpr int most_modes = 16;
constexpr Index most_times = 40;

Finding linearity_table() {
  return table(
      "linearity", "linearity", "How far linear theory is off",
      "Of the body's modes under the scene's loads, at up to forty of its samples. Strain and rotation: the "
      "largest of the linear answer. Estimate: the first two terms beyond linear theory of a perturbation "
      "series, each static, from the stored energy. Error: of the linear answer against the finite truth. "
      "Bars: twice the distance to the same on the finer mesh of the case, its own finite truth with it, more where "
      "errors of strain need not fall to half, and the distance to a truth of ten times the tolerance. Verdict: "
      "whether strain or rotation is beyond what is taken without a warning.",
      {{"modes r", ""},
       {"largest strain", "-"},
       {"largest rotation", "rad"},
       {"second order", "-"},
       {"third order", "-"},
       {"estimate", "-"},
       {"error", "-"},
       {"estimate over error", "-"},
       {"verdict", ""}});
}

// Every n-th sample, none of those at which nothing has moved yet.
std::vector<Index> few_samples(const MatrixXd& u) {
  std::vector<Index> moved, picked;
  const double largest = u.cwiseAbs().maxCoeff();
  for (Index k = 0; k < u.cols(); ++k)
    if (u.col(k).cwiseAbs().maxCoeff() > 1e-3 * largest) moved.push_back(k);
  const auto n = static_cast<Index>(moved.size()), step = std::max<Index>(1, n / most_times);
  for (Index k = 0; k < n; k += step) picked.push_back(moved[static_cast<size_t>(k)]);
  return picked;
}

struct LinearAnswer {
  MatrixXd u;            // [m] n x times, all unknowns of the mesh
  Trajectory at_points;  // displacement and strain
};
LinearAnswer linear_answer(const AnalysisContext& context, const ModalBody& body) {
  const Scene& scene = *context.scene;
  Settings settings;
  settings.load_tolerance = scene.study.load_tolerance;
  const VectorXd times = sample_times(scene);
  const States states = context.catalogue.integrator("exact")
                            .prepare(project(body.system, body.modes), settings, scene.duration)
                            ->run(times);
  LinearAnswer answer{body.modes.Phi * states.u, {}};
  answer.at_points.t = times;
  answer.at_points.bodies.resize(1);
  answer.at_points.bodies[0].displacement = body.model.displacement * answer.u;
  answer.at_points.bodies[0].strain = body.model.strain * answer.u;
  return answer;
}

}  // namespace

std::vector<Finding> linearity(const AnalysisContext& context) {
  const Scene& scene = *context.scene;
  const Body& scene_body = scene.bodies.front();
  const ModalBody body = modal_body(context, std::min(mode_counts(context).back(), most_modes));
  if (!body.system.stored_energy || !is_held(scene_body))
    throw std::invalid_argument("linearity is told of bodies of kinematics 'finite' that supports hold");
  const auto [u, linear] = linear_answer(context, body);
  const MatrixXd gap = linear.bodies[0].displacement - context.truth.same_mesh.bodies.front().displacement;
  const VectorXd w = body.model.points.volume.weights.replicate(1, 3).transpose().reshaped();
  const auto squared = [&](const VectorXd& at_points) { return at_points.head(w.size()).cwiseAbs2().dot(w); };
  double of_u = 0, of_2 = 0, of_3 = 0, of_sum = 0, of_error = 0;
  for (const Index k : few_samples(u)) {
    const BeyondLinear t = beyond_linear(body.system, body.shifted, u.col(k), extent(scene_body.shape));
    of_u += squared(linear.bodies[0].displacement.col(k));
    of_2 += squared(body.model.displacement * t.v2);
    of_3 += squared(body.model.displacement * t.v3);
    of_sum += squared(body.model.displacement * (t.v2 + t.v3));
    of_error += squared(gap.col(k));
  }
  if (!(of_u > 0)) throw std::invalid_argument("linearity: nothing moves");
  const MetricContext metric{scene, 0, body.model.points, false};
  const double strain = largest_strain(linear, metric), rotation = largest_rotation(linear, metric);
  const bool warned = strain > strain_limit || rotation > rotation_limit;
  Finding found = linearity_table();
  found.rows.push_back({count(body.modes.size()), strain, rotation, std::sqrt(of_2 / of_u), std::sqrt(of_3 / of_u),
                        std::sqrt(of_sum / of_u), std::sqrt(of_error / of_u), std::sqrt(of_sum / of_error),
                        warned ? "beyond linear theory" : "within linear theory"});
  return {found};
}

}  // namespace mb
