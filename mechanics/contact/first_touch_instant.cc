#include "mechanics/contact/first_touch_instant.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mb {

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

// Of m, by the normal that is carried on.
double slope(const Instant& now) { return now.near.normal.dot(now.near.motion.v); }

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

  // The root after a steep descent, from before it: where both have edges the nearest point of a gap near 0 is blurred
  // by rounding, and m has a kink. But the plane between body and obstacle keeps a direction, and the gap that it
  // leaves has the values and slopes of m: a parabola through two of them, at a hundred millionth of the body's size.
  // Nothing where the descent is not steep enough for that, or not deep enough for a hit.
  std::optional<Instant> steep_root(const Instant& front, double t0, double t1, double size, double tolerance) const {
    Instant from = front;
    for (double room = std::max(1e-8 * size, 2 * descent_.plane_gap(front.near));;) {
      const double guess = from.t - descent_.plane_gap(from.near) / slope(from), span = room / -slope(from);
      if (!(span > 0 && guess - span >= t0 && guess - 0.5 * span < guess)) return std::nullopt;
      const Instant one = at(guess - span, from), two = at(guess - 0.5 * span, one);
      const auto root = meeting(one, two, tolerance);
      if (!root || room <= 1e-8 * size)
        return root && root->t <= t1 && std::abs(root->gap()) <= tolerance ? root : std::nullopt;
      from = two;
      room = std::max(1e-8 * size, 1e-3 * room);
    }
  }

  // Where the parabola of the plane's gap meets 0, and goes on well below the tolerance.
  std::optional<Instant> meeting(const Instant& one, const Instant& two, double tolerance) const {
    const double slope1 = slope(one), slope2 = slope(two), gap = descent_.plane_gap(two.near);
    if (!(slope2 < 0 && slope1 < 0.5 * slope2 && slope1 > 2 * slope2)) return std::nullopt;
    const double bend = (slope2 - slope1) / (two.t - one.t), width = slope2 * slope2 - 2 * bend * gap;
    if (!(width > 8 * std::max(0.0, bend) * tolerance)) return std::nullopt;
    Instant root{two.t + 2 * gap / (std::sqrt(width) - slope2), two.near};
    PatchPoint& point = root.near.at;
    if (const PatchPoint& p = one.near.at; p.patch == point.patch) {
      const double on = (root.t - two.t) / (two.t - one.t);
      point.s = std::clamp(point.s + on * (point.s - p.s), 0.0, 1.0);
      point.t = std::clamp(point.t + on * (point.t - p.t), 0.0, 1.0);
    }
    root.near = descent_.at(point, root.t);
    root.near.normal = two.near.normal;
    return root;
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

std::optional<TouchInstant> touch_instant(const Descent& descent, const Instant& front, double t0, double before,
                                          double t1, double tolerance, double size) {
  const Course m(descent);
  if (auto root = m.steep_root(front, t0, t1, size, tolerance)) return TouchInstant{FirstTouch::hit, *root};
  const Instant a = m.at(front.t, front);
  const auto graze = [&](const Instant& low) {
    return low.gap() <= tolerance ? std::optional<TouchInstant>({FirstTouch::grazing, low}) : std::nullopt;
  };
  const auto hit = [&](const Instant& low) { return TouchInstant{FirstTouch::hit, a.gap() > 0 ? m.root(a, low) : a}; };
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
