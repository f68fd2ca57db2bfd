#include "harness/study/kept_answer.h"

#include <algorithm>

#include "cases/contract/status.h"

namespace mb {

bool is_answer(const Trajectory& answer, const std::vector<Record>& marks) {
  return answer.status == Status::ok &&
         std::ranges::none_of(marks, [](const Record& r) { return is_unstable(r.status) || r.status == "not_finite"; });
}

Trajectory thinned(const Trajectory& all, Index n) {
  const auto kept = Eigen::seq(0, all.t.size() - 1, std::max<Index>(1, n));
  Trajectory few{all.t(kept), {}, all.work, all.status};
  for (const BodyTrajectory& body : all.bodies) {
    few.bodies.push_back(
        {body.displacement.cols() > 0 ? MatrixXd(body.displacement(Eigen::all, kept)) : MatrixXd(), {}});
    const auto& [force, impulse, stored, dissipated, touches] = body.contact;
    if (force.cols() == all.t.size())
      few.bodies.back().contact = {force(Eigen::all, kept), impulse(Eigen::all, kept), stored(kept), dissipated(kept),
                                   touches};
  }
  return few;
}

}  // namespace mb
