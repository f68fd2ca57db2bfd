#include "harness/study/run_case.h"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "cases/contract/status.h"
#include "cases/scene/printable.h"
#include "harness/analysis/told.h"
#include "harness/provenance.h"
#include "harness/study/bench.h"
#include "harness/study/current_records.h"
#include "harness/study/estimate.h"
#include "harness/study/front.h"
#include "harness/study/identity.h"
#include "harness/study/instability.h"
#include "harness/study/kept_answer.h"
#include "harness/study/memory.h"
#include "harness/study/step_growth.h"
#include "harness/study/stored.h"

namespace mb {

namespace {

constexpr std::size_t most_told = 1000;  // [bytes] of a failure's reason

class CaseRun {
 public:
  CaseRun(std::shared_ptr<const Scene> scene, const Catalogue& catalogue, const Store& store, const RunOptions& options,
          const Progress& progress)
      : scene_(std::move(scene)),
        catalogue_(catalogue),
        store_(store),
        options_(options),
        progress_(progress),
        all_(jobs(*scene_, catalogue)),
        bench_(scene_, catalogue) {}

  CaseOutcome run() {
    const std::vector<Job> todo = not_stored();
    if (todo.empty() && untimed_front().empty() && unmarked_truths().empty())
      return name_damaged_truths(*scene_, store_, progress_), outcome_;
    store_.require_writable();
    for (const Job& job : todo) store_.require_room(job.hash);
    for (const Record& one : unmarked_truths()) store_.require_room(one.run);
    const std::optional<TruthSet> truth = truths_or_record();
    if (!truth) return outcome_;
    const Grader grader(*scene_, *truth, free_bodies(), provenance(scene_->profile));
    mark_truths(grader, *truth);
    for (size_t i = 0; i < todo.size() && !stop(); ++i) {
      const std::string count = fmt::format("[{}/{}]", i + 1, todo.size());
      if (todo[i].kind == Job::Kind::marks)
        compete(grader, todo[i], count);
      else
        analyse(todo[i], *truth, count);
      ++outcome_.n_run;
    }
    if (!outcome_.interrupted) time_the_front(grader);
    return outcome_;
  }

 private:
  // Of this part. What failed before counts as failed again, but for want of memory, which may be there now.
  std::vector<Job> not_stored() {
    std::vector<Job> todo;
    for (const Job& job : part(all_, options_.shard)) {
      if (!options_.alone && takes_times(job)) continue;
      const StoredJob found = stored(job, store_);
      const bool anew = options_.again || (options_.again_timed && takes_times(job));
      const bool done = !anew && found.is_complete(options_.timed);
      for (const RefusedLine& line : done ? std::vector<RefusedLine>() : found.damaged)
        progress_(to_string(line) + "; computed again");
      if (!done) todo.push_back(job);
      outcome_.n_stored += done;
      outcome_.n_failed += done && found.failed;
      if (done && found.failed)
        progress_(
            fmt::format("{} · {} · failed in an earlier run; `--again` tries once more", scene_->name, job.label));
    }
    return todo;
  }

  // [byte] What there is.
  std::optional<double> room() const { return options_.memory ? options_.memory : available_memory(); }

  bool stop() {
    outcome_.interrupted = outcome_.interrupted || (options_.interrupted && options_.interrupted());
    return outcome_.interrupted;
  }

  std::vector<bool> free_bodies() const {
    std::vector<bool> free;
    for (const Body& body : scene_->bodies) free.push_back(!is_held(body));
    return free;
  }

  Record base(const Contender& contender) const {
    Record record;
    record.run = run_hash(*scene_, contender);
    record.contender = contender;
    return record;
  }

  // The truths; nothing where interrupted. Where they fail the case has no result: a record says so in its place.
  std::optional<TruthSet> truths_or_record() {
    try {
      return truths(scene_, catalogue_, store_, progress_, [this] { return stop(); });
    } catch (const StoreError&) {
      throw;
    } catch (const std::exception& error) {
      const Record record = failed_truth(*scene_, failure_text(error, memory(*scene_)));
      keep_unless_answered(store_, record.run, {record});
      throw;
    }
  }

