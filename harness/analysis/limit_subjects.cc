#include "harness/analysis/limit_subjects.h"

#include <algorithm>
#include <limits>

#include "modal/bases/mesh_radius.h"
#include "modal/methods/projection.h"

namespace mb {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// run: as integrators get it; seen: with the mass they step with as its only one.
LimitSubject full_subject(const std::string& name, const ModalBody& body, System run, const System& seen) {
  const SteppedMode top = highest_mode(seen);
  const Modes& low = body.modes;
  const Index known = low.size() - low.n_rigid, n_ratios = run.modal_damping.d.size();
  const bool own_modes = n_ratios == 0 || (run.lumped_mass.rows() == 0 && n_ratios <= known);
  // Those of the consistent mass which are above the highest of the mass that is stepped with are none of its modes.
  const Index n = (low.omega.tail(known).array() <= top.omega).count();
  VectorXd omega(n + 1), zeta(n + 1);
  omega << low.omega.segment(low.n_rigid, n), top.omega;
  zeta << damping_ratios(body.system, low).head(n), top.zeta;
  zeta = without_rounding(omega, zeta);
  const auto mode = [n, top](Index i) { return i == n ? std::optional(top) : std::nullopt; };
  return {name,  nan,  std::move(run),
          omega, zeta, mode,
          200,   {},   {},
          nan,   {},   own_modes ? std::nullopt : std::optional(seen)};
}

// Of modes with one limit rounding says which is the least: of all where explicit Euler steps damping of stiffness, of
// the highest where it is among the known ones, too. The highest, which can be run, then stands for them.
Index one_with_a_shape(const LimitSubject& subject, const Scheme& scheme, const StepLimit& limit) {
  // Where any step grows, one by which the highest mode shows it may throw off another.
  if (subject.mode(limit.deciding) || !(limit.dt > 0)) return limit.deciding;
  const double of_last = measured_limit(scheme, subject.omega.tail(1), subject.zeta.tail(1)).dt;
  return of_last <= (1 + 1e-8) * limit.dt ? subject.omega.size() - 1 : limit.deciding;  // either is to 1e-9
}

}  // namespace

Beside beside(const AnalysisContext& context, int n_elastic) {
  const auto [meshes, bar_per_distance] = another_mesh(*context.scene);
  const ModalBody body = modal_body(context, n_elastic, meshes);
  const Index n = body.modes.size() - body.modes.n_rigid;
  return {body.modes.omega.tail(n), without_rounding(body.modes.omega.tail(n), damping_ratios(body.system, body.modes)),
          bar_per_distance};
}

LimitSubject reduced_subject(const ModalBody& body, int r, const Beside& other) {
  const Modes modes = leading(body.modes, r);
  const Index n_rigid = modes.n_rigid, n = modes.size() - n_rigid;
  System system = project(body.system, modes);
  Modes unit{n_rigid, modes.omega, MatrixXd::Identity(modes.size(), modes.size()), {}, 0};
  const VectorXd omega = modes.omega.tail(n), zeta = without_rounding(omega, damping_ratios(system, unit));
  const auto mode = [=](Index i) -> std::optional<SteppedMode> {
    const VectorXd e = VectorXd::Unit(n_rigid + n, n_rigid + i);
    return SteppedMode{omega(i), zeta(i), e, e};
  };
  const long most_steps = 200000 / (20 + n);  // as much work for many modes as for few
  const Index known = std::min(n, other.omega.size());
  return {"reduced",
          static_cast<double>(n),
          std::move(system),
          omega,
          zeta,
          mode,
          most_steps,
          other.omega.head(known),
          other.zeta.head(known),
          other.bar_per_distance,
          omega.unaryExpr([&](double each) { return rounding_of_frequency(modes, each); })};
}

std::vector<LimitSubject> full_subjects(const ModalBody& body) {
  const System consistent = with_consistent_mass(body.system);
  std::vector<LimitSubject> all{full_subject("full, consistent mass", body, consistent, consistent)};
  if (body.system.lumped_mass.rows() > 0)
    all.push_back(full_subject("full, lumped mass", body, body.system, with_lumped_mass(body.system)));
  return all;
}

SubjectLimit limit_of(const LimitSubject& subject, const Scheme& scheme) {
  if (!subject.coupled) {
    const StepLimit limit = measured_limit(scheme, subject.omega, subject.zeta);
    const Index deciding = one_with_a_shape(subject, scheme, limit);
    return {limit.dt, formula_limit(scheme, subject.omega, subject.zeta), deciding, subject.omega(deciding),
            subject.mode(deciding)};
  }
  const Index last = subject.omega.size() - 1;
  const auto whole = mesh_limit(*subject.coupled, scheme);
  if (!whole) return {nan, nan, last, nan, {}};
  return {whole->dt, nan, last, whole->mode.omega, whole->mode};
}

}  // namespace mb
