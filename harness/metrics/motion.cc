#include "harness/metrics/motion.h"

namespace mb {

FramedMotion motion(const Trajectory& trajectory, const MetricContext& context) {
  const auto& [volume, surface, probes] = context.points;
  const MatrixXd& u = trajectory.bodies[static_cast<std::size_t>(context.body)].displacement;
  const Index n_volume = 3 * volume.points.cols(), n_surface = 3 * surface.points.cols();
  const Vector3d X_c = centroid(volume.points, volume.weights);
  FramedMotion result{{}, u.topRows(n_volume), u.middleRows(n_volume, n_surface)};
  for (Index k = 0; k < u.cols(); ++k) {
    if (!context.free) {
      result.frames.push_back({X_c, Eigen::Matrix3d::Identity()});
      continue;
    }
    const RigidFrame frame = rigid_frame(volume.points, volume.weights, result.volume.col(k));
    result.volume.col(k) = deformation(frame, X_c, volume.points, result.volume.col(k));
    result.surface.col(k) = deformation(frame, X_c, surface.points, result.surface.col(k));
    result.frames.push_back(frame);
  }
  return result;
}

VectorXd stiffness_weights(const Material& material, const Quadrature& volume) {
  return volume.weights.cwiseProduct(stiffness_factors(material, volume.points));
}

}  // namespace mb
