// Time histories s(t), dimensionless factors on a load. All are zero before their start, right-continuous at jumps.
//
//   step      s = A                          t >= start
//   pulse     s = A sin^2(pi (t-start)/T)    0 <= t-start < T, zero after
//   ramp      s = A (t-start)/T              0 <= t-start < T, then A
//   harmonic  s = A sin(omega (t-start) + phase)                       t >= start
//   chirp     s = A sin(phi(t-start)), phi' = omega0 + (omega1-omega0) tau/T, for T; zero after
//   table     linear between (t_i, s_i); zero before the first and after the last
//   expression   a formula in t (muParser)
//
// All but chirp and expression are *exactly* a chain of segments, each a line plus one cosine wave: what the
// closed-form integrator needs. Chirp and expression are resampled linearly to a stated load error, which is returned.
#pragma once

#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace mb {

struct Step {
  double amplitude = 1, start = 0;
};
struct Pulse {
  double duration; /* [s] > 0 */
  double amplitude = 1, start = 0;
};
struct Ramp {
  double duration; /* [s] > 0 */
  double amplitude = 1, start = 0;
};
struct Harmonic {
  double omega;     /* [rad/s] > 0 */
  double phase = 0; /* [rad] */
  double amplitude = 1, start = 0;
};
struct Chirp {
  double omega0, omega1; /* [rad/s] >= 0 */
  double duration;       /* [s] > 0 */
  double amplitude = 1, start = 0;
};
struct Table {
  std::vector<double> t; /* [s] strictly ascending, >= 2 entries */
  std::vector<double> s;
};
struct Expression {
  std::string formula; /* in t [s], constant pi; grammar in expression.h */
};

using History = std::variant<Step, Pulse, Ramp, Harmonic, Chirp, Table, Expression>;

bool operator==(const Step&, const Step&);
bool operator==(const Pulse&, const Pulse&);
bool operator==(const Ramp&, const Ramp&);
bool operator==(const Harmonic&, const Harmonic&);
bool operator==(const Chirp&, const Chirp&);
bool operator==(const Table&, const Table&);
bool operator==(const Expression&, const Expression&);

// On [start, end):  s(t) = c0 + c1 tau + a cos(omega tau) + b sin(omega tau),  tau = t - start.
struct Segment {
  double start, end, c0 = 0, c1 = 0, a = 0, b = 0, omega = 0;
};
double value(const Segment& segment, double t);
// The same line and wave on [start, end), with tau counted from the new start.
Segment rebased(const Segment& segment, double start, double end);

// Segments that tile [0, duration] without gaps, and the largest |s - segments| as measured (0 where exact), relative
// to max |s| of a chirp, to max(mean |s|, |s|) of an expression.
struct Segments {
  std::vector<Segment> pieces;
  double load_error = 0;  // [-]
};

// s(t). Throws std::domain_error where an expression is not well formed or not finite. Compiles an expression anew.
double value(const History& history, double t);
// s as a function, its expression compiled once: for those who evaluate it often. Copies share one compiled expression,
// so that one evaluator serves one thread.
std::function<double(double)> evaluator(const History& history);

// Times in (0, duration) where s, s' or s'' may jump, ascending: adaptive steps end there. None of an expression.
std::vector<double> breakpoints(const History& history, double duration);

// Whether s jumps in [0, duration), from 0 at the start or between two segments, by more than a ten-thousandth of its
// peak: less may be what resampling leaves.
bool jumps(const History& history, double duration);

// tolerance [-]: largest load_error; only chirp and expression use it.
// Throws std::domain_error where the history is not finite or cannot be resampled within 100,000 pieces, and
// std::invalid_argument (as do breakpoints and peak) where an argument or a number of the history is out of range.
Segments segments(const History& history, double duration, double tolerance = 1e-6);

// [s] From then to the duration s = 0; infinity where it does not end before it. Of an expression as resampled.
double end(const History& history, double duration);

// Supremum of |s| on [0, duration]; of an expression to 1 % (peak.h).
double peak(const History& history, double duration);

// Empty when the formula is well formed and finite on [0, duration], shown by bounds on intervals (peak.h), and at
// `times` [s]; else one sentence that says why not.
std::string expression_problem(const std::string& formula, double duration, const std::vector<double>& times = {});

}  // namespace mb
