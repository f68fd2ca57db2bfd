// What nearly incompressible material does to elements of each degree: the body's static answer and its first frequency
// over Poisson's ratio, meshes of about as many unknowns,
//
//   static error = |u_p - u| / |u| in the M norm,   frequency error = f_p / f - 1,   u, f: degree 4 on the finer mesh
//
// Hughes 1987, The Finite Element Method, ch. 4: trilinear elements lock, their error grows without bound as nu -> 1/2.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "harness/analysis/analyses.h"
#include "harness/analysis/modal_body.h"
#include "modal/bases/eigenmodes.h"

namespace mb {

namespace {

constexpr double ratios[] = {0.3, 0.49, 0.499, 0.4999};  // [-] Poisson's
constexpr int highest_degree = 4;

Finding locking_table() {
  return table(
      "locking", "locking", "Static answers and first frequencies over Poisson's ratio",
      "The body with other ratios of Poisson, on meshes of about as many unknowns as its own. Truth: elements "
      "of degree 4 on the cells of the finer mesh, halved. Static error: displacement under all loads at their "
      "full size, M norm; frequency error: of the first elastic mode, positive where the mesh is too stiff.",
      {{"element", ""}, {"nu", "-"}, {"cells", ""}, {"unknowns", ""}, {"static error", "-"}, {"frequency error", "-"}});
}

Finding growth_table() {
  return table("locking", "locking-growth", "What the ratio 0.4999 does to elements of each degree",
               "Errors of the table before at the smallest and the largest ratio, and the one over the other: 1 does "
               "not lock.",
               {{"element", ""},
                {"static error at 0.3", "-"},
                {"static error at 0.4999", "-"},
                {"growth of static error", "-"},
                {"frequency error at 0.3", "-"},
                {"frequency error at 0.4999", "-"},
                {"growth of frequency error", "-"}});
}

struct Answer {
  VectorXd u;    // [m] at the evaluation points
  double hertz;  // [1/s] first elastic mode
  Index n;       // unknowns
};

Answer answer(const Scene& scene, double nu, const Resolution& mesh) {
  auto changed = std::make_shared<Scene>(scene);
  Body& body = changed->bodies.front();
  body.material.poissons_ratio = nu;
  const Model model = make_model(changed, mesh);
  const BodyModel& modelled = model.bodies.front();
  const System& system = modelled.full->system();
  const ShiftedFactor shifted = shifted_factor(system, physical_shift(body));
  const VectorXd u = inertia_relief(system, shifted, system.F).rowwise().sum();
  const Modes modes = lowest_modes(system, 1, shifted);
  const Index n_volume = modelled.points.volume.points.cols();
  return {(modelled.displacement * u).head(3 * n_volume), modes.omega(modes.n_rigid) / (2 * pi), system.M.rows()};
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

double relative_error(const VectorXd& u, const VectorXd& truth, const VectorXd& weights) {
  const VectorXd w = weights.replicate(1, 3).transpose().reshaped();
  return std::sqrt((u - truth).cwiseAbs2().dot(w) / truth.cwiseAbs2().dot(w));
}

}  // namespace

std::vector<Finding> locking(const AnalysisContext& context) {
  const Scene& scene = *context.scene;
  const Body& body = scene.bodies.front();
  require_sweep_possible(body);
  Resolution finest = of_body(scene.truth.finer, 0);
  finest.degree = highest_degree;
  for (int& n : finest.cells) n *= 2;
  const EvaluationPoints points = evaluation_points(scene, body);
  Finding all = locking_table(), growth = growth_table();
  std::map<int, std::vector<Vector3d>> errors;  // by degree, one a ratio: static, frequency
  for (const double nu : ratios) {
    const Answer truth = answer(scene, nu, finest);
    for (int degree = 1; degree < highest_degree; ++degree) {
      const Resolution mesh = with_degree(body.resolution, degree);
      const Answer found = answer(scene, nu, mesh);
      const double of_u = relative_error(found.u, truth.u, points.volume.weights), of_f = found.hertz / truth.hertz - 1;
      errors[degree].push_back({of_u, of_f, 0});
      all.rows.push_back({fmt::format("Q{}", degree), nu, to_string(mesh), count(found.n), of_u, of_f});
    }
  }
  for (const auto& [degree, over] : errors) {
    const Vector3d first = over.front(), last = over.back();
    growth.rows.push_back(
        {fmt::format("Q{}", degree), first[0], last[0], last[0] / first[0], first[1], last[1], last[1] / first[1]});
  }
  return {all, growth};
}

}  // namespace mb