  // The truth's own marks: what it contains, and how far the body's mesh is from it. A contender that is the truth
  // itself marks it, too.
  void mark_truths(const Grader& grader, const TruthSet& truth) const {
    const std::string finer = base(truth_contenders(*scene_)[0]).run;
    for (const Record& one : unmarked_truths()) {
      for (const RefusedLine& line :
           store_.has_records(one.run) ? store_.read_records_of(one.run).refused : std::vector<RefusedLine>())
        progress_(to_string(line) + "; computed again");
      keep_unless_answered(store_, one.run,
                           one.run == finer ? grader.truth_marks(one) : grader.marks(one, truth.loose));
    }
  }

  // What stands for a truth that is no contender: finer, then on the same mesh.
  std::vector<Record> unmarked_truths() const {
    std::vector<Record> missing;
    for (const Contender& contender : truth_contenders(*scene_))
      if (const Record one = base(contender);
          std::ranges::find(all_, one.run, &Job::hash) == all_.end() && !holds_answers(store_, one.run))
        missing.push_back(one);
    return missing;
  }

  void compete(const Grader& grader, const Job& job, const std::string& count) {
    Record record = base(job.contender);
    try {
      require_memory(memory(*scene_, job, options_.timed), room());
      const ReadyContender ready = bench_.prepare(job.contender);
      record.modes_used = ready.prepared->modes_used();
      record.n_unknowns = ready.prepared->n_unknowns();
      StoredJob found = stored(job, store_);
      const bool again = options_.again || !found.is_sound();
      std::vector<Record> records = again ? marks(grader, record, ready) : std::move(found.marks);
      if (again) keep_marks(store_, job, records, options_.again);
      outcome_.n_failed += std::ranges::any_of(records, [](const Record& r) { return is_failure(r); });
      // What gave no answer has no time.
      if (options_.timed && std::ranges::any_of(records, [](const Record& r) { return r.status == "ok"; })) {
        const auto times = bench_.times(grader, record, ready, cheap);
        store_.write_times(record.run, times);
        std::ranges::copy(times, std::back_inserter(records));
      }
      finish(count, job, records);
    } catch (const StoreError&) {
      throw;  // a store that cannot be written is not the contender's failure
    } catch (const std::exception& error) {
      const std::string why = failure_text(error, memory(*scene_, job, options_.timed));
      keep_unless_answered(store_, record.run, grader.failure(record, "failed: " + why));
      ++outcome_.n_failed;
      progress_(fmt::format("{} {} · {} · failed: {}", count, scene_->name, job.label, one_line(why, most_told)));
    }
  }

  // Marked at every sample; kept for the eye: about a frame's distance apart, without strains.
  std::vector<Record> marks(const Grader& grader, const Record& record, const ReadyContender& ready) {
    const Trajectory answer = ready.prepared->simulate({.t = sample_times(*scene_)});
    std::vector<Record> records = grader.marks(record, answer);
    const Integrator& integrator = catalogue_.integrator(record.contender.integrator);
    const Grown grown =
        growth_of(ready.reduction.get(), integrator, record.contender.settings.time_step, scene_->duration);
    const Limit limit = kept_limit(records, integrator, grown, grader.energy_fed(answer));
    if (const Prepared* closed = bench_.closed_form(record.contender, ready))
      std::ranges::move(grader.marks_of_steps(record, answer, closed->simulate({.t = answer.t}), closed->load_error()),
                        std::back_inserter(records));
    if (limit != Limit::kept) name_unstable(records, limit);
    if (grown.unknown) name_unknown(records);
    if (is_answer(answer, records)) {
      Trajectory kept = thinned(answer, std::lround(scene_->samples_per_second / scene_->frame_rate));
      kept.case_name = scene_->name;
      store_.write_trajectory(record.run, kept);
    }
    if (record.run == base(truth_contenders(*scene_).front()).run)
      std::ranges::copy(grader.truth_marks(record), std::back_inserter(records));
    if (record.contender.integrator == "exact")
      records.push_back(grader.number(record, "load-error", "-", ready.prepared->load_error(), std::nan("")));
    return records;
  }

