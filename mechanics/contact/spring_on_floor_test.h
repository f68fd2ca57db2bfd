// A point on a spring and the floor it falls on, which steps in contact are tried with.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mechanics/contact/contact.h"
#include "mechanics/system/system.h"

namespace mb::spring_on_floor {

inline constexpr double mass = 0.4, k = 5e4, area = 1e-3, k_n = 2e9;  // [kg], [N/m], [m^2], [Pa/m]

// A point on a spring along z, some way above the floor: in contact its spring is k + area k_n.
inline System spring(double stiffness, double c = 0) {
  System s;
  s.M = (mass * MatrixXd::Identity(3, 3)).sparseView();
  s.K = MatrixXd(Vector3d(1e3, 1e3, stiffness).asDiagonal()).sparseView();
  s.damping = {c, 0};
  s.R = MatrixXd(3, 0);
  s.F = MatrixXd(3, 0);
  s.u0 = s.v0 = VectorXd::Zero(3);
  s.modal_damping.W = MatrixXd(3, 0);
  return s;
}
inline Contact on_floor(double height, const PenaltyLaw& law = {k_n, 0, {}}) {
  ContactPoints points{Vector3d(0, 0, height), VectorXd::Constant(1, area), SparseMatrix(3, 3)};
  points.U.setIdentity();
  return {points, {HalfSpace{}, 0, {}}, law, {1e-3, 1}};
}

// Of n steps while the point presses, displacement by the amplitude and velocity by the speed. u'' = -(k u + A k_n u)/m
// from the speed -v: a sine. make(system, contacts, h) makes the stepper.
double largest_error(const auto& make, int n) {
  System system = spring(k);
  const double v = 1.5, omega = std::sqrt((k + area * k_n) / mass), T = 0.9 * pi / omega;
  system.v0[2] = -v;
  const std::vector<Contact> contacts{on_floor(0)};
  const VectorXd times = VectorXd::LinSpaced(10, 0, T);
  const States states = make(system, contacts, T / n)->run(times);
  EXPECT_EQ(states.status, Status::ok);
  EXPECT_EQ(states.n_valid, 10);
  double error = 0;
  for (Index i = 0; i < 10; ++i)
    error = std::max({error, std::abs(states.u(2, i) + v / omega * std::sin(omega * times[i])) * omega / v,
                      std::abs(states.v(2, i) + v * std::cos(omega * times[i])) / v});
  return error;
}

}  // namespace mb::spring_on_floor
