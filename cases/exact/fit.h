// Why a scene is not the one a closed form holds for: every reason that applies, in one sentence.
#pragma once

#include <string>
#include <vector>

#include "cases/scene/scene.h"

namespace mb {

class Misfit {
 public:
  void require(bool holds, const std::string& reason) {
    if (!holds) reasons_.push_back(reason);
  }
  bool empty() const { return reasons_.empty(); }
  std::string text() const;  // "" or "reason; reason"

 private:
  std::vector<std::string> reasons_;
};

// What the closed forms of loaded bodies ask for: one body, isotropic and undamped, under one load of one whole face of
// it. Where this misfits, there may be no load to look at.
Misfit one_loaded_undamped_body(const Scene& scene);

// What closed forms of struck beams and plates ask for: one isotropic, undamped body of the theory, and one ball that
// strikes it by Hertz's law without losses.
Misfit one_struck_undamped_body(const Scene& scene, Theory theory);

// What closed forms of thrown bodies ask for: one isotropic, undamped, free solid, which does not spin and meets one
// half-space by the penalty law, without losses. Where this misfits, there may be no contact to look at.
Misfit one_thrown_undamped_body(const Scene& scene);

}  // namespace mb
