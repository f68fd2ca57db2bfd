// Sparse LU of a complex matrix (UMFPACK):   P A Q = L U
//
// For frequency responses, whose dynamic stiffness is complex symmetric and indefinite. Davis 2004, ACM TOMS 30(2).
#pragma once

#include <complex>
#include <memory>

#include "mechanics/types.h"

namespace mb {

using Complex = std::complex<double>;
using VectorXcd = Eigen::VectorXcd;
using SparseMatrixXcd = Eigen::SparseMatrix<Complex>;  // column-major

class ComplexLu {
 public:
  // A: n x n, compressed. Throws std::runtime_error where A is singular or memory runs out.
  explicit ComplexLu(const SparseMatrixXcd& A);
  ~ComplexLu();
  ComplexLu(ComplexLu&&) noexcept;
  // Numbers anew for another matrix of the same pattern; keeps the ordering.
  void refactor(const SparseMatrixXcd& A);
  VectorXcd solve(const VectorXcd& b) const;

 private:
  struct Factor;
  std::unique_ptr<Factor> factor_;
};

}  // namespace mb
