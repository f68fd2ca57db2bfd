// One body against one obstacle, ready for many evaluations, each in three parts: look, push as often as the static
// shapes need, act.
#pragma once

#include <memory>

#include "modal/contact/contact_load.h"

namespace mb {

class SampledPair {
 public:
  virtual ~SampledPair() = default;
  // Takes in a state: the samples in reach, their gaps and rates but for the static shapes. Omega [rad/s] world; rate
  // [m kg^1/2 / s] q'.
  virtual void look(const BodyState& state, const Vector3d& Omega, const VectorXd& rate) = 0;
  // Adds sum Psi_i^T Q^T f_i to f_s and what it loses by s, - d f_s / d s, to H.
  virtual void push(const VectorXd& s, VectorXd& f_s, MatrixXd& H) = 0;
  // Whether no sample beyond those looked at can press with static shapes s; if not, look again.
  virtual bool covers(const VectorXd& s) = 0;
  virtual void act(const VectorXd& s, ContactLoad& load) = 0;  // adds to all of it
  // Adds -df/dz - rate df/dz' to K, for z = (d, theta, q, s): what frame (of a free body: translation and rotation,
  // world), modes and static shapes feel of each other. rate [1/s].
  virtual void stiffen(const VectorXd& s, double rate, MatrixXd& K) = 0;
};

// Against a half-space without friction. The body and the contact must outlive them.
std::unique_ptr<SampledPair> flat_pair(const FloatingBody& body, const SampledContact& contact);
// Against anything.
std::unique_ptr<SampledPair> general_pair(const FloatingBody& body, const SampledContact& contact);

}  // namespace mb
