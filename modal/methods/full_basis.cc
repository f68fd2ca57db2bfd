#include "cases/contract/linear.h"
#include "modal/methods/methods.h"

namespace mb {
namespace {

class FullBasis : public LinearMethod {
 public:
  std::string name() const override { return "full"; }
  std::string doc() const override { return "every degree of freedom of the mesh: the identity as basis, u = q"; }
  bool takes_modes() const override { return false; }
  Reduction reduce(const Model& model, const Settings&) const override { return unreduced(model); }
};

}  // namespace

std::unique_ptr<Method> full_basis() { return std::make_unique<FullBasis>(); }

}  // namespace mb
