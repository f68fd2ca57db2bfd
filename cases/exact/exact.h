// Closed-form motions of the continuum, by name from a case ([truth] exact = "rod-step"). They answer at the evaluation
// points like any contender; a scene that is not the one the solution holds for is refused.
//
//   rod-step              box along z, nu = 0, equal tractions on one end from t = 0, the other end held or free:
//                         d'Alembert's triangle waves, u(z, t); strain exact between the jumps
//   sphere-radial-pulse   free sphere under a uniform pressure pulse sin^2: radial modes with mode acceleration, the
//                         series cut where its remainder is below 1e-9 of the peak
//   timoshenko-impact     Euler-Bernoulli beam, simply supported, struck by a ball: Volterra's equation
//   zener-impact          large Kirchhoff plate, struck by a ball: Zener's equation, of the contact alone
//   hertz-impact          sphere thrown on a rigid plane: Hertz's impact, corrected for the finite sphere and the
//                         penalty layer, quasi-static, of the contact alone
//   rod-on-wall           box or cylinder, nu = 0, thrown flat on a rigid plane: waves, the layer included
//
// Graff 1975, Wave Motion in Elastic Solids, sects. 2.3 and 5.3; Lamb 1882, Proc. London Math. Soc. 13.
#pragma once

#include <string>
#include <vector>

#include "cases/contract/method.h"
#include "cases/contract/model.h"

namespace mb {

struct ExactSolution {
  std::string name, doc, source;
  std::string (*problem)(const Scene& scene);  // empty where the solution holds for the scene, else why not
  // Displacement, strain and contact of the scene's body at t [s]; 0 columns of what the solution does not say.
  Trajectory (*at)(const Scene& scene, const EvaluationPoints& points, const VectorXd& t);
  double error_bar;  // [-] of the series, relative to the largest displacement: a metric's own unit is made of it by
                     // whoever compares (harness/study/truth.h)
};
const std::vector<ExactSolution>& exact_solutions();
const ExactSolution& exact_solution(const std::string& name);  // throws std::out_of_range naming it

}  // namespace mb
