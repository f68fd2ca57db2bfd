// The marks: one number each, of an answer against a truth, at the scene's evaluation points and common times.
//
//   M norm  |u|_M^2 = sum_i w_i rho |u_i|^2        K norm  |eps|_K^2 = sum_i w_i eps_i^T D eps_i
//
// Bodies that move freely are compared in two parts, pose and deformation, each answer in its own rigid frame (pose.h):
// otherwise the rigid motion swamps what is of interest. Truths that vanish leave relative errors undefined: NaN.
#pragma once

#include <string>
#include <vector>

#include "cases/contract/method.h"
#include "cases/contract/model.h"

namespace mb {

// What a metric needs to know besides the answers. All that is referred to must outlive this.
struct MetricContext {
  const Scene& scene;
  Index body;                      // in [0, bodies of the scene)
  const EvaluationPoints& points;  // of this body
  bool free;                       // whether no support holds it: then its rigid motion is taken out
  Index probe = -1;                // in [0, probes of the scene): a probe on this body, for metrics of probes
};

struct Metric {
  std::string name, unit, doc;
  bool per_probe;       // asks for context.probe
  bool free_only;       // NaN, hence "undefined", for bodies that are not free
  bool of_truth_alone;  // a property of the truth: the answer is not looked at
  double (*value)(const Trajectory& answer, const Trajectory& truth, const MetricContext& context);
  // What an error of one part of the truth's largest displacement (of stress: largest stress) may come to in this
  // metric, in its unit; none: 1, since the metric is relative to the whole truth itself.
  double (*size)(const Trajectory& truth, const MetricContext& context) = nullptr;
  bool contact_only = false;     // for scenes with contact alone
  bool finite_only = false;      // for bodies of finite kinematics alone
  bool of_answer_alone = false;  // no error against the truth, nor has it a bar: marked once, beside truth "finer"
  // Of a place or an instant: the metric of the whole motion that it is a part of, and what an error of the whole may
  // come to in this metric where it is all of the largest deformation (of stress: of the largest stress).
  const char* whole = nullptr;
  double (*share)(const Trajectory& truth, const MetricContext& context) = nullptr;
  double per_mass = 1;  // [-] what a relative error of the truth's mass may come to at most, by size
  // Divided by the truth's own size: where that is off by d < 1 of itself, a value e is so by d (1 + |e|)/(1 - d) at
  // most. Where d >= 1 nobody knows whether there is anything to be relative to.
  bool relative = false;
};
inline Metric relative(Metric metric) {
  metric.relative = true;
  return metric;
}

// The visible list. Values are >= 0 but for probe-magnitude, which is signed.
const std::vector<Metric>& metric_catalogue();
const Metric& metric(const std::string& name);  // throws std::out_of_range naming it

struct Mark {
  double value;        // NaN under any status but "ok"
  std::string status;  // "ok"; the answer's own where it failed; "not_finite"; "failed: ..." where the truth is not
                       // usable; "undefined: ..." where the metric has no value for finite answers (0/0)
};
// Throws std::invalid_argument where times differ by more than 1e-9 of the sampling step, where points or bodies do not
// match, or where the context names no body or probe of the scene.
Mark mark(const Metric& metric, const Trajectory& answer, const Trajectory& truth, const MetricContext& context);

// Whether displacement and strain of a body are finite; false where there is no such body. One pass over the answer,
// which `mark` makes of both unless it is told.
bool is_finite(const Trajectory& trajectory, Index body);
struct Finite {
  bool answer, truth;
};
Mark mark(const Metric& metric, const Trajectory& answer, const Trajectory& truth, const MetricContext& context,
          const Finite& finite);

// Metric::size, or 1. Infinite at a probe where the truth has nothing; NaN where it has no displacement to be compared.
double truth_size(const Metric& metric, const Trajectory& truth, const MetricContext& context);

// How far two truths are apart in the eyes of a metric, >= 0: what error bars are summed from. NaN where undefined.
//
//   Metric::whole:  max(|m_a - m_b|, 2 d_whole share)
//
// Two meshes may agree on a place or on a largest value while both are wrong, and a place that hardly moves or bears no
// stress has errors of the rest of the body: a part of a motion is known no better than twice the whole.
double distance(const Metric& metric, const Trajectory& a, const Trajectory& b, const MetricContext& context);

}  // namespace mb
