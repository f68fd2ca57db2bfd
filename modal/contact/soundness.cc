#include "modal/contact/soundness.h"

#include <cmath>

namespace mb {

namespace {

constexpr double most_gain = 1;  // [-] of the energy at hand

}  // namespace

Soundness::Soundness(const FloatingBody& body, double size)
    : body_(body), weight_(size * (body.mass * body.gravity.norm() + std::sqrt(body.mass) * body.weight.norm())) {}

double Soundness::total(const ContactState& now) const {
  return mechanical_energy(body_, now.body) + now.load.stored + now.dissipated;
}

void Soundness::begin(const ContactState& touching) {
  const BodyState& at = touching.body;
  const double at_hand = mechanical_energy(body_, at) + body_.weight.dot(at.q) +
                         (body_.free ? body_.mass * body_.gravity.dot(at.c) : 0) + weight_;
  most_ = total(touching) + most_gain * (at_hand + touching.load.stored);
}

Status Soundness::operator()(const ContactState& now) const {
  const double energy = total(now);
  if (!is_finite(now.body) || !std::isfinite(energy)) return Status::not_finite;
  return energy > most_ ? Status::unstable : Status::ok;
}

}  // namespace mb
