#include <algorithm>
#include <cmath>

#include "reference/sundials/arkode.h"

namespace mb::ark {

Factors::Factors(const System& system, double gamma, const ContactForces* contact)
    : system_(system), contact_(contact) {
  add(gamma);
}

void Factors::add(double gamma) {
  used_.push_front({Shifted(system_, gamma), {}, true});
  if (contact_) used_.front().stage.emplace(*contact_, system_.u0.size());
}

void Factors::forget() {
  for (Factor& factor : used_) factor.current = false;
  n_made_ = 0;
}

Factor& Factors::at(double gamma) {
  // ARKODE recomputes an unchanged gamma with rounding.
  const auto known = std::ranges::find_if(
      used_, [&](const Factor& f) { return f.current && std::abs(gamma / f.A.gamma() - 1) <= 1e-12; });
  if (known != used_.end()) {
    used_.splice(used_.begin(), used_, known);
    return used_.front();
  }
  ++n_made_;
  const auto old = std::ranges::find(used_, false, &Factor::current);
  if (old == used_.end() && used_.size() < most) return add(gamma), used_.front();
  used_.splice(used_.begin(), used_, old != used_.end() ? old : std::prev(used_.end()));
  used_.front().A.set_gamma(gamma);
  if (contact_) used_.front().stage->forget();
  used_.front().current = true;
  return used_.front();
}

Parts::Parts(const System& system, double gamma, const std::vector<Contact>& contacts)
    : force(system, UnbalancedForce::Mass::consistent),
      mass(system.M),
      M(system.M),
      contact(contacts.empty() ? std::nullopt : std::optional<ContactForces>(contacts)),
      factors(system, gamma, contact ? &*contact : nullptr),
      finite(system.stored_energy ? std::make_unique<FiniteParts>(system, contact ? &*contact : nullptr) : nullptr) {}

}  // namespace mb::ark
