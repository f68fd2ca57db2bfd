#include "modal/methods/truncation.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "modal/bases/eigenmodes.h"
#include "modal/methods/projection.h"

namespace mb {

std::unique_ptr<Prepared> prepare_truncated(const Model& model, const Settings& settings, const Integrator& integrator,
                                            bool corrected) {
  if (settings.modes < 0) throw std::invalid_argument(fmt::format("{} modes asked for", settings.modes));
  std::vector<LinearBody> bodies;
  int modes_used = 0;  // of the body that uses most
  for (size_t i = 0; i < model.bodies.size(); ++i) {
    const ShiftedFactor shifted =
        shifted_factor(model.bodies[i].full->system(), physical_shift(model.scene->bodies.at(i)));
    ReducedBody reduced = reduce(model.bodies[i], shifted, settings.modes, corrected);
    modes_used = std::max(modes_used, reduced.n_elastic);
    bodies.push_back(std::move(reduced.body));
  }
  return prepare_linear(std::move(bodies), integrator, settings, model.scene->duration, modes_used);
}

}  // namespace mb