  void finish(const std::string& count, const Job& job, const std::vector<Record>& records) const {
    std::string said = fmt::format("error {:.2e}", std::nan("")), time;
    for (const Record& r : records) {
      if (r.metric == "displacement-error" && r.truth == "finer")
        said = is_unstable(r.status) ? r.status + ", no trajectory kept" : fmt::format("error {:.2e}", r.value);
      if (r.metric == "displacement-error" && r.truth == "finer" && is_growth_unknown(r))
        said += ", not known whether its steps are past their limit";
      if (r.metric == "online-time") time = fmt::format(" · {:.3g} s", r.value);
    }
    progress_(fmt::format("{} {} · {} · {}{}", count, scene_->name, job.label, said, time));
  }

  void analyse(const Job& job, const TruthSet& truth, const std::string& count) {
    std::vector<Finding> findings;
    const AnalysisContext context{scene_, catalogue_, truth, [this](const Resolution& mesh) -> const Model& {
                                    return bench_.model(mesh, memory_of_analysis(*scene_, mesh), room());
                                  }};
    std::string said;
    try {
      require_memory(memory(*scene_, job, options_.timed), room());
      const double time = seconds([&] { findings = told(analysis(job.analysis), context); });
      said = fmt::format("{} tables · {:.1f} s", findings.size(), time);
    } catch (const std::exception& error) {
      const std::string why = failure_text(error, memory(*scene_, job, options_.timed));
      said = "failed: " + one_line(why, most_told);
      if (stop()) return progress_(fmt::format("{} {} · {} · {}", count, scene_->name, job.label, said));
      findings = {failed_table(job.analysis, why)};
      ++outcome_.n_failed;
    }
    sign(findings, *scene_, job.hash);
    keep_tables(store_, job, findings);
    progress_(fmt::format("{} {} · {} · {}", count, scene_->name, job.label, said));
  }

  std::vector<std::string> untimed_front() const {
    if (!options_.timed) return {};
    const auto front = dear_front(current_records(store_, {*scene_}).records);
    if (options_.shard.whole()) return front;
    std::set<std::string> mine;
    for (const Job& job : part(all_, options_.shard)) mine.insert(job.hash);
    std::vector<std::string> left;
    std::ranges::copy_if(front, std::back_inserter(left), [&](const auto& run) { return mine.contains(run); });
    return left;
  }

  // Repeats the time of dear full-order runs that may be the cheapest at some error.
  void time_the_front(const Grader& grader) {
    for (const std::string& run : untimed_front()) {
      if (stop()) return;
      const std::vector<Record> marks_now = store_.read_records_of(run).records;
      if (marks_now.empty()) continue;  // removed or damaged since: nothing to time
      const Record& marked = marks_now.front();
      Record record = base(marked.contender);
      record.modes_used = marked.modes_used;
      record.n_unknowns = marked.n_unknowns;
      progress_(fmt::format("{} · timing {}", scene_->name, label(record.contender)));
      time(grader, record);
    }
  }

  void time(const Grader& grader, const Record& record) {
    const Job job{Job::Kind::marks, record.run, label(record.contender), record.contender, ""};
    try {
      require_memory(memory(*scene_, job, options_.timed), room());
      store_.write_times(record.run, bench_.times(grader, record, bench_.prepare(record.contender), any_time));
    } catch (const StoreError&) {
      throw;
    } catch (const std::exception& error) {  // its marks stand, and its times are asked for again
      ++outcome_.n_failed;
      progress_(fmt::format("{} · timing {} · failed: {}", scene_->name, job.label,
                            one_line(failure_text(error, memory(*scene_, job, options_.timed)), most_told)));
    }
  }

  std::shared_ptr<const Scene> scene_;
  const Catalogue& catalogue_;
  const Store& store_;
  const RunOptions& options_;
  const Progress& progress_;
  std::vector<Job> all_;  // of the case, whichever part of them is run here
  Bench bench_;
  CaseOutcome outcome_;
};

}  // namespace

CaseOutcome run_case(const std::shared_ptr<const Scene>& scene, const Catalogue& catalogue, const Store& store,
                     const RunOptions& options, const Progress& progress) {
  return CaseRun(scene, catalogue, store, options, progress).run();
}

}  // namespace mb
