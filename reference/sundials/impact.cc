#include "mechanics/contact/touches.h"
#include "reference/sundials/arkode.h"
#include "reference/sundials/sundials.h"

#include <arkode/arkode.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace mb {

namespace {

// Impacts take about displacement / velocity of their scale: a step of some of them could jump over one.
constexpr double longest_step = 4;  // [-]

ark::Scales scales_of(const std::vector<Contact>& contacts) {
  ark::Scales largest{0, 0};
  for (const Contact& c : contacts) {
    if (!(c.scale.displacement > 0 && c.scale.velocity > 0 && std::isfinite(c.scale.displacement / c.scale.velocity)))
      throw std::invalid_argument("sundials: the scales of a contact must be positive and finite");
    largest.displacement = std::max(largest.displacement, c.scale.displacement);
    largest.velocity = std::max(largest.velocity, c.scale.velocity);
  }
  return largest;
}

// The end of a step. Between two of them u and v are ARKODE's own dense output; what is made of differences of large
// things is not found from these, but from its values at both ends: the layer, a hundred times as stiff as the body,
// would show every error of u in its force.
struct StepEnd {
  double t;
  ContactSum sum;
  Vector3d impulse;
  double dissipated, energy;
};

// What f is more than linear, x (1 - x) times it, so that its integral is the impulse; where it is less, no more than
// leaves it pushing:  a (1 - x) + b x - c x (1 - x) >= 0  for  c <= (sqrt a + sqrt b)^2.
Vector3d bulge(const StepEnd& a, const StepEnd& b) {
  const Vector3d sum = a.sum.force + b.sum.force, bulge = 6 / (b.t - a.t) * (b.impulse - a.impulse) - 3 * sum;
  if (bulge.dot(sum) > 0) return bulge;
  const double most = std::pow(std::sqrt(a.sum.force.norm()) + std::sqrt(b.sum.force.norm()), 2);
  return std::min(1.0, most / bulge.norm()) * bulge;
}

// J by Hermite's cubic with J' = f at both ends, f by its derivative; energies are nearly kept, and linear.
void record_between(const StepEnd& a, const StepEnd& b, double t, Index k, States& out) {
  const double h = b.t - a.t, x = h > 0 ? (t - a.t) / h : 1;
  const Vector3d change = b.impulse - a.impulse;
  out.contact.impulse.col(k) =
      a.impulse + x * x * (3 - 2 * x) * change + h * x * (1 - x) * ((1 - x) * a.sum.force - x * b.sum.force);
  out.contact.force.col(k) = (1 - x) * a.sum.force + x * b.sum.force;
  if (h > 0) out.contact.force.col(k) += x * (1 - x) * bulge(a, b);
  out.contact.stored[k] = (1 - x) * a.sum.stored + x * b.sum.stored;
  out.contact.dissipated[k] = (1 - x) * a.dissipated + x * b.dissipated;
  out.energy[k] = (1 - x) * a.energy + x * b.energy;
}

class SundialsInContact final : public Stepper {
 public:
  SundialsInContact(const System& system, const std::vector<Contact>& contacts, double tolerance, double duration)
      : system_(system),
        accuracy_{tolerance, scales_of(contacts), false, 0},
        load_(VectorXd::Zero(system.u0.size())),
        meet_(std::ranges::any_of(contacts, &Contact::meets)),
        parts_(system, accuracy_.scales.displacement / accuracy_.scales.velocity / 100, contacts) {
    const auto& [displacement, velocity] = accuracy_.scales;
    accuracy_.longest_step = std::min(duration / 4, longest_step * displacement / velocity);
    for (const History& s : system.s)
      if (!breakpoints(s, duration).empty()) throw std::invalid_argument("sundials: in contact loads must be steady");
    if (system.F.cols() > 0) load_ = system.F * LoadFactors(system)(0);
  }

  States run(const VectorXd& times) const override {
    const Index n = system_.u0.size(), n_t = times.size();
    const VectorXd unknown = VectorXd::Constant(n_t, std::numeric_limits<double>::quiet_NaN());
    States out{MatrixXd(n, n_t), MatrixXd(n, n_t), {}, Status::ok, 0, {}, unknown};
    out.contact = {unknown.transpose().replicate<3, 1>(), unknown.transpose().replicate<3, 1>(), unknown, unknown, {}};
    ark::Run run(system_, parts_, accuracy_);
    TouchLog log;
    if (meet_) log.meet(0);
    StepEnd last = end(run, 0), now = last;
    note(last, log);
    while (out.n_valid < n_t) {
      while (out.n_valid < n_t && times[out.n_valid] <= now.t) {
        if (now.t > last.t) run.look_at(times[out.n_valid]);
        const Index k = out.n_valid++;
        out.u.col(k) = run.displacement();
        out.v.col(k) = run.velocity();
        record_between(last, now, times[k], k, out);
      }
      if (out.n_valid == n_t) break;
      double t = now.t;
      const int flag = run.step(times[n_t - 1], t);
      if (flag < 0 || !run.displacement().allFinite()) {
        out.status = flag < 0 ? run.status_of(flag) : Status::not_finite;
        break;
      }
      last = std::exchange(now, end(run, t));
      note(now, log);
    }
    blank_rest(out);
    out.contact.touches = log.touches();
    out.work = run.work();
    out.work.factorisations += 1;  // of the mass
    return out;
  }

 private:
  StepEnd end(ark::Run& run, double t) const {
    const ContactSum sum = run.contact();
    const VectorXd u = run.displacement();
    const double mechanical = kinetic_energy(system_, run.velocity()) + strain_energy(system_, u) - load_.dot(u);
    return {t, sum, run.quadratures().head<3>(), run.quadratures()[3], mechanical + sum.stored};
  }
  static void note(const StepEnd& now, TouchLog& log) {
    log.add({now.t, now.sum.least_gap, now.sum.force, now.impulse});
  }

  const System& system_;
  ark::Accuracy accuracy_;
  VectorXd load_;  // [N] steady
  bool meet_;      // any surfaces, at the start
  mutable ark::Parts parts_;
};

}  // namespace

std::unique_ptr<Stepper> sundials(const System& system, const std::vector<Contact>& contacts, double tolerance,
                                  double duration) {
  if (contacts.empty()) return sundials(system, tolerance, duration);
  if (!(tolerance >= 1e-12 && tolerance <= 1e-2))
    throw std::invalid_argument("sundials: the relative tolerance must lie in [1e-12, 1e-2]");
  if (!(duration > 0)) throw std::invalid_argument("sundials: the duration must be positive");
  return std::make_unique<SundialsInContact>(system, contacts, tolerance, duration);
}

}  // namespace mb
