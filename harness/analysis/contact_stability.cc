#include "harness/analysis/contact_stability.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "mechanics/system/oscillator.h"

namespace mb {
namespace {

// (q, v) -> (q, v) of half a kick, by contact alone.
MatrixXd kick(const PressedModes& p, double h) {
  const Index n = p.g.size();
  MatrixXd A = MatrixXd::Identity(2 * n, 2 * n);
  A.bottomLeftCorner(n, n) = -h * p.kappa * p.g * p.g.transpose();
  return A;
}

MatrixXd drift(const PressedModes& p, double h) {
  const Index n = p.g.size();
  MatrixXd A = MatrixXd::Zero(2 * n, 2 * n);
  for (Index i = 0; i < n; ++i) {
    const Response r = response(roots({p.lambda[i], p.c[i]}), h);
    A(i, i) = r.C, A(i, n + i) = r.S;
    A(n + i, i) = r.C_dot, A(n + i, n + i) = r.S_dot;
  }
  return A;
}

MatrixXd stiffness(const PressedModes& p) { return MatrixXd(p.lambda.asDiagonal()) + p.kappa * p.g * p.g.transpose(); }

MatrixXd by_symplectic_euler(const PressedModes& p, double h) {
  const Index n = p.g.size();
  const MatrixXd I = MatrixXd::Identity(n, n);
  MatrixXd A(2 * n, 2 * n);
  A.bottomLeftCorner(n, n) = -h * stiffness(p);
  A.bottomRightCorner(n, n) = I - h * MatrixXd(p.c.asDiagonal());
  A.topLeftCorner(n, n) = I + h * A.bottomLeftCorner(n, n);
  A.topRightCorner(n, n) = h * A.bottomRightCorner(n, n);
  return A;
}

// Average acceleration is the trapezoidal rule of y' = B y.
MatrixXd by_newmark(const PressedModes& p, double h) {
  const Index n = p.g.size();
  MatrixXd B = MatrixXd::Zero(2 * n, 2 * n);
  B.topRightCorner(n, n).setIdentity();
  B.bottomLeftCorner(n, n) = -stiffness(p);
  B.bottomRightCorner(n, n) = -MatrixXd(p.c.asDiagonal());
  const MatrixXd I = MatrixXd::Identity(2 * n, 2 * n);
  return (I - h / 2 * B).partialPivLu().solve(I + h / 2 * B);
}

}  // namespace

double pressed_radius(const PressedModes& pressed, const std::string& scheme, double h) {
  MatrixXd A;
  if (scheme == "exact")
    A = kick(pressed, h / 2) * drift(pressed, h) * kick(pressed, h / 2);
  else if (scheme == "symplectic-euler")
    A = by_symplectic_euler(pressed, h);
  else if (scheme == "newmark")
    A = by_newmark(pressed, h);
  else
    throw std::invalid_argument("no scheme '" + scheme + "' steps in contact");
  return Eigen::EigenSolver<MatrixXd>(A, false).eigenvalues().cwiseAbs().maxCoeff();
}

double pressed_limit(const PressedModes& pressed, const std::string& scheme, double most) {
  constexpr double grows = 1 + 1e-6;  // rounding of eigenvalues, of which rigid modes are double: sqrt(eps)
  const auto stable = [&](double h) { return pressed_radius(pressed, scheme, h) <= grows; };
  constexpr int n = 60;
  const double first = 1e-4 * most;
  double low = first;
  for (int i = 0; i <= n; ++i) {
    double high = first * std::pow(1e4, static_cast<double>(i) / n);
    if (stable(high)) {
      low = high;
      continue;
    }
    while (high > low * 1.001) {
      const double middle = std::sqrt(low * high);
      (stable(middle) ? low : high) = middle;
    }
    return high;
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace mb
