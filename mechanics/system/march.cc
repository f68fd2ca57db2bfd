#include "mechanics/system/march.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace mb {

namespace {

void check(const VectorXd& times) {
  for (Index k = 0; k < times.size(); ++k)
    if (!(times[k] >= (k > 0 ? times[k - 1] : 0) && std::isfinite(times[k])))
      throw std::invalid_argument("times must be finite and ascend from 0");
}

// At fraction x of the step from one state to the next, into column k.
void interpolate(const Motion& from, const Motion& to, double x, double h, States& out, Index k) {
  const double h00 = (1 + 2 * x) * (1 - x) * (1 - x), h10 = x * (1 - x) * (1 - x), h01 = x * x * (3 - 2 * x),
               h11 = x * x * (x - 1), d00 = 6 * x * (x - 1), d10 = (1 - x) * (1 - 3 * x), d11 = x * (3 * x - 2);
  out.u.col(k) = h00 * from.u + h10 * h * from.v + h01 * to.u + h11 * h * to.v;
  out.v.col(k) = (d00 / h) * (from.u - to.u) + d10 * from.v + d11 * to.v;
}

}  // namespace

States march(const System& system, double h, const VectorXd& times, const FixedStep& step) {
  check(times);
  const Index n = system.u0.size();
  States out{MatrixXd(n, times.size()), MatrixXd(n, times.size()), {}, Status::ok, 0};
  Motion now{system.u0, system.v0}, next = now;
  const double slack = 1e-9 * h;  // output times that are a step's end up to rounding need no further step
  Index k = 0;
  for (; k < times.size() && times[k] <= slack; ++k) out.u.col(k) = now.u, out.v.col(k) = now.v;
  for (long i = 0; k < times.size(); ++i) {
    const double t0 = static_cast<double>(i) * h, t1 = static_cast<double>(i + 1) * h;
    step(t0, t1, now, next);
    for (; k < times.size() && times[k] <= t1 + slack; ++k)
      interpolate(now, next, std::min(1.0, (times[k] - t0) / h), h, out, k);
    now.u.swap(next.u);
    now.v.swap(next.v);
    ++out.work.steps;
    if (out.work.steps % 64 == 0 && !now.u.allFinite()) break;
  }
  out.work.load_evaluations = out.work.steps;
  while (out.n_valid < k && out.u.col(out.n_valid).allFinite() && out.v.col(out.n_valid).allFinite()) ++out.n_valid;
  if (out.n_valid < times.size()) out.status = Status::not_finite;
  blank_rest(out);
  return out;
}

double checked_step(double h, const char* integrator) {
  if (!(h > 0 && std::isfinite(h)))
    throw std::invalid_argument(fmt::format("{}: the time step must be positive and finite", integrator));
  return h;
}

}  // namespace mb
