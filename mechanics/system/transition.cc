#include "mechanics/system/transition.h"

namespace mb {

Transition::Transition(const ModalMotion& motion, Of of)
    : motion_(motion), of_(of), table_(motion.n_modes(), 8 + 4 * motion.n_loads()) {}

void Transition::make(const Piece& piece, double tau) {
  waves_.clear();
  for (std::size_t l = 0; l < piece.loads.size(); ++l)
    if (piece.loads[l].a != 0 || piece.loads[l].b != 0) waves_.push_back(l);
  for (Index i = 0; i < motion_.n_modes(); ++i) fill(i, piece, tau);
}

void Transition::apply(const MatrixXd& q, const MatrixXd& v, Index from, MatrixXd& q1, MatrixXd& v1, Index to,
                       const Piece& piece, double tau0) const {
  const auto T = [this](Index column) { return table_.col(column).array(); };
  const auto q_from = q.col(from).array(), v_from = v.col(from).array();
  auto q_to = q1.col(to).array(), v_to = v1.col(to).array();
  q_to = T(0) * q_from + T(1) * v_from + T(4) + tau0 * T(5);
  v_to = T(2) * q_from + T(3) * v_from + T(6) + tau0 * T(7);
  Index column = 8;
  for (const auto l : waves_) {
    const Segment seen = rebased(piece.loads[l], piece.start + tau0, piece.end);
    q_to += seen.a * T(column) + seen.b * T(column + 1);
    v_to += seen.a * T(column + 2) + seen.b * T(column + 3);
    column += 4;
  }
}

void Transition::fill(Index i, const Piece& piece, double tau) {
  const Roots& mode = motion_.modes[static_cast<std::size_t>(i)];
  const Response free = response(mode, tau);
  const Response x = of_ == Of::state ? free : integral(mode, free, tau);
  double p0 = 0, p1 = 0;
  for (Index l = 0; l < motion_.n_loads(); ++l) {
    const Segment& load = piece.loads[static_cast<std::size_t>(l)];
    p0 += motion_.f(i, l) * load.c0;
    p1 += motion_.f(i, l) * load.c1;
  }
  table_.row(i).head<8>() << x.C, x.S, x.C_dot, x.S_dot, p0 * x.P + p1 * x.R, p1 * x.P, p0 * x.S + p1 * x.P, p1 * x.S;
  Index column = 8;
  for (const auto l : waves_) {
    const double Omega = piece.loads[l].omega, f = motion_.f(i, static_cast<Index>(l));
    HarmonicResponse y = harmonic_response(mode, free, Omega, tau);
    if (of_ == Of::integral) y = integral(mode, free, y, Omega, tau);
    table_.row(i).segment<4>(column) << f * y.q_cos, f * y.q_sin, f * y.v_cos, f * y.v_sin;
    column += 4;
  }
}

}  // namespace mb
