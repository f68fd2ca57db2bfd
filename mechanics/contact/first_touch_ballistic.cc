#include "mechanics/contact/first_touch_ballistic.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "mechanics/contact/first_touch_search.h"
#include "mechanics/contact/first_touch_support.h"

namespace mb {

namespace {

// m(s) for s in [0, S].
struct Parabola {
  double c, b, a, S;

  double at(double s) const { return c + s * (b + 0.5 * a * s); }
  double lowest() const { return a > 0 ? std::clamp(-b / a, 0.0, S) : at(S) < c ? S : 0; }  // where
  // Where m comes down to 0, of c > 0 and m <= 0 somewhere later.
  double root() const {
    const double square = b * b, product = 2 * a * c;
    const double rounding = std::fma(b, b, -square) - std::fma(2 * a, c, -product);
    const double width = std::sqrt(std::max(0.0, square - product + rounding));
    return std::min(S, b < 0 ? 2 * c / (width - b) : (b + width) / -a);
  }
};

struct Event {
  FirstTouch::Kind kind;
  double s;
};

std::optional<Event> touch(const Parabola& m, double tol) {
  if (m.c <= tol && m.b >= 0) return Event{FirstTouch::grazing, 0};
  const double s = m.lowest(), low = m.at(s);
  if (low > tol) return std::nullopt;
  const bool turns = m.a > 0 && s < m.S;
  if (low > 0 || (turns && low > -tol)) return Event{FirstTouch::grazing, s};
  return Event{FirstTouch::hit, m.c > 0 ? m.root() : 0};
}

// Of m that has left and ends within the tolerance or below.
std::optional<Event> touch_coming_down(const Parabola& m) {
  if (m.at(m.S) > 0) return Event{FirstTouch::grazing, m.S};
  const double top = m.b / -m.a;
  return Event{FirstTouch::hit, top + Parabola{m.at(top), 0, m.a, m.S - top}.root()};
}

// Of m that starts within the tolerance: nothing counts until it has left, but falling by more than tol/2.
std::optional<Event> touch_after_leaving(const Parabola& m, double tol) {
  const bool rises = m.b > 0 || (m.b == 0 && m.a >= 0);
  const double top = !rises ? 0 : m.a < 0 ? std::min(m.S, m.b / -m.a) : m.S;
  const double fall = m.at(top) - std::min(m.at(m.lowest()), m.at(m.S));
  if (m.at(top) > tol) return m.at(m.S) > tol ? std::nullopt : touch_coming_down(m);
  return fall > 0.5 * tol && top < m.S && (!rises || m.a < 0) ? std::optional<Event>({FirstTouch::hit, top})
                                                              : std::nullopt;
}

}  // namespace

std::optional<FirstTouch> first_touch(const Shape& body, const BallisticPath& path, const RigidSurface& half_space,
                                      const TouchSearch& search) {
  require_valid(search);
  if (!std::holds_alternative<HalfSpace>(half_space.shape))
    throw std::invalid_argument("first_touch: the closed form is for half-spaces only");
  if (!(path.position.allFinite() && path.velocity.allFinite() && path.acceleration.allFinite()))
    throw std::invalid_argument("first_touch: the ballistic path is not finite");
  if (!(std::abs(path.orientation.squaredNorm() - 1) < 1e-9))
    throw std::invalid_argument("first_touch: the orientation is not of unit length");
  const Vector3d n = half_space.pose.orientation * Vector3d::UnitZ();
  const Vector3d w = path.orientation.conjugate() * n, X = support_point(body, -w);
  const Vector3d nearest = path.position + path.orientation * X;
  const Parabola m{n.dot(nearest - half_space.pose.position), n.dot(path.velocity), n.dot(path.acceleration),
                   search.t1 - search.t0};
  const double tol = touch_tolerance(
      search, nearest.norm() + path.velocity.norm() * std::abs(search.t0) + half_space.pose.position.norm());
  const auto answer = [&](const Event& e) {
    const Vector3d x = nearest + e.s * (path.velocity + 0.5 * e.s * path.acceleration);
    return FirstTouch{e.kind, search.t0 + e.s, X, x, n, m.at(e.s), 0, 0};
  };
  if (m.c < -std::max(tol, search.leaving ? search.depth : 0)) return answer({FirstTouch::overlap, 0});
  const bool leaving = search.leaving && m.c <= tol;
  const auto event = leaving ? touch_after_leaving(m, tol) : touch(m, tol);
  return event ? std::optional(answer(*event)) : std::nullopt;
}

}  // namespace mb
