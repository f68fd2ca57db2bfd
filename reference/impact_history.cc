#include "reference/impact_history.h"

#include <algorithm>
#include <cmath>

namespace mb {

Fall fall_of(const Scene& scene, const Body& body, double start) {
  const Eigen::Quaterniond to_axes = body.pose.orientation.conjugate();
  const bool free = !is_held(body);
  return {body.pose, free, free ? start : 0, to_axes * body.twist.velocity, to_axes * scene.gravity};
}

Vector3d Fall::flown(double t) const {
  return free ? Vector3d(t * velocity + t * t / 2 * gravity) : Vector3d(Vector3d::Zero());
}

MatrixXd Fall::placed(const MatrixXd& u, const Matrix3Xd& points, const VectorXd& t) const {
  const Eigen::Matrix3d Q = from.orientation.toRotationMatrix();
  MatrixXd moved(u.rows(), u.cols());
  for (Index k = 0; k < t.size(); ++k) {
    const Vector3d d = flown(std::min(t[k], start));
    for (Index i = 0; i < points.cols(); ++i) {
      const Vector3d own = u.col(k).segment<3>(3 * i);
      moved.col(k).segment<3>(3 * i) =
          free ? Vector3d(from.position + Q * (points.col(i) + d + own) - points.col(i)) : Vector3d(Q * own);
    }
  }
  return moved;
}

ContactHistory Fall::in_world(const ContactHistory& run, Index n_before, Index n_t) const {
  ContactHistory all{Matrix3Xd::Zero(3, n_t), Matrix3Xd::Zero(3, n_t), VectorXd::Zero(n_t), VectorXd::Zero(n_t),
                     run.touches};
  const Eigen::Matrix3d Q = from.orientation.toRotationMatrix();
  for (Touch& touch : all.touches) {
    touch.start += start, touch.end += start, touch.peak_time += start;
    touch.impulse = Q * touch.impulse;
  }
  if (n_before == n_t) return all;
  all.force.rightCols(n_t - n_before) = Q * run.force;
  all.impulse.rightCols(n_t - n_before) = Q * run.impulse;
  all.stored.tail(n_t - n_before) = run.stored;
  all.dissipated.tail(n_t - n_before) = run.dissipated;
  return all;
}

const ContactSize& size_for(const Touchdown& touchdown, const Meeting& meeting) {
  if (std::isfinite(meeting.t)) return meeting.size;
  return std::ranges::min_element(touchdown.meetings, {}, &Meeting::t)->size;
}

}  // namespace mb
