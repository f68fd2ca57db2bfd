#include "harness/study/storable.h"

#include <stdexcept>

namespace mb {

void require_storable(const Scene& scene, Index most) {
  if (const std::string problem = kept_problem(scene, most); !problem.empty()) throw std::runtime_error(problem);
}

}  // namespace mb
