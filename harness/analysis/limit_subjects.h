// What the analysis of step limits looks at: reduced systems and the mesh itself, each with the modes that are known of
// it, or without any where its damping makes none of them its own.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "harness/analysis/analysis.h"
#include "harness/analysis/modal_body.h"
#include "harness/analysis/step_limit.h"

namespace mb {

// One system whose limits are asked for: what is known of its modes, and what can be run.
struct LimitSubject {
  std::string name;
  double r;              // elastic modes kept; NaN: full order
  System system;         // as integrators get it
  VectorXd omega, zeta;  // modes looked at; of full order the lowest and the highest
  std::function<std::optional<SteppedMode>(Index)> mode;
  long most_steps;
  VectorXd omega_beside, zeta_beside;  // on another mesh, as far as known; of full order none: its limit is its mesh's
  double bar_per_distance;             // [-] (another_mesh)
  VectorXd rounding;                   // [-] of omega, relative
  // Of full order whose single damping ratios are those of other modes, as where the mass is lumped, or of more than
  // are known: the mesh with the mass that is stepped.
  std::optional<System> coupled = {};
};

// Elastic modes of another mesh.
struct Beside {
  VectorXd omega, zeta;
  double bar_per_distance;
};
Beside beside(const AnalysisContext& context, int n_elastic);

LimitSubject reduced_subject(const ModalBody& body, int r, const Beside& other);
// With the consistent mass alone, and with the lumped one where there is one.
std::vector<LimitSubject> full_subjects(const ModalBody& body);

struct SubjectLimit {
  double dt, formula;  // [s]; formula: NaN where modes are not known
  Index deciding;      // of the modes looked at; where several share a limit above 0, one that can be run
  double omega;        // [rad/s] of the mode that decides
  std::optional<SteppedMode> mode;
};
// By its modes, or by one step of the mesh (modal/bases/mesh_radius.h), which knows nothing of explicit Euler: dt is
// NaN.
SubjectLimit limit_of(const LimitSubject& subject, const Scheme& scheme);

}  // namespace mb
