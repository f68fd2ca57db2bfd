// Marks of stored trajectories: every metric that applies, against every truth that applies, as records.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "harness/study/truth.h"

namespace mb {

// Marks answers of one case. Error bars are computed once.
class Grader {
 public:
  // free: per body of the scene, whether it moves freely. All arguments must outlive this.
  Grader(const Scene& scene, const TruthSet& truth, std::vector<bool> free,
         std::map<std::string, std::string> provenance);
  Grader(const Grader&) = delete;  // contexts refer to the points kept here
  Grader& operator=(const Grader&) = delete;

  // base: run, contender, modes_used, n_unknowns. Full-order rivals on other meshes are marked against `finer` alone.
  std::vector<Record> marks(const Record& base, const Trajectory& answer) const;
  // Of modes that were stepped, against the closed form of the same modes: what their steps alone make wrong.
  // load_error [-]: of that closed form, the bar of metrics relative to the whole.
  std::vector<Record> marks_of_steps(const Record& base, const Trajectory& answer, const Trajectory& closed_form,
                                     double load_error) const;
  // [-] Energy that nothing brought to the contacts (contact_metrics.h); NaN of scenes without.
  double energy_fed(const Trajectory& answer) const;
  // One record per metric that describes the truth itself.
  std::vector<Record> truth_marks(const Record& base) const;
  // A run that gave no answer: one record a metric with its status and no value.
  std::vector<Record> failure(const Record& base, const std::string& status) const;
  // A measured time or another number which needs no truth.
  Record number(const Record& base, const std::string& metric, const std::string& unit, double value, double bar) const;

 private:
  struct Subject {
    Metric metric;
    MetricContext context;
    std::string name;
  };
  Record blank(const Record& base, const Subject& subject, TruthKind kind) const;
  Record marked(const Record& base, const Subject& subject, TruthKind kind, const Trajectory& answer,
                const Trajectory& truth, const std::array<std::vector<bool>, 2>& finite) const;  // answer's, truth's
  std::vector<TruthKind> kinds(const Record& base) const;

  const Scene& scene_;
  const TruthSet& truth_;
  std::map<std::string, std::string> provenance_;
  std::vector<EvaluationPoints> points_;
  std::vector<Subject> subjects_;
  std::map<std::pair<size_t, TruthKind>, double> bars_;
  std::map<TruthKind, std::vector<bool>> finite_truths_;  // one a body
};

}  // namespace mb
