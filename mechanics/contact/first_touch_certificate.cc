#include "mechanics/contact/first_touch_certificate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "mechanics/contact/first_touch_support.h"

namespace mb {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double part = 0.99;  // of the time that the nearest points leave: the rest is room for cells to be proved
constexpr size_t most_cells = 3'000;       // of one level
constexpr long most_evaluations = 40'000;  // of one proof

// gap(x) >= gap + n . (x - y)
struct Plane {
  Vector3d n, y;
  double gap;
};

// What is left of w for the distance from C, e of the header.
enum class Rest { nothing, along_s, along_t, tangent };
constexpr Rest rests[] = {Rest::tangent, Rest::nothing, Rest::along_s, Rest::along_t};

// G(dt) of the header, for one plane and one cell; the cell may be the whole body or a point, with `nothing` for e.
class Bound {
 public:
  Bound(const Shape& shape, const Plane& plane, const SurfaceCell& cell, const PointMotion& motion,
        const MotionBounds& bounds)
      : shape_(shape),
        cell_(cell),
        gap_(plane.gap + plane.n.dot(motion.x - plane.y)),
        rate_(plane.n.dot(motion.v)),
        curving_(bounds.spread - std::min(0.0, plane.n.dot(bounds.acceleration))),
        bend_(0.5 * cell.radius * cell.radius * bounds.bend),
        bend_rate_(0.5 * cell.radius * cell.radius * bounds.bend_rate),
        w_(motion.F.transpose() * plane.n),
        w_rate_(motion.F_rate.transpose() * plane.n) {}

  double of_point(double dt) const { return gap_ + dt * (rate_ - 0.5 * curving_ * dt); }  // C alone
  double bending(double dt) const { return bend_ + bend_rate_ * dt; }
  double operator()(double dt, Rest rest) const {
    const Vector3d w = w_ + dt * w_rate_;
    const double of_cell = of_point(dt) - bending(dt);
    if (rest == Rest::tangent)  // the support point of -(w - e) is C, where w points inwards
      return of_cell - (w - std::min(0.0, w.dot(cell_.normal)) * cell_.normal).norm() * cell_.radius;
    const Vector3d e = remaining(w, rest);
    return of_cell - e.norm() * cell_.radius + (w - e).dot(support_point(shape_, e - w) - cell_.X);
  }

  bool proves(double level, double dt) const {
    return gap_ > level && std::any_of(std::begin(rests), std::end(rests), [&](Rest rest) {
             return (*this)(0, rest) > level && (*this)(dt, rest) > level;
           });
  }

  // The normal of a plane for which e is 0: it has the body's own direction there, whatever the obstacle's.
  Vector3d adapted(const PointMotion& motion, Rest rest) const {
    return motion.F.transpose().partialPivLu().solve(w_ - remaining(w_, rest)).normalized();
  }

  // The same where n may only turn as the obstacle's normal does, along the direction of its greatest curvature: that
  // keeps it across the obstacle's edges.
  Vector3d turned(const PointMotion& motion, const Gap& own, Rest rest) const {
    Index steepest;
    own.hessian.colwise().squaredNorm().maxCoeff(&steepest);
    const Vector3d q = own.hessian.col(steepest).normalized(), along = remaining(motion.F.transpose() * q, rest);
    return (own.normal - q * (w_.dot(along) / along.squaredNorm())).normalized();
  }

  // The time until C alone may be at the level: root of of_point, without cancellation.
  double time_of_point(double level) const {
    const double room = gap_ - level;
    if (!(room > 0)) return 0;
    const double root = std::sqrt(rate_ * rate_ + 2 * curving_ * room);
    return rate_ < 0 ? 2 * room / (root - rate_) : curving_ > 0 ? (rate_ + root) / curving_ : infinity;
  }

