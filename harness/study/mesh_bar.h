// How far the finer of two meshes is from the truth, by the distance d between them:
//
//   bar = F d      F = 5/4 max(1, 1/(q - 1))
//
// Richardson's estimate d/(q - 1) and a quarter more (Roache 1998, ch. 5). q: by how much errors fall at least between
// them (cases/scene/refinement.h), with p the least order that they have anywhere. Where a support's face of u = 0 ends
// at a free one, stress is as distance^(p - 1),
//
//   sin^2(p pi/2) = (4 (1 - nu)^2 - p^2) / (3 - 4 nu)      p = 1, 0.71, 0.59 of nu = 0, 0.3, 0.5     (Williams 1952)
//
// and so it is where friction holds a face. At a corner of a soft part within a stiff one, as of a free edge of 270
// degrees, p = 0.544 whatever the ratio; corners of stiff parts have more. Loads that end within a face and
// contacts without friction leave p = 1. That is of strain in the K norm, and of displacement where it is largest,
// which may be there, or turns; in the mean over a body, at probes and of frequencies p is twice as much.
//
// A load that jumps sends fronts through a body without stiffness damping, across which strain jumps. Cells of degree n
// carry short waves too slowly or too fast by (h/l)^2n, which widens a front to w ~ h^(2n/(2n+1)): strain is off by
// w^1/2,
//
//   p = n/(2n + 1) < 1/2, s = p      and displacement, whose slope jumps, by w^3/2: 3 p
#pragma once

#include "cases/scene/refinement.h"
#include "cases/scene/scene.h"
#include "harness/metrics/metric.h"

namespace mb {

constexpr double safety_of_meshes = 1.25;  // [-] F at least

double order_at_a_clamp(double poissons_ratio);  // [-] p in (0.59, 1]; of ratios below 0: 1
constexpr double order_at_a_soft_part = 0.544;   // [-] p
double order_of_modes(const Scene& scene);       // [-] p of static answers and modes, of the body where it is least
// [-] Of motions, fronts with them: of strain and largest values, and of the mean.
struct Orders {
  Order local, mean;
};
Orders orders_of_motion(const Scene& scene);
bool is_of_least_order(const Metric& metric);  // of that p, not of twice as much

// [-] F, >= 5/4. Infinite where q <= 1: two such meshes tell nothing.
double bar_per_distance(const Resolution& finer, const Resolution& coarser, const Order& order);

// Of numbers told once of each mesh.
struct PerDistance {
  double mean, local;  // [-] of what has twice the order of strain, and of what has that itself
  PerDistance(double of_mean, double of_local) : mean(of_mean), local(of_local) {}
  explicit PerDistance(double of_both) : PerDistance(of_both, of_both) {}
};
PerDistance bars_per_distance(const Scene& scene);  // F of its truths' motions on their meshes

}  // namespace mb
