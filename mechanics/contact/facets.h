// The boundary of a mesh that is touched by points of another body, as it deforms: patches of degree p,
//
//   S(xi) = sum_ab L_a(xi_1) L_b(xi_2) (X_ab + u_ab),   xi in [0, 1]^2,   L Lagrange's basis on the nodes' places,
//
// and of a point x the nearest foot on them: min |x - S|, gap = +-|x - S|, > 0 where x lies outside. Patches meet in
// edges, where the normal may jump: there it is along x - S.
#pragma once

#include <vector>

#include "mechanics/types.h"

namespace mb {

struct Facets {
  VectorXd places;        // [-] p + 1 in [0, 1], ascending, p in [1, 4]
  Eigen::MatrixXi nodes;  // (p + 1)^2 x n patches, xi_1 running fastest; S_1 x S_2 points outward
  Matrix3Xd X;            // [m] 3 x k, of the nodes at rest
  SparseMatrix U;         // 3 k x n: displacements of the nodes
};

struct FacetFoot {
  int patch;
  Eigen::Vector2d xi;
  double gap;                                         // [m]
  Vector3d normal;                                    // [-] outward, of unit length
  Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 25> N;  // [-] weights of the patch's nodes, (p + 1)^2
};

// Feet of the same points over and over, while all moves little from one look to the next: what is far is not looked
// at again until it may have come near. One thread at a time.
class FootSearch {
 public:
  // Throws std::invalid_argument where sizes disagree or there is no patch. The facets must outlive this.
  FootSearch(const Facets& facets, Index n_points);
  void move_to(const VectorXd& u);  // [m] displacements of the nodes, 3 k

  struct Near {
    double gap;             // [m] a lower bound where it is above `depth`
    const FacetFoot* foot;  // of a point whose gap lies below the depth asked for; else none
  };
  Near operator()(Index point, const Vector3d& x, double depth = 0);

 private:
  struct Surface {  // S and its derivatives at one xi
    Vector3d S, S1, S2, S11, S12, S22;
  };
  struct Memory {
    Vector3d x;                   // where the list was made
    double gap;                   // [m] then
    long epoch = -1;              // of the reference then
    std::vector<int> candidates;  // patches
    FacetFoot foot;
  };
  using Values = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 5>;  // of L_a; never on the heap
  struct Basis {
    Values L, L1, L2;
  };
  Basis basis(double xi) const;
  Surface surface(int patch, const Eigen::Vector2d& xi) const;
  Eigen::Vector2d descend(int patch, const Vector3d& x, Eigen::Vector2d xi) const;
  void look(Memory& memory, const Vector3d& x) const;
  void collect(Memory& memory, const Vector3d& x) const;
  void renew();

  const Facets& facets_;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 5, 5> coefficients_;  // of L by powers of xi
  double lebesgue_;                                                              // bound of sum |L_a L_b|
  Matrix3Xd x_, reference_;  // nodes: now; where the spheres were made
  double moved_ = 0;         // [m] of any point of the surface since then
  double skin_;              // [m] that lists allow for
  long epoch_ = 0;
  Matrix3Xd centres_;  // of spheres around the patches
  VectorXd radii_;
  std::vector<Memory> memory_;
};

}  // namespace mb
