// A step h of a floating body in contact (floating_body.h), by one of
//
//   exact              kick h/2, every mode in closed form over h, kick h/2: the contact force acts in pieces
//                      (Deuflhard 1979, J. Appl. Math. Phys. 30; Hairer, Lubich & Wanner 2006, Geometric Numerical
//                      Integration, XIII.1), symplectic, order 2; one evaluation of contact a step. With damping or
//                      friction in contact order 1: its force takes the rates before the second kick
//   symplectic-euler   rates with the forces at the start, then places with these rates: order 1, explicit
//   newmark            average acceleration of frame and modes, contact at the end implicit: order 2
//
// Angular momentum is kept exactly but for the torques; the frame turns by the angular velocity half way, order 2. Of a
// body with coupling frame and modes go on together between the kicks (coupled_flow.h); only `exact` has such steps.
#pragma once

#include <optional>
#include <string>

#include "modal/contact/contact_load.h"
#include "modal/contact/coupled_flow.h"

namespace mb {

enum class ContactScheme { exact, symplectic_euler, newmark };
std::optional<ContactScheme> contact_scheme(const std::string& integrator);  // by its name in the catalogue

// A state with what contact does in it, and what it has done since t = 0 by the scheme's own quadrature.
struct ContactState {
  BodyState body;
  ContactLoad load;
  Vector3d impulse = Vector3d::Zero();  // [N s]
  double dissipated = 0;                // [J]
};

class ContactStepper {
 public:
  // h [s] > 0; the body must outlive this
  ContactStepper(const FloatingBody& body, ContactScheme scheme, double h);
  void touch(ContactState& state);  // begins: evaluates the load of its body, static shapes having no rate
  // false where Newton's method, of the step or of the static shapes, does not converge
  bool advance(ContactState& state);
  double step() const { return h_; }
  long n_evaluations() const { return n_evaluations_; }

 private:
  void look(ContactState& state);
  void look_ahead(ContactState& state);  // static shapes being sought from where the last two steps point to
  void kick(ContactState& state, double tau) const;  // by the contact forces alone
  void drift(BodyState& body) const;                 // over h, without contact
  void turn(BodyState& body, double tau) const;
  bool advance_exactly(ContactState& state);
  bool advance_by_euler(ContactState& state);
  bool advance_by_newmark(ContactState& state);

  const FloatingBody& body_;
  ContactScheme scheme_;
  double h_;
  ContactLoads loads_;
  std::optional<CoupledFlow> coupled_;
  Eigen::Matrix3d inverse_inertia_;
  VectorXd lambda_, c_;                 // of modes
  VectorXd C_, S_, C_dot_, S_dot_, P_;  // of modes over h
  VectorXd scratch_, s_, s_before_;     // s at the start of this step and the last, where there was one
  bool has_before_ = false;
  long n_evaluations_ = 0;
};

}  // namespace mb
