// Modalbench with one more contender, "at-rest": u(x, t) = 0, whose relative error is 1 by definition of the measure.
#include <memory>
#include <utility>
#include <vector>

#include "harness/catalogue.h"
#include "harness/main.h"

namespace {

class PreparedAtRest final : public mb::Prepared {
 public:
  explicit PreparedAtRest(std::vector<mb::EvaluationPoints> points) : points_(std::move(points)) {}

  mb::Index n_unknowns() const override { return 0; }

  mb::Trajectory simulate(const mb::Sampling& sampling) const override {
    const mb::Index n_t = sampling.t.size();
    mb::Trajectory answer;
    answer.t = sampling.t;
    for (const mb::EvaluationPoints& points : points_)
      answer.bodies.push_back({.displacement = mb::MatrixXd::Zero(3 * points.size(), n_t),
                               .strain = mb::MatrixXd::Zero(6 * points.n_strained(), sampling.strain ? n_t : 0)});
    return answer;
  }

 private:
  std::vector<mb::EvaluationPoints> points_;  // of each body
};

class AtRest final : public mb::Method {
 public:
  std::string name() const override { return "at-rest"; }
  std::string doc() const override { return "stays undeformed: the error which any method must beat"; }

  std::unique_ptr<mb::Prepared> prepare(const mb::Model& model, const mb::Settings&,
                                        const mb::Integrator&) const override {
    std::vector<mb::EvaluationPoints> points;
    for (const mb::BodyModel& body : model.bodies) points.push_back(body.points);
    return std::make_unique<PreparedAtRest>(std::move(points));
  }
};

}  // namespace

int main(int argc, char** argv) {
  mb::Catalogue catalogue = mb::default_catalogue();
  catalogue.methods.push_back(std::make_shared<AtRest>());
  return mb::harness_main(argc, argv, catalogue);
}
