#include "modal/methods/methods.h"
#include "modal/methods/truncation.h"

namespace mb {
namespace {

class Eigenmodes : public Method {
 public:
  std::string name() const override { return "eigenmodes"; }
  std::string doc() const override { return "the body's own lowest r elastic modes and its rigid ones, u = Phi q"; }
  std::unique_ptr<Prepared> prepare(const Model& model, const Settings& settings,
                                    const Integrator& integrator) const override {
    return prepare_truncated(model, settings, integrator, false);
  }
};

}  // namespace

std::unique_ptr<Method> eigenmodes() { return std::make_unique<Eigenmodes>(); }

}  // namespace mb