 private:
  Vector3d remaining(const Vector3d& w, Rest rest) const {
    if (rest == Rest::nothing) return Vector3d::Zero();
    if (rest == Rest::tangent) return w - w.dot(cell_.normal) * cell_.normal;
    const Vector3d tangent = cell_.tangents.col(rest == Rest::along_s ? 0 : 1);
    return w.dot(tangent) * tangent;
  }

  const Shape& shape_;
  const SurfaceCell& cell_;
  double gap_, rate_, curving_, bend_, bend_rate_;
  Vector3d w_, w_rate_;
};

// The last dt up to the horizon with G >= level, from below; 0 where G(0) is not above. G is concave: a chord's root
// has G >= level, the root of the line through two points on the left has G <= level.
template <class Function>
double last_above(const Function& G, double level, double horizon) {
  double left = 0, above = G(0.0) - level, right = horizon, below = G(horizon) - level;
  if (!(above > 0)) return 0;
  if (below >= 0) return horizon;
  const double margin = 5e-4 * above;  // what chords aim at, that rounding does not make them fail
  for (int i = 0; i < 20 && above > 2 * margin; ++i) {
    const double chord = left + (right - left) * ((above - margin) / (above - below));
    const double value = G(chord) - level;
    if (!(value > 0)) return left;
    const double line = chord + (chord - left) * (value / (above - value));
    left = chord;
    if (value < above && line < right) right = line, below = G(right) - level;
    above = value;
    if (below >= 0) return right;
  }
  return left;
}

// A cell not proved yet, and the planes that may do it.
struct Open {
  size_t place;  // in its level
  std::array<Plane, 8> planes;
  size_t n_planes;
};

class Prover {
 public:
  Prover(const Clearance& now, TouchSurface& surface, CountedMotion& motion, const RigidSurface& obstacle)
      : now_(now), surface_(surface), motion_(motion), obstacle_(obstacle), shape_(surface.shape()) {}
  Proof run();

 private:
  Plane best_plane(const SurfaceCell& body, const PointMotion& centre) const;
  std::optional<double> whole_body(const Bound& bound) const;
  Bound bound(const Plane& plane, size_t place) const {
    return {shape_, plane, surface_.cell(cells_[place]), motions_[place], now_.bounds};
  }
  int look(const Plane& plane);
  void split();
  bool proves(const Open& open) const;
  double last(const Open& open) const;

