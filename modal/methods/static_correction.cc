#include "modal/methods/methods.h"
#include "modal/methods/truncation.h"

namespace mb {
namespace {

class StaticCorrection : public LinearMethod {
 public:
  std::string name() const override { return "static-correction"; }
  std::string doc() const override {
    return "eigenmodes plus the static response of the modes left out, u = Phi q + (G - Phi Lambda^-1 Phi^T) F s";
  }
  Reduction reduce(const Model& model, const Settings& settings) const override {
    return in_eigenmodes(model, settings, true);
  }
};

}  // namespace

std::unique_ptr<Method> static_correction() { return std::make_unique<StaticCorrection>(); }

}  // namespace mb
