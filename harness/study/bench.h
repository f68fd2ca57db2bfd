// Makes models and contenders ready and takes their times; the workbench that a case's jobs share.
//
//   online = stepping + reconstruction at the frame times        offline = assembly + preparation
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cases/contract/linear.h"
#include "harness/measure.h"
#include "harness/study/grade.h"

namespace mb {

struct ReadyContender {
  std::unique_ptr<Prepared> prepared;
  double assembly, preparation;                // [s] one run each
  std::shared_ptr<const Reduction> reduction;  // of methods that reduce, else none
};

inline constexpr double cheap = 0.05;  // [s] runs below are timed with repeats at once
inline constexpr double any_time = std::numeric_limits<double>::infinity();

class Bench {
 public:
  Bench(std::shared_ptr<const Scene> scene, const Catalogue& catalogue)
      : scene_(std::move(scene)), catalogue_(catalogue) {}

  // One model at a time, the largest thing here: a reference is valid until another resolution is asked for.
  const Model& model(const Resolution& resolution);
  // Likewise, where it is not at hand and takes so much [byte], which must be there once what is at hand is let go:
  // throws as require_memory.
  const Model& model(const Resolution& resolution, double needed, std::optional<double> available);
  // Contenders that differ by integrator and step alone share a basis, as long as they follow each other; the time it
  // took is charged to each.
  ReadyContender prepare(const Contender& contender);

  // The closed form of the modes that a contender steps; none of what is in contact, of full order and of `full`, whose
  // modes are the mesh's own. One at a time: valid until that of another basis is asked for.
  const Prepared* closed_form(const Contender& contender, const ReadyContender& ready);

  // Records of the times of one contender (metrics `online-time`, `stepping-time`, `offline-time`, `assembly-time`).
  // Five runs of the online part at least where one is cheap, three where it takes less than repeat_below [s]; else
  // one, without a spread. `stepping-time` of cheap ones alone.
  std::vector<Record> times(const Grader& grader, const Record& base, const ReadyContender& ready,
                            double repeat_below) const;

 private:
  void let_go();
  std::shared_ptr<const Scene> scene_;
  const Catalogue& catalogue_;
  std::unique_ptr<Model> model_;
  Resolution resolution_{};
  double assembly_ = 0;  // [s] of the model at hand

  struct Basis {
    std::string method;
    int modes = 0;
    std::shared_ptr<const Reduction> reduction;
    double time = 0;  // [s]
  };
  const Basis& basis(const LinearMethod& method, const Settings& settings, const Model& mesh);
  Basis basis_;  // of the model at hand
  struct ClosedForm {
    std::shared_ptr<const Reduction> reduction;  // of which it is
    std::unique_ptr<Prepared> prepared;
  };
  ClosedForm closed_form_;
};

}  // namespace mb
