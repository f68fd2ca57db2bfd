#include <algorithm>

#include "modal/bases/ritz_modes.h"
#include "modal/contact/floating_answer.h"
#include "modal/methods/methods.h"
#include "modal/methods/projection.h"

namespace mb {
namespace {

class Polynomials : public LinearMethod {
 public:
  Polynomials(std::string name, int degree) : name_(std::move(name)), degree_(degree) {}
  std::string name() const override { return name_; }
  std::string doc() const override {
    return "Ritz modes in the polynomials of degree " + std::to_string(degree_) +
           " that the supports admit, rigid motions included: " + name_ + " strain modes";
  }
  bool takes_modes() const override { return false; }
  Reduction reduce(const Model& model, const Settings&) const override {
    Reduction reduction{{}, 0};
    std::vector<Modes> all;
    for (const BodyModel& body : model.bodies) {
      const System& system = body.full->system();
      const Modes modes = ritz_modes(system, body.full->polynomials(degree_));
      reduction.bodies.push_back(mb::reduce(body, modes, MatrixXd(system.F.rows(), 0)));
      reduction.modes_used = std::max(reduction.modes_used, static_cast<int>(modes.size() - modes.n_rigid));
      all.push_back(modes);
    }
    answer_in_frames(reduction, model, all, false);
    return reduction;
  }

 private:
  std::string name_;
  int degree_;
};

}  // namespace

std::unique_ptr<Method> linear_strain() { return std::make_unique<Polynomials>("linear", 1); }
std::unique_ptr<Method> quadratic_strain() { return std::make_unique<Polynomials>("quadratic", 2); }

}  // namespace mb
