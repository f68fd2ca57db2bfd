#include "harness/study/grade.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "harness/metrics/contact_metrics.h"
#include "harness/metrics/finite_metrics.h"
#include "harness/study/plan.h"

namespace mb {

namespace {

std::vector<TruthKind> known_truths(const TruthSet& truth) {
  if (truth.exact) return {TruthKind::finer, TruthKind::same_mesh, TruthKind::exact};
  return {TruthKind::finer, TruthKind::same_mesh};
}

// A number of which nobody can say how uncertain it is is none.
void put_bar(Record& record, double bar, const char* why = "the truth's neighbour has no such number") {
  if (std::isfinite(bar)) {
    record.error_bar = bar;
  } else if (record.status == "ok") {  // its value, which is not stored, still tells of an answer that ran away
    record.status = fmt::format("undefined: {}", why);
  }
}

// Of a value of this metric, where the truth may be off by `bar` (Metric::relative).
void put_bar_of(const Metric& metric, Record& record, double bar) {
  if (!metric.relative || !std::isfinite(record.value) || !std::isfinite(bar)) return put_bar(record, bar);
  if (bar >= 1)
    return put_bar(record, std::numeric_limits<double>::infinity(),
                   "what the truth may be off by is as large as what it has there");
  put_bar(record, bar * (1 + std::abs(record.value)) / (1 - bar));
}

std::vector<bool> finite_bodies(const Trajectory& answer, size_t n) {
  std::vector<bool> finite;
  for (size_t b = 0; b < n; ++b) finite.push_back(is_finite(answer, static_cast<Index>(b)));
  return finite;
}

}  // namespace

Grader::Grader(const Scene& scene, const TruthSet& truth, std::vector<bool> free,
               std::map<std::string, std::string> provenance)
    : scene_(scene), truth_(truth), provenance_(std::move(provenance)) {
  for (const Body& body : scene.bodies) points_.push_back(evaluation_points(scene, body));
  for (const Metric& metric : metric_catalogue())
    for (size_t b = 0; b < scene.bodies.size(); ++b) {
      const bool finite = scene.bodies[b].kinematics == Kinematics::finite;
      if ((metric.free_only && !free[b]) || (metric.contact_only && scene.contacts.empty()) ||
          (metric.finite_only && !finite))
        continue;
      const MetricContext context{scene, static_cast<Index>(b), points_[b], free[b], -1};
      if (!metric.per_probe) subjects_.push_back({metric, context, scene.bodies[b].name});
      for (size_t p = 0; metric.per_probe && p < scene.probes.size(); ++p) {
        if (scene.probes[p].body != scene.bodies[b].name) continue;
        MetricContext at_probe{scene, static_cast<Index>(b), points_[b], free[b], static_cast<Index>(p)};
        subjects_.push_back({metric, at_probe, scene.probes[p].name});
      }
    }
  for (const TruthKind kind : known_truths(truth_))
    finite_truths_[kind] = finite_bodies(truth_.of(kind), points_.size());
  for (size_t i = 0; i < subjects_.size(); ++i)
    for (const TruthKind kind : known_truths(truth_))
      if (!subjects_[i].metric.of_answer_alone && (kind == TruthKind::finer || !subjects_[i].metric.of_truth_alone))
        bars_[{i, kind}] = error_bar(subjects_[i].metric, truth_, kind, subjects_[i].context);
}

std::vector<TruthKind> Grader::kinds(const Record& base) const {
  const bool same = base.contender.resolution == own_meshes(scene_);
  std::vector<TruthKind> all = known_truths(truth_);
  if (!same) std::erase(all, TruthKind::same_mesh);
  return all;
}

Record Grader::blank(const Record& base, const Subject& subject, TruthKind kind) const {
  Record record = base;
  record.case_name = scene_.name;
  record.profile = scene_.profile;
  record.metric = subject.metric.name;
  record.subject = subject.name;
  record.truth = to_string(kind);
  record.unit = subject.metric.unit;
  record.provenance = provenance_;
  return record;
}

Record Grader::marked(const Record& base, const Subject& subject, TruthKind kind, const Trajectory& answer,
                      const Trajectory& truth, const std::array<std::vector<bool>, 2>& finite) const {
  const auto body = static_cast<size_t>(subject.context.body);
  const Mark mark = mb::mark(subject.metric, answer, truth, subject.context, {finite[0][body], finite[1][body]});
  Record record = blank(base, subject, kind);
  record.value = mark.value;
  record.status = mark.status;
  record.work = answer.work;
  return record;
}

std::vector<Record> Grader::marks(const Record& base, const Trajectory& answer) const {
  std::vector<Record> records;
  const std::vector<bool> finite = finite_bodies(answer, points_.size());
  for (const TruthKind kind : kinds(base))
    for (size_t i = 0; i < subjects_.size(); ++i) {
      const Subject& subject = subjects_[i];
      if (subject.metric.of_truth_alone) continue;
      if (subject.metric.of_answer_alone && kind != TruthKind::finer) continue;
      Record record = marked(base, subject, kind, answer, truth_.of(kind), {finite, finite_truths_.at(kind)});
      if (const auto bar = bars_.find({i, kind}); bar != bars_.end()) put_bar_of(subject.metric, record, bar->second);
      records.push_back(std::move(record));
    }
  return records;
}

std::vector<Record> Grader::marks_of_steps(const Record& base, const Trajectory& answer, const Trajectory& closed_form,
                                           double load_error) const {
  std::vector<Record> records;
  const std::array finite{finite_bodies(answer, points_.size()), finite_bodies(closed_form, points_.size())};
  for (const Subject& subject : subjects_) {
    if (subject.metric.of_truth_alone || subject.metric.of_answer_alone) continue;
    Record record = marked(base, subject, TruthKind::same_modes, answer, closed_form, finite);
    const double bar = load_error * truth_size(subject.metric, closed_form, subject.context);
    put_bar_of(subject.metric, record, bar);
    records.push_back(std::move(record));
  }
  return records;
}

double Grader::energy_fed(const Trajectory& answer) const {
  if (scene_.contacts.empty()) return free_gain(answer, scene_);  // of finite kinematics: of others none is recorded
  return mb::energy_fed(answer, truth_.finer, subjects_.front().context);  // of all bodies, whichever it names
}

std::vector<Record> Grader::truth_marks(const Record& base) const {
  std::vector<Record> records;
  for (size_t i = 0; i < subjects_.size(); ++i) {
    const Subject& subject = subjects_[i];
    if (!subject.metric.of_truth_alone) continue;
    const Mark mark = mb::mark(subject.metric, truth_.finer, truth_.finer, subject.context);
    Record record = blank(base, subject, TruthKind::finer);
    record.value = mark.value;
    record.status = mark.status;
    record.work = truth_.finer.work;
    put_bar(record, bars_.at({i, TruthKind::finer}));
    records.push_back(std::move(record));
  }
  return records;
}

std::vector<Record> Grader::failure(const Record& base, const std::string& status) const {
  std::vector<Record> records;
  std::vector<TruthKind> all = kinds(base);
  if (scene_.contacts.empty() && steps_modes(base.contender)) all.push_back(TruthKind::same_modes);
  for (const TruthKind kind : all)
    for (const Subject& subject : subjects_) {
      if (subject.metric.of_truth_alone) continue;
      Record record = blank(base, subject, kind);
      record.value = std::numeric_limits<double>::quiet_NaN();
      record.status = status;
      records.push_back(std::move(record));
    }
  return records;
}

Record Grader::number(const Record& base, const std::string& metric, const std::string& unit, double value,
                      double bar) const {
  Record record = base;
  record.case_name = scene_.name;
  record.profile = scene_.profile;
  record.metric = metric;
  record.value = value;
  record.unit = unit;
  record.status = "ok";
  record.provenance = provenance_;
  if (std::isfinite(bar)) record.error_bar = bar;
  return record;
}

}  // namespace mb
