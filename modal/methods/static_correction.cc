#include "modal/methods/methods.h"
#include "modal/methods/truncation.h"

namespace mb {
namespace {

class StaticCorrection : public Method {
 public:
  std::string name() const override { return "static-correction"; }
  std::string doc() const override {
    return "eigenmodes plus the static response of the modes left out, u = Phi q + (G - Phi Lambda^-1 Phi^T) F s";
  }
  std::unique_ptr<Prepared> prepare(const Model& model, const Settings& settings,
                                    const Integrator& integrator) const override {
    return prepare_truncated(model, settings, integrator, true);
  }
};

}  // namespace

std::unique_ptr<Method> static_correction() { return std::make_unique<StaticCorrection>(); }

}  // namespace mb
