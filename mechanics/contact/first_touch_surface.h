// The surface of a shape for searches: its patches, which of them share an edge, and a quadtree of cells on them that
// grows where it is looked at.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "mechanics/geometry/surface_patches.h"

namespace mb {

// Edges of a patch: 0 s = 0, 1 s = 1, 2 t = 0, 3 t = 1.
struct PatchPoint {
  int patch;
  double s, t; /* [-] in [0, 1] */
};

struct SurfaceCell {
  int patch, depth;
  ParameterCell cell;
  PatchPoint middle;
  Vector3d X, normal;                    // [m] the surface's point in the middle, [-] outward there
  Eigen::Matrix<double, 3, 2> tangents;  // [-] of unit length there, along s and t
  double radius;                         // [m] every point of the cell lies within it of X
  int children = -1;                     // the first of four, or not yet
};

class TouchSurface {
 public:
  static constexpr int max_depth = 50;  // cells 1e-15 of a patch

  explicit TouchSurface(const Shape& shape);  // throws as surface_patches does

  const Shape& shape() const { return shape_; }
  const SurfacePatch& patch(int k) const { return patches_[static_cast<size_t>(k)]; }
  int n_patches() const { return static_cast<int>(patches_.size()); }

  // The same point seen from the patch beyond the edge on which it lies, and the edge of that patch.
  struct Across {
    PatchPoint point;
    int edge;
  };
  Across across(const PatchPoint& point, int edge) const;

  // The patch point of a superquadric's surface point X [m], tapered or not; nothing of another shape.
  std::optional<PatchPoint> locate(const Vector3d& X) const;

  // Takes back what has grown, where that is more than a hundred thousand cells.
  void trim();

  // Cells 0 ... n_patches() - 1 are the patches.
  const SurfaceCell& cell(int k) const { return cells_[static_cast<size_t>(k)]; }
  int children(int k);  // of a cell of depth < max_depth: the first of its four quarters

 private:
  struct Neighbour {
    int patch, edge;
    bool reversed;
  };
  void find_neighbours();
  SurfaceCell make(int patch, int depth, const ParameterCell& cell) const;

  Shape shape_;
  std::vector<SurfacePatch> patches_, straight_;  // of a tapered superquadric also those before the taper
  std::vector<std::array<Neighbour, 4>> neighbours_;
  std::vector<SurfaceCell> cells_;
};

}  // namespace mb
