#include "modal/contact/soundness.h"

#include <cmath>
#include <utility>

namespace mb {

namespace {

constexpr double most_gain = 1;  // [-] of the energy at hand

}  // namespace

Soundness::Soundness(std::vector<const FloatingBody*> bodies, const std::vector<double>& sizes)
    : bodies_(std::move(bodies)) {
  for (size_t b = 0; b < bodies_.size(); ++b) {
    const FloatingBody& body = *bodies_[b];
    weight_ += sizes.at(b) * (body.mass * body.gravity.norm() + std::sqrt(body.mass) * body.weight.norm());
  }
}

double Soundness::total(std::span<const ContactState> now) const {
  double sum = 0;
  for (size_t b = 0; b < now.size(); ++b)
    sum += mechanical_energy(*bodies_[b], now[b].body) + now[b].load.stored + now[b].dissipated;
  return sum;
}

void Soundness::begin(std::span<const ContactState> touching) {
  double at_hand = weight_;
  for (size_t b = 0; b < touching.size(); ++b) {
    const FloatingBody& body = *bodies_[b];
    const BodyState& at = touching[b].body;
    at_hand += mechanical_energy(body, at) + body.weight.dot(at.q) +
               (body.free ? body.mass * body.gravity.dot(at.c) : 0) + touching[b].load.stored;
  }
  most_ = total(touching) + most_gain * at_hand;
}

Status Soundness::operator()(std::span<const ContactState> now) const {
  const double energy = total(now);
  for (const ContactState& state : now)
    if (!is_finite(state.body)) return Status::not_finite;
  if (!std::isfinite(energy)) return Status::not_finite;
  return energy > most_ ? Status::unstable : Status::ok;
}

}  // namespace mb
