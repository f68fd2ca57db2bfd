// What full order with linear kinematics carries in contact, looked for in an answer's own states at the samples:
//
//   rotation    R R^T M u, the rigid part of u, at points X_i about their mean:   theta = J^-1 sum_i X_i x d_i,
//               J = sum_i |X_i|^2 1 - X_i X_i^T;   theta x r is off by |theta|^2 |r| / 2 of a true rotation
//   boundary    points that no contact watches (contact_surface.h) feel nothing: none may lie within an obstacle
//
// Vibrations have no part in theta: they are M-orthogonal to rigid motions.
#pragma once

#include <optional>
#include <string>

#include "cases/contract/model.h"

namespace mb {

constexpr double most_rotation = 0.1;  // [rad] half a per cent of a body's size

// States of a run: t [s] n_t, u [m] n x n_t.
struct Displaced {
  const VectorXd& t;
  const MatrixXd& u;
};

// 3 x n: theta = rows u [rad]. points [m] 3 x p, not on one line; rigid: the system's R there, 3 p x m.
MatrixXd rotation_rows(const System& system, const Matrix3Xd& points, const MatrixXd& rigid);

// Since when an answer is none, and why.
struct Fault {
  double t;  // [s] of the first sample beyond
  std::string what;
};

// theta [rad] 3 x n_t at t [s]: a rotation of more than most_rotation, or none that is a number: names the body and the
// largest angle.
std::optional<Fault> large_rotation(const Body& body, const MatrixXd& theta, const VectorXd& t);

// All points of a body's boundary, of which a contact has some, in the same axes and order; the body's frame in them.
struct Boundary {
  ContactPoints points;
  Pose frame;
};

// A point of the boundary that is not among the contact's, looks at the obstacle and lies in it deeper than a
// thousandth of the contact's displacement: names body, obstacle and depth.
std::optional<Fault> unwatched_overlap(const Body& body, const Boundary& boundary, const Contact& contact,
                                       const std::string& obstacle, const Displaced& states);

}  // namespace mb
