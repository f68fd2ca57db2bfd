#include "mechanics/contact/first_touch_surface.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace mb {

namespace {

// The point at the parameter p of an edge.
PatchPoint on_edge(int patch, int edge, double p) {
  const double end = edge % 2;
  return edge < 2 ? PatchPoint{patch, end, p} : PatchPoint{patch, p, end};
}

// The patch's point on the ray.
PatchPoint on_ray(const SurfacePatch& patch, int k, const Vector3d& ray) {
  PatchPoint p{k, 0.5, 0.5};
  for (int i = 0; i < 20; ++i) {
    const SurfacePoint here = patch.at(p.s, p.t);
    Eigen::Matrix<double, 3, 2> across;
    across << here.by_s - ray * ray.dot(here.by_s), here.by_t - ray * ray.dot(here.by_t);
    const Vector3d off = here.x - ray * ray.dot(here.x);
    const Eigen::Vector2d step = (across.transpose() * across).ldlt().solve(across.transpose() * off);
    const PatchPoint before = p;
    p.s = std::clamp(p.s - step[0], 0.0, 1.0), p.t = std::clamp(p.t - step[1], 0.0, 1.0);
    if (std::abs(p.s - before.s) + std::abs(p.t - before.t) < 1e-16) break;
  }
  return p;
}

}  // namespace

TouchSurface::TouchSurface(const Shape& shape) : shape_(shape), patches_(surface_patches(shape)) {
  if (const auto* tapered = std::get_if<TaperedSuperquadric>(&shape)) straight_ = surface_patches(tapered->straight);
  find_neighbours();
  for (int k = 0; k < n_patches(); ++k) cells_.push_back(make(k, 0, {}));
}

void TouchSurface::trim() {
  if (cells_.size() < 100'000) return;
  cells_.resize(patches_.size(), cells_.front());
  for (SurfaceCell& cell : cells_) cell.children = -1;
}

SurfaceCell TouchSurface::make(int k, int depth, const ParameterCell& c) const {
  const PatchPoint middle{k, 0.5 * (c.s0 + c.s1), 0.5 * (c.t0 + c.t1)};
  const SurfacePoint p = patch(k).at(middle.s, middle.t);
  Eigen::Matrix<double, 3, 2> tangents;
  tangents << p.by_s.normalized(), p.by_t.normalized();
  return {k,        depth,
          c,        middle,
          p.x,      p.by_s.cross(p.by_t).normalized(),
          tangents, patch(k).covering_radius(c, middle.s, middle.t)};
}

int TouchSurface::children(int k) {
  if (cell(k).children >= 0) return cell(k).children;
  const int patch = cell(k).patch, depth = cell(k).depth;
  const ParameterCell c = cell(k).cell;
  const double s = cell(k).middle.s, t = cell(k).middle.t;
  const int first = static_cast<int>(cells_.size());
  for (const ParameterCell& quarter : {ParameterCell{c.s0, s, c.t0, t}, ParameterCell{s, c.s1, c.t0, t},
                                       ParameterCell{c.s0, s, t, c.t1}, ParameterCell{s, c.s1, t, c.t1}})
    cells_.push_back(make(patch, depth + 1, quarter));
  cells_[static_cast<size_t>(k)].children = first;
  return first;
}

// Of a closed surface every edge is shared by two patches, with the same parameter or one less it. Two edges are the
// same where both their ends and their middles are; of all edges the one that differs least.
void TouchSurface::find_neighbours() {
  struct Edge {
    Vector3d ends[2], middle;
  };
  std::vector<Edge> edges;
  const auto x = [&](const PatchPoint& p) -> Vector3d { return patch(p.patch).at(p.s, p.t).x; };
  for (int k = 0; k < n_patches(); ++k)
    for (int e = 0; e < 4; ++e) edges.push_back({{x(on_edge(k, e, 0)), x(on_edge(k, e, 1))}, x(on_edge(k, e, 0.5))});
  neighbours_.resize(patches_.size());
  for (size_t i = 0; i < edges.size(); ++i) {
    double least = std::numeric_limits<double>::infinity();
    for (size_t j = 0; j < edges.size(); ++j) {
      if (i / 4 == j / 4) continue;
      const double middle = (edges[i].middle - edges[j].middle).squaredNorm();
      if (!(middle < least)) continue;
      for (const bool reversed : {false, true}) {
        const double d = middle + (edges[i].ends[0] - edges[j].ends[reversed]).squaredNorm() +
                         (edges[i].ends[1] - edges[j].ends[!reversed]).squaredNorm();
        if (!(d < least)) continue;
        least = d;
        neighbours_[i / 4][i % 4] = {static_cast<int>(j / 4), static_cast<int>(j % 4), reversed};
      }
    }
    if (!(least < 1e-16 * edges[i].middle.squaredNorm()))
      throw std::logic_error("first_touch: the patches of the surface do not join");
  }
}

TouchSurface::Across TouchSurface::across(const PatchPoint& point, int edge) const {
  const Neighbour& n = neighbours_[static_cast<size_t>(point.patch)][static_cast<size_t>(edge)];
  const double p = edge < 2 ? point.t : point.s;
  return {on_edge(n.patch, n.edge, n.reversed ? 1 - p : p), n.edge};
}

// Its 24 patches are rays' images of quarters of the box's faces: in the middle of each, and at no other's inner
// points, the largest coordinate (by the semi-axes) and the signs of the others are those of X. On one patch rays
// depend smoothly on the parameters, also where the surface is sharp: Newton's method on x across X. A taper takes
// parameters and points along.
std::optional<PatchPoint> TouchSurface::locate(const Vector3d& tapered_X) const {
  const auto* tapered = std::get_if<TaperedSuperquadric>(&shape_);
  const auto* body = tapered ? &tapered->straight : std::get_if<Superquadric>(&shape_);
  if (!body) return std::nullopt;
  const Vector3d X = tapered ? Taper(*tapered).inverse(tapered_X) : tapered_X;
  const Vector3d u = X.cwiseQuotient(body->semi_axes), ray = X.normalized();
  Index face;
  u.cwiseAbs().maxCoeff(&face);
  for (int k = 0; k < n_patches(); ++k) {
    const SurfacePatch& rays = tapered ? straight_[static_cast<size_t>(k)] : patch(k);
    const Vector3d middle = rays.at(0.5, 0.5).x.cwiseQuotient(body->semi_axes);
    Index its_face;
    middle.cwiseAbs().maxCoeff(&its_face);
    if (its_face != face || ((middle.array() < 0) != (u.array() < 0)).any()) continue;
    return on_ray(rays, k, ray);
  }
  return std::nullopt;
}

}  // namespace mb
