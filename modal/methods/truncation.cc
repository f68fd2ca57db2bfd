#include "modal/methods/truncation.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "modal/bases/eigenmodes.h"
#include "modal/contact/floating_answer.h"
#include "modal/methods/projection.h"

namespace mb {

Reduction in_eigenmodes(const Model& model, const Settings& settings, bool corrected) {
  if (settings.modes < 0) throw std::invalid_argument(fmt::format("{} modes asked for", settings.modes));
  Reduction reduction{{}, 0};
  std::vector<Modes> all;
  for (size_t i = 0; i < model.bodies.size(); ++i) {
    const BodyModel& body = model.bodies[i];
    const System& system = body.full->system();
    const ShiftedFactor shifted = shifted_factor(system, physical_shift(model.scene->bodies.at(i)));
    const Modes modes = lowest_modes(system, settings.modes, shifted);
    const MatrixXd correction = corrected
                                    ? residual_flexibility(modes, system.F, inertia_relief(system, shifted, system.F))
                                    : MatrixXd(system.F.rows(), 0);
    reduction.bodies.push_back(reduce(body, modes, correction));
    reduction.modes_used = std::max(reduction.modes_used, static_cast<int>(modes.size() - modes.n_rigid));
    all.push_back(modes);
  }
  answer_in_frames(reduction, model, all, corrected);
  return reduction;
}

}  // namespace mb
