// When bodies in flight next touch anything: rigid obstacles by next_touch.h, each other in two phases,
//
//   broad    d(t) = distance of a's centre from b's shape at rest - radius of a - |u_a| - |u_b| >= d(t0) - way(t - t0):
//            swept bounds; while d > 0 nothing touches, and time goes on by what d takes to be used up
//            (conservative advancement: Mirtich & Canny 1995, Proc. Symp. Interactive 3D Graphics)
//   near     the same with d the least gap of a's samples, and the speed of their surfaces what vibration will hardly
//            exceed: three times the root mean square of where all modes have their greatest, or all at once
//   narrow   the least gap of a's samples, in steps of contact; its first zero by chords and halves
//
// Convex bodies close in along the normal n where they are nearest: with relative velocity w and pull p
//
//   d(t) >= d(t0) + n . w (t - t0) - p (t - t0)^2 / 2
//
// so that what parts is looked at again only when it has had time to come back.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "modal/contact/body_pair.h"
#include "modal/contact/next_touch.h"

namespace mb {

class Meetings {
 public:
  explicit Meetings(std::span<const ImpactPlan> plans);  // which must outlive this
  // The earliest from the flights' common start to `end` [s]; nothing where there is none. leaving: as next_touch.
  std::optional<NextTouch> next(const std::vector<BodyFlight>& flights, double end, bool leaving);

 private:
  struct Pair {
    size_t a, b;
    double radius;  // [m] of a
    std::unique_ptr<BodyPair> pair;
  };
  struct Sight {  // of both at a time
    double t;     // [s]
    BodyState a, b;
    VectorXd rate_a, rate_b;
    Vector3d Omega_a, Omega_b;
  };
  Sight see(const Pair& of, const std::vector<BodyFlight>& flights, double t) const;
  std::optional<NextTouch> next(Pair& of, const std::vector<BodyFlight>& flights, double end) const;
  // [s] for how long they cannot meet from then on.
  double clear_for(const Pair& of, const Sight& now, double end) const;
  double least_gap(Pair& of, const Sight& now) const;
  double open_for(const Pair& of, const Sight& now) const;  // [s] for how long the gaps will hardly close
  // Of gaps [m] at both ends, the latter < 0.
  double first_zero(Pair& of, const std::vector<BodyFlight>& flights, double from, double to, double gap_from,
                    double gap_to) const;

  std::span<const ImpactPlan> plans_;
  std::vector<Pair> pairs_;
};

}  // namespace mb
