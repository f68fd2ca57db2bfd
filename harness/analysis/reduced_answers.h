// Reduced contenders made over and over for analyses: one eigenproblem serves every mode count and every integrator.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "harness/analysis/modal_body.h"

namespace mb {

class ReducedAnswers {
 public:
  // n_elastic: most modes that will be asked for.
  ReducedAnswers(const AnalysisContext& context, int n_elastic);
  const ModalBody& body() const { return body_; }

  // At the scene's sample times, strains included. settings.modes: elastic modes. eigenmodes and static-correction are
  // made from the modes known; other methods make their own.
  Trajectory answer(const std::string& method, const Integrator& integrator, const Settings& settings) const;

 private:
  const AnalysisContext& context_;
  ModalBody body_;
  MatrixXd static_response_;  // G F
};

}  // namespace mb
