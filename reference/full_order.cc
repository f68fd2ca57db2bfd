#include "reference/full_order.h"

#include "cases/contract/linear.h"

namespace mb {

namespace {

class FullOrder final : public Method {
 public:
  std::string name() const override { return "full-order"; }
  std::string doc() const override { return "every degree of freedom of the mesh (identity basis)"; }
  bool takes_modes() const override { return false; }
  std::unique_ptr<Prepared> prepare(const Model& model, const Settings& settings,
                                    const Integrator& integrator) const override {
    std::vector<LinearBody> bodies;
    for (const BodyModel& body : model.bodies)
      bodies.push_back({body.full->system(), {body.displacement, {}}, {body.strain, {}}});
    return prepare_linear(std::move(bodies), integrator, settings, model.scene->duration, -1);
  }
};

}  // namespace

std::unique_ptr<Method> full_order() { return std::make_unique<FullOrder>(); }

}  // namespace mb
