// A contact history from steps of fixed length: impulse and losses by the trapezoidal rule over the steps' ends, which
// is what average acceleration and central differences hand over, and lines between them.
#pragma once

#include "mechanics/contact/contact_forces.h"
#include "mechanics/contact/touches.h"

namespace mb {

class ContactRecord {
 public:
  explicit ContactRecord(const ContactForces& forces) : forces_(forces) {}  // which must outlive this

  // The state at the end of a step, or at the start; t ascending.
  const ContactSum& add(double t, const VectorXd& u, const VectorXd& v);
  void add(double t, const ContactSum& now);  // what acts there, found already

  // At times [s] with states u, v (n x number of times), of which the first n_valid count.
  ContactHistory history(const VectorXd& times, const MatrixXd& u, const MatrixXd& v, Index n_valid) const;

 private:
  struct Moment {
    double t;
    Vector3d impulse;
    double dissipated;
  };
  const ContactForces& forces_;
  std::vector<Moment> moments_;
  ContactSum last_{};
  TouchLog log_;
  VectorXd f_;
};

}  // namespace mb
