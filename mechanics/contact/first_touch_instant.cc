#include "mechanics/contact/first_touch_instant.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mb {

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

class Course {
 public:
  explicit Course(const Descent& descent) : descent_(descent) {}
  Instant at(double t, const Instant& from) const { return {t, descent_.nearest(from.near.at, t)}; }

  // m(a) > 0 >= m(b): Newton's method within the bracket, which halves where that is slow.
  Instant root(Instant a, Instant b) const {
    Instant best = std::abs(b.gap()) < std::abs(a.gap()) ? b : a;
    double width = infinity;
    for (int i = 0; i < 100; ++i) {
      const double newton = best.t - best.gap() / best.rate(), middle = a.t + 0.5 * (b.t - a.t);
      const bool good = newton > a.t && newton < b.t && std::abs(newton - best.t) < 0.5 * width;
      const double t = good ? newton : middle;
      if (!(t > a.t && t < b.t)) break;
      width = std::abs(t - best.t);
      const Instant now = at(t, best);
      (now.gap() > 0 ? a : b) = now;
      if (std::abs(now.gap()) <= std::abs(best.gap())) best = now;
      if (now.gap() == 0 || width <= eps * std::abs(t)) break;
    }
    return best;
  }

  // A root of m from just before it: where the obstacle has edges the nearest point of a gap near 0 is blurred by
  // rounding, and m has a kink; but the plane between body and obstacle (the gap it leaves has the values and slopes of
  // m) has a direction still. By the parabola through its gaps at 1 and 1/2 of a hundred millionth of the body's size.
  Instant sharpened(const Instant& root, double size, double tolerance) const {
    const double rate = root.near.normal.dot(root.near.motion.v), span = 1e-8 * size / -rate;
    if (!(rate < 0)) return root;
    const Instant one = at(root.t - span, root), two = at(root.t - 0.5 * span, one);
    const double slope1 = one.near.normal.dot(one.near.motion.v), slope2 = two.near.normal.dot(two.near.motion.v);
    if (!(slope2 < 0 && slope1 < 0.5 * slope2 && slope1 > 2 * slope2)) return root;
    const double gap = descent_.plane_gap(two.near), bend = (slope2 - slope1) / (two.t - one.t);
    const double s = 2 * gap / (-slope2 + std::sqrt(std::max(0.0, slope2 * slope2 - 2 * bend * gap)));
    Instant sharp{two.t + s, two.near};
    PatchPoint& point = sharp.near.at;
    if (const PatchPoint& p = one.near.at; p.patch == point.patch) {
      const double on = s / (two.t - one.t);
      point.s = std::min(1.0, std::max(0.0, point.s + on * (point.s - p.s)));
      point.t = std::min(1.0, std::max(0.0, point.t + on * (point.t - p.t)));
    }
    sharp.near = descent_.at(point, sharp.t);
    sharp.near.normal = two.near.normal;
    return std::abs(sharp.t - root.t) <= -4 * tolerance / slope2 && std::abs(sharp.gap()) <= tolerance ? sharp : root;
  }

  // m'(a) < 0 <= m'(b): the false position (Illinois) on m'.
  Instant turn(Instant a, Instant b) const {
    double fa = a.rate(), fb = b.rate();
    for (int i = 0; i < 100; ++i) {
      double t = a.t + (b.t - a.t) * (fa / (fa - fb));
      if (i % 4 == 3) t = a.t + 0.5 * (b.t - a.t);
      if (!(t > a.t && t < b.t)) break;
      const Instant now = at(t, a);
      const double rate = now.rate();
      if (rate < 0) {
        if (fa < 0 && i > 0 && now.t - a.t > 0) fb *= 0.5;
        a = now, fa = rate;
      } else {
        fa *= 0.5;
        b = now, fb = rate;
      }
      if (std::abs(rate) == 0 || b.t - a.t <= 4 * eps * std::abs(t)) break;
    }
    return a.gap() < b.gap() ? a : b;
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  const Descent& descent_;
};

}  // namespace

std::optional<TouchInstant> touch_instant(const Descent& descent, const Instant& front, double before, double t1,
                                          double tolerance, double size) {
  const Course m(descent);
  const Instant a = m.at(front.t, front);
  const auto graze = [&](const Instant& low) {
    return low.gap() <= tolerance ? std::optional<TouchInstant>({FirstTouch::grazing, low}) : std::nullopt;
  };
  const auto hit = [&](const Instant& low) {
    return TouchInstant{FirstTouch::hit, a.gap() > 0 ? m.sharpened(m.root(a, low), size, tolerance) : a};
  };
  if (a.rate() >= 0) {
    if (!(before < a.t)) return graze(a);
    const Instant earlier = m.at(before, a);
    return graze(earlier.rate() < 0 ? m.turn(earlier, a) : a);
  }
  Instant from = a;
  double step = std::max(2 * (std::abs(a.gap()) + tolerance) / -a.rate(), 4 * eps * std::abs(a.t));
  while (true) {
    const Instant to = m.at(std::min(t1, from.t + step), from);
    if (to.gap() <= -tolerance) return hit(to);
    if (to.rate() >= 0) {
      const Instant low = m.turn(from, to);
      if (low.gap() <= -tolerance) return hit(low);
      return graze(low);
    }
    if (to.t >= t1) {
      if (to.gap() <= 0) return hit(to);
      return graze(to);
    }
    from = to;
    step *= 2;
  }
}

}  // namespace mb
