#include "harness/analysis/reduced_answers.h"

#include "modal/methods/projection.h"

namespace mb {

ReducedAnswers::ReducedAnswers(const AnalysisContext& context, int n_elastic)
    : context_(context),
      body_(modal_body(context, n_elastic)),
      static_response_(inertia_relief(body_.system, body_.shifted, body_.system.F)) {}

Trajectory ReducedAnswers::answer(const std::string& method, const Integrator& integrator,
                                  const Settings& settings) const {
  const Scene& scene = *context_.scene;
  const Sampling sampling{.t = sample_times(scene)};
  if (method != "eigenmodes" && method != "static-correction")
    return context_.catalogue.method(method).prepare(body_.scene_model, settings, integrator)->simulate(sampling);
  const Modes modes = leading(body_.modes, settings.modes);
  const bool corrected = method == "static-correction";
  const MatrixXd rest =
      corrected ? residual_flexibility(modes, body_.system.F, static_response_) : MatrixXd(body_.system.F.rows(), 0);
  const auto observed = [&](const SparseMatrix& at_points) {
    return Observation{.of_state = MatrixXd(at_points * modes.Phi), .of_load = MatrixXd(at_points * rest)};
  };
  std::vector<LinearBody> bodies;
  bodies.push_back({project(body_.system, modes), observed(body_.model.displacement), observed(body_.model.strain)});
  const int used = static_cast<int>(modes.size() - modes.n_rigid);
  return prepare_linear(std::move(bodies), integrator, settings, scene.duration, used)->simulate(sampling);
}

}  // namespace mb
