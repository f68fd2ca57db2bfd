#include "mechanics/contact/touches.h"
#include "reference/sundials/arkode.h"
#include "reference/sundials/sundials.h"

#include <arkode/arkode.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

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

class SundialsInContact final : public Stepper {
 public:
  SundialsInContact(const System& system, const std::vector<Contact>& contacts, double tolerance, double duration)
      : system_(system),
        accuracy_{tolerance, scales_of(contacts), false, 0},
        parts_(system, accuracy_.scales.displacement / accuracy_.scales.velocity / 100, contacts) {
    const auto& [displacement, velocity] = accuracy_.scales;
    accuracy_.longest_step = std::min(duration / 4, longest_step * displacement / velocity);
    for (const History& s : system.s)
      if (!breakpoints(s, duration).empty()) throw std::invalid_argument("sundials: in contact loads must be steady");
  }

  States run(const VectorXd& times) const override {
    const Index n = system_.u0.size(), n_t = times.size();
    States out{MatrixXd(n, n_t), MatrixXd(n, n_t), {}, Status::ok, 0, {}};
    out.contact = {Matrix3Xd(3, n_t), Matrix3Xd(3, n_t), VectorXd(n_t), VectorXd(n_t), {}};
    ark::Run run(system_, parts_, accuracy_);
    TouchLog log;
    log.meet(0);
    double t = 0;
    const auto note = [&] {
      const ContactSum sum = run.contact();
      log.add({t, sum.least_gap, sum.force, run.quadratures().head<3>()});
      return sum;
    };
    write(run, note(), out, times);
    while (out.n_valid < n_t) {
      const int flag = run.step(times[n_t - 1], t);
      if (flag < 0 || !run.displacement().allFinite()) {
        out.status = flag < 0 ? ark::status_of(flag) : Status::not_finite;
        break;
      }
      note();
      while (out.n_valid < n_t && times[out.n_valid] <= t) {
        run.look_at(times[out.n_valid]);
        record(run, run.contact(), out);
      }
    }
    out.contact.touches = log.touches();
    out.work = run.work();
    out.work.factorisations += 1;  // of the mass
    return out;
  }

 private:
  // Times at the start.
  static void write(ark::Run& run, const ContactSum& sum, States& out, const VectorXd& times) {
    while (out.n_valid < times.size() && times[out.n_valid] <= 0) record(run, sum, out);
  }
  static void record(ark::Run& run, const ContactSum& sum, States& out) {
    const Index k = out.n_valid++;
    out.u.col(k) = run.displacement();
    out.v.col(k) = run.velocity();
    out.contact.force.col(k) = sum.force;
    out.contact.impulse.col(k) = run.quadratures().head<3>();
    out.contact.stored[k] = sum.stored;
    out.contact.dissipated[k] = run.quadratures()[3];
  }

  const System& system_;
  ark::Accuracy accuracy_;
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
