// Modes of damping that couples the undamped ones. In modal coordinates and scaled so that |y|^2 is twice the energy,
//
//   q'' + C q' + Omega^2 q = f s(t),   y = (Omega q, q'):   y' = A y + (0, f) s,   A = [0 Omega; -Omega -C]
//   A X = X diag(mu),   z = X^-1 y:   z_j' = mu_j z_j + (X^-1 (0, f))_j s(t)
//
// each z_j in closed form on the segments of s (exp_difference.h). A pair mu = -zeta omega +- i omega sqrt(1 - zeta^2)
// swings with frequency |mu| and ratio -Re(mu)/|mu|. Foss 1958, J. Appl. Mech. 25; Craig 1981, Structural Dynamics,
// sect. 18.4. Without damping A is skew and X unitary; where modes meet critically cond(X) grows.
#pragma once

#include <Eigen/Core>

#include "mechanics/history/history.h"
#include "mechanics/system/modal_motion.h"

namespace mb {

struct ComplexModes {
  Eigen::VectorXcd mu;  // [1/s] 2n, Re <= 0 but for rounding; ascending |mu|, of a pair Im > 0 first
  Eigen::MatrixXcd X;   // 2n x 2n, columns of unit length
  double condition;     // [-] of X, 2-norm, at least 1
};

// omega [rad/s] n, each > 0; C [1/s] n x n symmetric positive semi-definite. Throws std::invalid_argument for n > 1000,
// sizes that disagree and omega that is not positive; std::runtime_error where modes are critical to working precision
// (condition > 1e8) or C drives instead of damping.
ComplexModes complex_modes(const VectorXd& omega, const MatrixXd& C);

// The motion of modes that damping couples under loads that are chains of lines and waves.
class CoupledMotion {
 public:
  // f [N kg^-1/2] n x n_loads; q0, v0 at t = 0; pieces tile [0, duration].
  CoupledMotion(const VectorXd& omega, const MatrixXd& C, const MatrixXd& f, const VectorXd& q0, const VectorXd& v0,
                std::vector<Piece> pieces);
  // times [s] ascending in [0, duration]. Work: as of uncoupled modes, each mode counted once.
  ModalStates states(const VectorXd& times) const;
  // Means over [t - width/2, t + width/2], at rest before t = 0; windows end within the duration.
  ModalStates means(const VectorXd& times, double width) const;

 private:
  Eigen::VectorXcd after(const Piece& piece, const Eigen::VectorXcd& z, double tau) const;
  Eigen::VectorXcd integral(const Piece& piece, const Eigen::VectorXcd& z, double from, double to) const;
  void write(const Eigen::VectorXcd& z, Index j, ModalStates& states) const;

  VectorXd omega_;
  ComplexModes modes_;
  Eigen::MatrixXcd f_;       // X^-1 (0, f): 2n x n_loads
  Eigen::VectorXcd z_rest_;  // of (q0, 0), before t = 0
  std::vector<Piece> pieces_;
  std::vector<Eigen::VectorXcd> starts_;  // z at the start of every piece
};

}  // namespace mb
