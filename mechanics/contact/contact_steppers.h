// Fixed steps of full order in contact, from the first touch on:
//
//   newmark            A v1 = M (v0 + h/2 a0) + h/2 (F s - K a + f1),   a = u0 + h/2 v0,   u1 = a + h/2 v1,
//                      A = M + h/2 C + h^2/4 K: average acceleration, f1 = f(u1, v1) implicit (contact_stage.h)
//   central difference (M + h/2 C) (w+ - w)/h = F s + f(u, w) - K u - C w: contact explicit, mass lumped if any
//   explicit Euler     M (v+ - v)/h = F s + f(u, v) - K u - C v,   u+ = u + h v
//   symplectic Euler   likewise,                                   u+ = u + h v+
//
// The first two are of order 2 where the force is smooth, of less where points begin or cease to press, the others of
// order 1. Of finite kinematics they step with the forces of finite_force.h, with contact or without.
#pragma once

#include <memory>

#include "mechanics/contact/contact.h"
#include "mechanics/system/system.h"

namespace mb {

// h [s] > 0. System and contacts must outlive the stepper.
std::unique_ptr<Stepper> newmark(const System& system, const std::vector<Contact>& contacts, double h);
std::unique_ptr<Stepper> central_difference(const System& system, const std::vector<Contact>& contacts, double h);
std::unique_ptr<Stepper> explicit_euler(const System& system, const std::vector<Contact>& contacts, double h);
std::unique_ptr<Stepper> symplectic_euler(const System& system, const std::vector<Contact>& contacts, double h);

}  // namespace mb
