// Steady state of a system under harmonic loads:
//
//   F s e^{i omega t}  ->  u e^{i omega t},   (K - omega^2 M + i omega C) u = F s
//
// A free body is answered for omega > 0. Craig 1981, Structural Dynamics, sect. 4.2.
#pragma once

#include <complex>
#include <memory>

#include "mechanics/algebra/complex_lu.h"
#include "mechanics/system/system.h"

namespace mb {

// Keeps the ordering of the sparse factor from frequency to frequency and answers all loads with one factor.
class FrequencyResponse {
 public:
  // The system must outlive this. Throws std::invalid_argument where its sizes disagree or where the damping of single
  // modes does not leave rigid motion alone.
  explicit FrequencyResponse(const System& system);
  ~FrequencyResponse();
  FrequencyResponse(FrequencyResponse&&) noexcept;

  // u [m] for unit factors of every load: n x number of loads; omega [rad/s] > 0. Diagonal systems (reduced in
  // eigenmodes) are solved entry by entry. Damping of low rank enters by projection (rigid modes) or as a border of the
  // sparse matrix (ratios of modes, with R^T W = 0), never as dense blocks. Throws std::runtime_error at an undamped
  // resonance, where fewer than two digits would be left, std::invalid_argument for a frequency out of range.
  Eigen::MatrixXcd operator()(double omega);

 private:
  struct Stiffness;
  double condition() const;
  const System& system_;
  MatrixXd MR_, rigid_;       // n x rigid modes; R R^T F
  Eigen::MatrixXcd elastic_;  // F - M R R^T F
  std::unique_ptr<Stiffness> stiffness_;
};

// The same for one load at many frequencies: n x number of frequencies. Throws std::invalid_argument for a load that
// there is not, too.
Eigen::MatrixXcd frequency_response(const System& system, Index load, const VectorXd& omega);

}  // namespace mb
