// A step h of floating bodies in contact (floating_body.h), all of them at once, by one of
//
//   exact              kick h/2, every mode in closed form over h, kick h/2: the contact force acts in pieces
//                      (Deuflhard 1979, J. Appl. Math. Phys. 30; Hairer, Lubich & Wanner 2006, Geometric Numerical
//                      Integration, XIII.1), symplectic, order 2; one evaluation of contact a step. With damping or
//                      friction in contact order 1: its force takes the rates before the second kick
//   symplectic-euler   rates with the forces at the start, then places with these rates: order 1, explicit
//   central-difference kick h/2 by all forces, places with these rates, kick h/2 by the forces there, the damping of
//                      modes by the mean of the rates before and after: order 2, with damping or friction in contact 1
//                      as above; explicit, one evaluation of contact a step
//   explicit-euler     places and rates with those at the start: order 1, feeds energy without damping
//   newmark            average acceleration of frame and modes, contact at the end implicit: order 2
//
// Angular momentum is kept exactly but for the torques; the frame turns by the angular velocity half way, order 2. Of a
// body with coupling frame and modes go on together between the kicks (coupled_flow.h); only `exact` has such steps.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "modal/contact/contact_load.h"
#include "modal/frame/coupled_flow.h"

namespace mb {

enum class ContactScheme { exact, symplectic_euler, central_difference, explicit_euler, newmark };
std::optional<ContactScheme> contact_scheme(const std::string& integrator);  // by its name in the catalogue

// A state with what contact does in it, and what it has done since t = 0 by the scheme's own quadrature.
struct ContactState {
  BodyState body;
  ContactLoad load;
  Vector3d impulse = Vector3d::Zero();  // [N s]
  double dissipated = 0;                // [J]
};

// Of all bodies, below each other.
VectorXd static_shapes(std::span<const ContactState> states);

class ContactStepper {
 public:
  // h [s] > 0; the bodies must outlive this
  ContactStepper(const std::vector<const FloatingBody*>& bodies, ContactScheme scheme, double h);
  ContactStepper(const FloatingBody& body, ContactScheme scheme, double h)
      : ContactStepper(std::vector{&body}, scheme, h) {}

  void touch(std::span<ContactState> states);  // begins: evaluates the loads, static shapes having no rate
  // false where Newton's method, of the step or of the static shapes, does not converge
  bool advance(std::span<ContactState> states);
  void touch(ContactState& state) { touch({&state, 1}); }
  bool advance(ContactState& state) { return advance({&state, 1}); }
  double step() const { return h_; }
  long n_evaluations() const { return n_evaluations_; }

 private:
  struct OfBody {
    explicit OfBody(const FloatingBody& of, double h);
    void kick(ContactState& state, double tau) const;  // by the contact forces alone
    void drift(BodyState& b, double h) const;          // over h, without contact
    void turn(BodyState& b, double tau) const;
    void move(BodyState& b, double tau) const;  // places alone, with the rates as they are
    // By stiffness, weight and `damped` times [-] the damping, not by contact.
    void kick_freely(BodyState& b, double tau, double damped) const;

    const FloatingBody* body;
    std::optional<CoupledFlow> coupled;
    Eigen::Matrix3d inverse_inertia;
    VectorXd lambda, c;              // of modes
    VectorXd C, S, C_dot, S_dot, P;  // of modes over h
  };
  static bool converged(std::span<const ContactState> states);  // all at once
  void look(std::span<ContactState> states);
  void look_ahead(std::span<ContactState> states);  // static shapes sought from where the last two steps point to
  bool advance_exactly(std::span<ContactState> states);
  bool advance_by_euler(std::span<ContactState> states);
  bool advance_by_explicit_euler(std::span<ContactState> states);
  bool advance_by_central_differences(std::span<ContactState> states);
  bool advance_by_newmark(std::span<ContactState> states);

  ContactScheme scheme_;
  double h_;
  std::vector<OfBody> bodies_;
  ContactLoads loads_;
  VectorXd s_, s_before_;  // s of all bodies at the start of this step and the last, where there was one
  bool has_before_ = false;
  long n_evaluations_ = 0;
};

}  // namespace mb
