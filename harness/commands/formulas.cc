#include "harness/commands/formulas.h"

#include <map>

namespace mb {

namespace {

const std::map<std::string, FormulaAndSource>& methods() {
  static const std::string craig = "Craig 1981, Structural Dynamics, sect. 15.5";
  static const std::string pentland = "Pentland and Williams 1989, Good Vibrations, Computer Graphics 23(3)";
  static const std::map<std::string, FormulaAndSource> all = {
      {"full-order",
       {"M u'' + C u' + K u = F s(t), M_ij = int rho N_i N_j, K_ij = int B_i^T D B_j",
        "Hughes 1987, The Finite Element Method, ch. 7"}},
      {"eigenmodes", {"u = Phi q, K phi = omega^2 M phi, Phi^T M Phi = I, the lowest r elastic modes", craig}},
      {"static-correction", {"u = Phi q + (G - Phi_e Lambda_e^-1 Phi_e^T) F s, G the static response", craig}},
      {"linear",
       {"u = Phi q, Ritz vectors from polynomials of degree 1: 6 elastic functions of a free body", pentland}},
      {"quadratic",
       {"u = Phi q, Ritz vectors from polynomials of degree 2: 24 elastic functions of a free body", pentland}},
      {"full", {"u = q: the identity as basis, every degree of freedom of the mesh", "the limit of every reduction"}},
  };
  return all;
}

const std::map<std::string, FormulaAndSource>& integrators() {
  static const std::map<std::string, FormulaAndSource> all = {
      {"exact",
       {"q_i'' + c_i q_i' + lambda_i q_i = phi_i^T F s(t) in closed form on each piece of s(t)",
        "Craig 1981, Structural Dynamics, sect. 5.2"}},
      {"newmark",
       {"(4/h^2 M + 2/h C + K) u+ = F s+ + M (4/h^2 u + 4/h v + a) + C (2/h u + v)",
        "Newmark 1959, J. Eng. Mech. Div. ASCE 85(3)"}},
      {"central-difference",
       {"M (u+ - 2 u + u-)/h^2 + C (u+ - u-)/(2 h) + K u = F s, stable for h <= 2/omega_max",
        "Belytschko, Liu and Moran 2000, Nonlinear Finite Elements, sect. 6.2"}},
      {"explicit-euler",
       {"u+ = u + h v, v+ = v + h M^-1 (F s - C v - K u), stable for h <= 2 zeta/omega",
        "named by Pentland and Williams 1989, Good Vibrations, Computer Graphics 23(3)"}},
      {"symplectic-euler",
       {"v+ = v + h M^-1 (F s - C v - K u), u+ = u + h v+, stable for h <= 2/omega undamped",
        "Hairer, Lubich and Wanner 2006, Geometric Numerical Integration, sect. I.1"}},
      {"sundials",
       {"ESDIRK of order 5, embedded error estimate of order 4, one factor of M + gamma C + gamma^2 K a gamma",
        "Reynolds et al. 2023, ACM Trans. Math. Softw. 49(2), the ARKODE library"}},
  };
  return all;
}

const std::map<std::string, FormulaAndSource>& analyses() {
  static const std::string ours = "this suite: harness/analysis/analyses.h";
  static const std::map<std::string, FormulaAndSource> all = {
      {"budget",
       {"modal(dt) -> modal(exact in t) -> full order, same mesh -> finer; with contact modal(dt) -> modal(dt/4) -> "
        "modes on the mesh's surface -> static shapes with their mass -> same mesh -> finer -> finite strain; total^2 "
        "= sum of squares + cross terms",
        ours}},
      {"step-limits",
       {"largest h with spectral radius of the one-step amplification <= 1 + 1e-12; growth of runs against rho^n",
        "Hughes 1987, The Finite Element Method, ch. 9"}},
      {"stability-map",
       {"E(t)/E(0) of free vibration over 1000 steps against rho(A(omega h, zeta)), or rho of one step of all modes "
        "that "
        "damping couples; error against the closed form",
        "Hughes 1987, The Finite Element Method, sect. 9.1.2"}},
      {"aliasing",
       {"RMS_frames(B x_high) / RMS_frames(x_low), x = x_low + x_high split at half the frame rate, B the shutter",
        "Shannon 1949, Proc. IRE 37(1), for the limit"}},
      {"frequency-response",
       {"u = (K + i omega C - omega^2 M)^-1 F at the probe", "mechanics/system/frequency_response.h"}},
      {"mode-amplitudes", {"max_t |q_i| ~ omega_i^-p: p = 1 for fixed energy and impulse, 2 for fixed force", ours}},
      {"damping",
       {"zeta_i = phi_i^T C phi_i / (2 omega_i); by decay: delta / sqrt(4 pi^2 + delta^2); of steps: "
        "-ln|lambda| / |ln lambda|",
        ours}},
      {"damping-coupling",
       {"|u_d - u| / |u|, u by complex modes of all of Phi^T C Phi, u_d by its diagonal",
        "Foss 1958, J. Appl. Mech. 25; mechanics/system/complex_modes.h"}},
      {"long-run", {"mean E at step n / mean E at the start - 1 ~ n^p over 10^6 steps of free vibration", ours}},
      {"multiplets",
       {"largest |Phi_a - Phi_b Phi_b^T M Phi_a|_M, and with a and b exchanged, a by Lanczos iterations, b by a dense "
        "solver",
        "Golub and Van Loan 2013, Matrix Computations, sect. 6.4.3"}},
      {"locking",
       {"|u_p - u| / |u| and f_p / f - 1 of elements of degree p at nu = 0.3 to 0.4999",
        "Hughes 1987, The Finite Element Method, ch. 4"}},
      {"contact-stability",
       {"1 + (E - E0)/(m v_n^2/2), F and J of an impact over step and k_n, against rho of one step with kappa = k_n pi "
        "a^2 at one point",
        "harness/analysis/contact_stability.h"}},
      {"linearity",
       {"|v2 + v3| / |u|, K v2 = -f2(u), K v3 = -c3(u, v2): terms of the stored energy's force beyond K u",
        "Idelsohn and Cardona 1985, Comput. Methods Appl. Mech. Engng 49; harness/analysis/beyond_linear.h"}},
      {"frequencies",
       {"f_i / f_i* - 1 on a row of meshes, f* as the case states them, the observed order and the "
        "grid convergence index",
        ours}},
      {"probe-extremes", {"max_t s, min_t s by the parabola through three samples, beside the static s", ours}},
      {"instructions",
       {"instructions of stepping and displacements at frames / (1e6 simulated time), by callgrind: the MIPS it takes "
        "for "
        "real time",
        "Pentland and Williams 1989, Good Vibrations, whose machine had one; harness/instruction_counter.h"}},
      {"aspect",
       {"|u_r - u|/|u| of 24 modes against adaptive steps, max E(t)/E(0), at aspects 1, 4, 14, 50 and 200", ours}},
      {"slenderness",
       {"|u_d - u| / |u| in the M norm, u_d: Ritz modes in polynomials of degree d, u: 96 modes and the static rest, "
        "at "
        "length/width 1 to 50 with the section kept and times as many periods of the lowest mode",
        "Pentland and Williams 1989, Good Vibrations, sect. 3.1.1"}},
      {"collision-cost",
       {"cost ~ m^p of m points against n = m polygons (brute force, tree of boxes) or one analytic shape",
        "Pentland and Williams 1989, Good Vibrations, sect. 4.1; harness/analysis/collision_contest.h"}},
      {"contact-forces",
       {"F = k_n int g dA by samples, or k_n pi delta^2 / sqrt(k_1 k_2) by principal curvatures, against the exact cap",
        "Pentland and Williams 1989, Good Vibrations, sect. 4.2; harness/analysis/contact_contest.h"}},
      {"contact-stiffness",
       {"T(k_n/2), T(k_n), T(2 k_n), likewise F and J of the first touch; k_n a/E* beside; of contacts in turn |x(1.01 "
        "k_n) - x(k_n)|/(0.01 x)",
        ours}},
      {"contact",
       {"f(t) . f*_max/|f*_max|; k_n, E*, a, k_n a/E*; |phi - sum_k a_k m_k|/|phi|; time of search, loads, steps",
        ours}},
      {"flight-cost", {"time ~ (flight time)^p and ~ (steps in contact)^p, least squares in logarithms", ours}},
      {"amplitude",
       {"|d_linear - d_finite|_M / |d_finite|_M of one impact at several speeds; where it passes 1 % and 5 %; its "
        "exponent p over strain",
        ours}},
  };
  return all;
}

}  // namespace

FormulaAndSource formula_of(const std::string& name) {
  for (const auto* table : {&methods(), &integrators(), &analyses()})
    if (const auto it = table->find(name); it != table->end()) return it->second;
  return {};
}

}  // namespace mb
