// Linear-algebra vocabulary of the whole suite. All quantities are SI; time in seconds.
#pragma once

#include <Eigen/Dense>
#include <Eigen/Sparse>

namespace mb {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Matrix6d = Eigen::Matrix<double, 6, 6>;
using SparseMatrix = Eigen::SparseMatrix<double>;  // column major; symmetric matrices are stored in full

inline constexpr double pi = 3.14159265358979323846;

}  // namespace mb
