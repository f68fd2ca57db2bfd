// What is written down of a contact while a body is stepped: force, impulse and losses at the times asked for, and each
// touch, from the first point that presses to the last,
//
//   start, end   gap = 0        peak   parabola through the three steps about the largest |F|        impulse = int F dt
//
// Separations shorter than a tenth of the longer touch beside them belong to it: a vibrating surface lets go and comes
// back.
#pragma once

#include <optional>
#include <vector>

#include "mechanics/types.h"

namespace mb {

struct Touch {
  double start, end;             // [s]; end: infinity while it lasts
  double peak_force, peak_time;  // [N] of |F|, [s]
  Vector3d impulse;              // [N s] on the body
};

struct ContactHistory {
  Matrix3Xd force, impulse;     // [N], [N s] since t = 0, on the body; 3 x number of times
  VectorXd stored, dissipated;  // [J] in the layer; [J] lost in it and to friction since t = 0
  std::vector<Touch> touches;   // ascending
};

// What the other of two bodies feels of it; what is stored and lost between them counts with the first.
ContactHistory opposite(const ContactHistory& of_first);

// One state that a stepper came to.
struct ContactMoment {
  double t;          // [s]
  double least_gap;  // [m] of all points
  Vector3d force;    // [N]
  Vector3d impulse;  // [N s] since t = 0, by the integrator's own quadrature
};

class TouchLog {
 public:
  void add(const ContactMoment& now);  // t ascending
  // Surfaces meet at t [s]: the touch that comes next starts then, although points between them press a little later.
  void meet(double t) { met_ = t; }
  std::vector<Touch> touches() const;

 private:
  void open(const ContactMoment& now);
  void close(const ContactMoment& now);
  void look_for_peak(const ContactMoment& now);

  std::vector<Touch> touches_;
  std::vector<ContactMoment> last_;  // two at most
  Vector3d impulse_at_start_ = Vector3d::Zero();
  bool touching_ = false;
  std::optional<double> met_;
};

}  // namespace mb
