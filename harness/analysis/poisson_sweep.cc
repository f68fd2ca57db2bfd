#include "harness/analysis/poisson_sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <variant>

#include "harness/analysis/modal_body.h"
#include "modal/bases/eigenmodes.h"

namespace mb {

namespace {

constexpr int highest_degree = 4;

SweptAnswer answer(const Scene& scene, double nu, const Resolution& mesh) {
  auto changed = std::make_shared<Scene>(scene);
  Body& body = changed->bodies.front();
  body.material.poissons_ratio = nu;
  const Model model = model_of_own_mesh(changed, mesh);
  const BodyModel& modelled = model.bodies.front();
  const System& system = modelled.full->system();
  const ShiftedFactor shifted = shifted_factor(system, physical_shift(body));
  const VectorXd u = inertia_relief(system, shifted, system.F).rowwise().sum();
  if (!(u.norm() > 0)) throw std::invalid_argument("locking is swept over loads that deform the body");
  const Modes modes = lowest_modes(system, 1, shifted);
  const Index n_volume = modelled.points.volume.points.cols();
  return {mesh, system.M.rows(), (modelled.displacement * u).head(3 * n_volume), modes.omega(modes.n_rigid) / (2 * pi)};
}

// As many nodes along each edge at another degree.
Resolution with_degree(const Resolution& own, int degree) {
  Resolution mesh{degree, {}};
  for (const int n : own.cells)
    mesh.cells.push_back(std::max(1, static_cast<int>(std::lround(1.0 * n * own.degree / degree))));
  return mesh;
}

void require_sweep_possible(const Body& body) {
  if (!std::holds_alternative<Box>(body.shape) || !is_uniform(body.material) || body.theory != Theory::solid)
    throw std::invalid_argument("locking is swept over boxes of one isotropic material");
}

}  // namespace

PoissonSweep poisson_sweep(const Scene& scene, const std::vector<double>& ratios) {
  const Body& body = scene.bodies.front();
  require_sweep_possible(body);
  Resolution beside = of_body(scene.truth.finer, 0), finest;
  beside.degree = highest_degree;
  finest = beside;
  for (int& n : finest.cells) n = (3 * n + 1) / 2;
  PoissonSweep all{ratios, evaluation_points(scene, body).volume.weights, {}, {}, {}};
  for (const double nu : ratios) {
    if (!(nu > -1 && nu < 0.5)) throw std::invalid_argument(fmt::format("locking: Poisson's ratio {}", nu));
    all.truths.push_back(answer(scene, nu, finest));
    all.beside.push_back(answer(scene, nu, beside));
    for (int degree = 1; degree < highest_degree; ++degree)
      all.answers[degree].push_back(answer(scene, nu, with_degree(body.resolution, degree)));
  }
  return all;
}

LockingError locking_error(const SweptAnswer& answer, const SweptAnswer& truth, const VectorXd& weights) {
  const VectorXd w = weights.replicate(1, 3).transpose().reshaped();
  return {std::sqrt((answer.u - truth.u).cwiseAbs2().dot(w) / truth.u.cwiseAbs2().dot(w)),
          answer.hertz / truth.hertz - 1};
}

}  // namespace mb
