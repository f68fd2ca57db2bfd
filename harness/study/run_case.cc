#include "harness/study/run_case.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "harness/measure.h"
#include "harness/provenance.h"
#include "harness/study/current_records.h"
#include "harness/study/front.h"
#include "harness/study/identity.h"
#include "reference/full_model.h"

namespace mb {

namespace {

constexpr double cheap = 0.3;  // [s] runs below are timed with repeats at once; dearer ones only where it can matter

class CaseRun {
 public:
  CaseRun(std::shared_ptr<const Scene> scene, const Catalogue& catalogue, const Store& store, const RunOptions& options,
          const Progress& progress)
      : scene_(std::move(scene)), catalogue_(catalogue), store_(store), options_(options), progress_(progress) {}

  CaseOutcome run() {
    std::vector<Contender> todo;
    for (const Contender& contender : contenders(*scene_)) {
      const bool stored = !options_.again && store_.has_records(run_hash(*scene_, contender));
      outcome_.n_stored += stored;
      if (!stored) todo.push_back(contender);
    }
    if (todo.empty() && front().empty()) return outcome_;
    const TruthSet truth = truths(scene_, catalogue_, store_, progress_);
    const Grader grader(*scene_, truth, free_bodies(), provenance(scene_->profile));
    mark_truths(grader, truth);
    for (size_t i = 0; i < todo.size() && !stop(); ++i)
      compete(grader, todo[i], fmt::format("[{}/{}]", i + 1, todo.size()));
    if (!outcome_.interrupted) time_the_front(grader);
    return outcome_;
  }

 private:
  bool stop() {
    outcome_.interrupted = outcome_.interrupted || (options_.interrupted && options_.interrupted());
    return outcome_.interrupted;
  }

  const Model& model(const Resolution& resolution) {
    if (!model_ || !(model_resolution_ == resolution)) {
      model_.reset();  // one at a time: they are the largest things here
      assembly_ = seconds([&] { model_ = std::make_unique<Model>(build_model(scene_, &resolution)); });
      model_resolution_ = resolution;
    }
    return *model_;
  }

  std::vector<bool> free_bodies() const {
    std::vector<bool> free;
    for (const Body& body : scene_->bodies) free.push_back(body.supports.empty());
    return free;
  }

  Record base(const Contender& contender) const {
    Record record;
    record.run = run_hash(*scene_, contender);
    record.contender = contender;
    return record;
  }

  // The truth's own marks: what it contains, and how far the body's mesh is from it.
  void mark_truths(const Grader& grader, const TruthSet& truth) {
    const auto contenders = truth_contenders(*scene_);
    const Record finer = base(contenders[0]), same_mesh = base(contenders[1]);
    store_.write_records(finer.run, grader.truth_marks(finer));
    store_.write_records(same_mesh.run, grader.marks(same_mesh, truth.loose));
  }

  void compete(const Grader& grader, const Contender& contender, const std::string& count) {
    Record record = base(contender);
    try {
      std::unique_ptr<Prepared> prepared;
      const Model& mesh = model(contender.resolution);
      const double offline = assembly_ + seconds([&] { prepared = prepare(mesh, contender); });
      record.modes_used = prepared->modes_used();
      record.n_unknowns = prepared->n_unknowns();
      const double estimate = seconds([&] {
        store_.write_trajectory(record.run, prepared->simulate({sample_times(*scene_), true}));
      });
      const Trajectory stored = store_.read_trajectory(record.run);  // marks come from what is stored, nothing else
      std::vector<Record> records = grader.marks(record, stored);
      if (contender.integrator == "exact")
        records.push_back(grader.number(record, "load-error", "-", prepared->load_error(), std::nan("")));
      if (stored.status == Status::ok) {
        const Timing online = time_online(*prepared, estimate < cheap);
        records.push_back(grader.number(record, "offline-time", "s", offline, std::nan("")));
        records.push_back(grader.number(record, "online-time", "s", online.median, online.spread));
      } else {
        ++outcome_.n_failed;
      }
      store_.write_records(record.run, records);
      finish(count, records);
    } catch (const StoreError&) {
      throw;  // a store that cannot be written is not the contender's failure
    } catch (const std::exception& error) {
      store_.write_records(record.run, grader.failure(record, std::string("failed: ") + error.what()));
      ++outcome_.n_failed;
      progress_(fmt::format("{} {} · {} · failed: {}", count, scene_->name, label(contender), error.what()));
    }
    ++outcome_.n_run;
  }

  std::unique_ptr<Prepared> prepare(const Model& mesh, const Contender& contender) const {
    return catalogue_.method(contender.method)
        .prepare(mesh, contender.settings, catalogue_.integrator(contender.integrator));
  }

  // Online: load projection, stepping and reconstruction of displacements at the frame times.
  Timing time_online(const Prepared& prepared, bool repeat) const {
    const Sampling frames{frame_times(*scene_), false};
    const auto online = [&] { prepared.simulate(frames); };
    if (repeat) return measure(online);
    return {seconds(online), std::numeric_limits<double>::quiet_NaN(), 1};
  }

  void finish(const std::string& count, const std::vector<Record>& records) const {
    double error = std::nan(""), time = std::nan("");
    for (const Record& r : records) {
      if (r.metric == "displacement-error" && r.truth == "finer") error = r.value;
      if (r.metric == "online-time") time = r.value;
    }
    progress_(fmt::format("{} {} · {} · error {:.2e} · {:.3g} s", count, scene_->name, label(records.front().contender),
                          error, time));
  }

  std::vector<std::string> front() const { return dear_front(current_records(store_, {*scene_}).records); }

  // Repeats the time of dear full-order runs that may be the cheapest at some error.
  void time_the_front(const Grader& grader) {
    const std::vector<Record> all = current_records(store_, {*scene_}).records;
    for (const std::string& run : dear_front(all)) {
      if (stop()) return;
      std::vector<Record> records;
      for (const Record& r : all)
        if (r.run == run) records.push_back(r);
      const Contender contender = records.front().contender;
      progress_(fmt::format("{} · timing {}", scene_->name, label(contender)));
      const auto prepared = prepare(model(contender.resolution), contender);
      const Timing online = time_online(*prepared, true);
      for (Record& r : records)
        if (r.metric == "online-time") r = grader.number(r, r.metric, r.unit, online.median, online.spread);
      store_.write_records(run, records);
    }
  }

  std::shared_ptr<const Scene> scene_;
  const Catalogue& catalogue_;
  const Store& store_;
  const RunOptions& options_;
  const Progress& progress_;
  std::unique_ptr<Model> model_;
  Resolution model_resolution_{};
  double assembly_ = 0;  // [s] of the model at hand
  CaseOutcome outcome_;
};

}  // namespace

CaseOutcome run_case(const std::shared_ptr<const Scene>& scene, const Catalogue& catalogue, const Store& store,
                     const RunOptions& options, const Progress& progress) {
  return CaseRun(scene, catalogue, store, options, progress).run();
}

}  // namespace mb
