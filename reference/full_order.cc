#include "reference/full_order.h"

#include <algorithm>

#include "cases/contract/linear.h"
#include "reference/finite_answer.h"
#include "reference/impact.h"

namespace mb {

namespace {

class FullOrder final : public LinearMethod {
 public:
  std::string name() const override { return "full-order"; }
  std::string doc() const override { return "every degree of freedom of the mesh (identity basis)"; }
  bool takes_modes() const override { return false; }
  Reduction reduce(const Model& model, const Settings&) const override {
    Reduction reduction = unreduced(model);
    const auto finite = [](const Body& b) { return b.kinematics == Kinematics::finite; };
    if (!model.scene->contacts.empty())
      reduction.in_contact = [&model](const Integrator& integrator, const Settings& settings) {
        return prepare_impact(model, integrator, settings);
      };
    else if (std::ranges::any_of(model.scene->bodies, finite))
      reduction.in_contact = [&model](const Integrator& integrator, const Settings& settings) {
        return prepare_finite(model, integrator, settings);
      };
    return reduction;
  }
};

}  // namespace

std::unique_ptr<Method> full_order() { return std::make_unique<FullOrder>(); }

}  // namespace mb
