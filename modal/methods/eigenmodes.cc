#include "modal/methods/methods.h"
#include "modal/methods/truncation.h"

namespace mb {
namespace {

class Eigenmodes : public LinearMethod {
 public:
  std::string name() const override { return "eigenmodes"; }
  std::string doc() const override { return "the body's own lowest r elastic modes and its rigid ones, u = Phi q"; }
  Reduction reduce(const Model& model, const Settings& settings) const override {
    return in_eigenmodes(model, settings, false);
  }
};

}  // namespace

std::unique_ptr<Method> eigenmodes() { return std::make_unique<Eigenmodes>(); }

}  // namespace mb
