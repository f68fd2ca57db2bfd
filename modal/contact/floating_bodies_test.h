// For tests: bodies of any shape whose modes are polynomials made up, of frequencies made up. Nothing has to solve for
// them, and all else is as of a body with modes of its own.
#pragma once

#include <memory>
#include <random>
#include <utility>
#include <vector>

#include "mechanics/contact/first_touch_support.h"
#include "mechanics/geometry/graded_rule.h"
#include "mechanics/rigid/inertia.h"
#include "modal/contact/impact_motion.h"

namespace mb::testing {

Vector3d half_box(const Shape& shape);  // [m] of the bounding box

PolynomialBasis no_modes(const Shape& shape);

// r modes of that degree; |phi| comes to about `size` [kg^-1/2].
PolynomialBasis random_modes(const Shape& shape, int degree, Index r, double size, unsigned seed);

// r modes of that degree, M-orthonormal and free of momentum over the shape's volume, rho = 1000: those of a body whose
// rotation may be coupled to them.
PolynomialBasis momentless_modes(const Shape& shape, int degree, Index r, unsigned seed);

// One mode that swells a sphere of that radius: phi = size X / radius.
PolynomialBasis swelling(double radius, double size);

FloatingBody floating(const Shape& shape, const std::vector<Roots>& modes, const Vector3d& gravity);

std::shared_ptr<const SpinCoupling> coupling_of(const Shape& shape, const PolynomialBasis& modes);

// All of the surface, in cells of that size [m], 2 x 2 points each; the finest at the foci if there are any.
SurfaceSamples samples_of(const Shape& shape, const PolynomialBasis& modes, const Grading& cells,
                          const std::vector<Vector3d>& foci = {});

BodyState at_rest(const FloatingBody& body, const Vector3d& c, const Vector3d& v = Vector3d::Zero());

ImpactPlan plan_of(const FloatingBody& body, const Shape& shape, const PolynomialBasis& modes, const BodyState& start,
                   ContactScheme scheme, double step);

inline const RigidSurface ground{HalfSpace{}, 0, {}};
// A half-space in the way, whose outward normal is n [-] and whose plane goes through x [m].
RigidSurface wall(const Vector3d& x, const Vector3d& n);

}  // namespace mb::testing