  const Clearance& now_;
  TouchSurface& surface_;
  CountedMotion& motion_;
  const RigidSurface& obstacle_;
  const Shape& shape_;
  double dt_ = 0;  // what is being proved: cells make it shorter
  bool spent_ = false;
  std::vector<int> cells_;  // of one level, and what is known of them
  std::vector<Vector3d> X_;
  std::vector<PointMotion> motions_;
  std::vector<Open> open_;
};

Plane Prover::best_plane(const SurfaceCell& body, const PointMotion& centre) const {
  const NearPoint& p = now_.nearest;
  const Plane tangent{p.gap.normal, p.motion.x, p.gap.value};
  const auto point = support_point(obstacle_, p.normal);
  if (!point) return tangent;
  const Plane carried{p.normal, *point, 0};
  const auto value = [&](const Plane& plane) {
    return Bound(shape_, plane, body, centre, now_.bounds)(0, Rest::nothing);
  };
  return value(carried) > value(tangent) ? carried : tangent;
}

// Nothing where the bound is much worse than those of smaller pieces would be.
std::optional<double> Prover::whole_body(const Bound& bound) const {
  const auto G = [&](double dt) { return bound(dt, Rest::nothing); };
  if (!(G(0) - now_.level > 0.5 * (now_.nearest.gap.value - now_.level))) return std::nullopt;
  const double dt = last_above(G, now_.level, now_.horizon);
  const auto unbent = [&](double s) { return G(s) + bound.bending(s); };
  const bool bent = bound.bending(0) + bound.bending(now_.horizon) > 0;
  if (bent && dt < now_.horizon && dt < 0.5 * last_above(unbent, now_.level, now_.horizon)) return std::nullopt;
  return dt;
}

// Leaves the cells that the plane does not prove, with other planes: their own, and those adapted to the body there.
// The answer is one with a clearly nearer middle, or -1.
int Prover::look(const Plane& plane) {
  X_.clear();
  for (const int k : cells_) X_.push_back(surface_.cell(k).X);
  motions_.resize(X_.size());
  motion_.at(now_.t, X_, motions_);
  open_.clear();
  const double gap = now_.nearest.gap.value;
  double lowest = gap - 0.1 * (gap - now_.level);
  int lower = -1;
  for (size_t i = 0; i < cells_.size(); ++i) {
    const Bound with_nearest = bound(plane, i);
    if (with_nearest.proves(now_.level, dt_)) continue;
    const Gap own = mb::gap(obstacle_, motions_[i].x);
    if (own.value < lowest) lowest = own.value, lower = cells_[i];
    Open open{i, {plane, Plane{own.normal, motions_[i].x, own.value}}, 2};
    const Bound with_own = bound(open.planes[1], i);
    dt_ = std::min(dt_, part * with_own.time_of_point(now_.level));
    for (const Rest rest : {Rest::tangent, Rest::along_s, Rest::along_t})
      for (const Vector3d& n : {with_nearest.adapted(motions_[i], rest), with_own.turned(motions_[i], own, rest)}) {
        if (!n.allFinite()) continue;
        if (const auto point = support_point(obstacle_, n)) open.planes[open.n_planes++] = {n, *point, 0};
      }
    open_.push_back(open);
  }
  return lower;
}

bool Prover::proves(const Open& open) const {
  return std::any_of(open.planes.begin(), open.planes.begin() + open.n_planes,
                     [&](const Plane& plane) { return bound(plane, open.place).proves(now_.level, dt_); });
}

double Prover::last(const Open& open) const {
  double last = 0;
  for (size_t k = 0; k < open.n_planes; ++k)
    for (const Rest rest : rests) {
      const Bound G = bound(open.planes[k], open.place);
      last = std::max(last, last_above([&](double s) { return G(s, rest); }, now_.level, dt_));
    }
  return last;
}

// Into quarters; where there is no more room for them the time gives way.
void Prover::split() {
  std::vector<int> quarters;
  for (const Open& open : open_) {
    if (proves(open)) continue;
    const int k = cells_[open.place];
    if (spent_ || surface_.cell(k).depth == TouchSurface::max_depth) {
      dt_ = last(open);
      continue;
    }
    const int first = surface_.children(k);
    for (int child = first; child < first + 4; ++child) quarters.push_back(child);
  }
  cells_.swap(quarters);
}

Proof Prover::run() {
  SurfaceCell body{};
  body.X.setZero();
  body.radius = circumradius(shape_);
  PointMotion centre;
  motion_.at(now_.t, {&body.X, 1}, {&centre, 1});
  const Plane plane = best_plane(body, centre);
  if (const auto dt = whole_body(Bound(shape_, plane, body, centre, now_.bounds))) return {*dt};
  const NearPoint& p = now_.nearest;
  dt_ = std::min(now_.horizon, part * Bound(shape_, plane, body, p.motion, now_.bounds).time_of_point(now_.level));
  cells_.resize(static_cast<size_t>(surface_.n_patches()));
  std::iota(cells_.begin(), cells_.end(), 0);
  const long start = motion_.n_evaluations();
  while (!cells_.empty()) {
    if (const int lower = look(plane); lower >= 0) return {0, lower};
    spent_ =
        spent_ || open_.size() > most_cells || motion_.spent() || motion_.n_evaluations() - start > most_evaluations;
    split();
  }
  return {dt_, -1, spent_};
}

}  // namespace

Proof prove_clear(const Clearance& now, TouchSurface& surface, CountedMotion& motion, const RigidSurface& obstacle) {
  return Prover(now, surface, motion, obstacle).run();
}

}  // namespace mb
