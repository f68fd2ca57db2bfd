#include "harness/study/truth.h"

#include <fmt/format.h>

#include <future>
#include <mutex>
#include <optional>
#include <stdexcept>

#include "cases/exact/exact.h"
#include "harness/measure.h"
#include "harness/study/estimate.h"
#include "harness/study/identity.h"
#include "harness/study/memory.h"
#include "mechanics/algebra/threads.h"
#include "modal/bases/eigenmodes.h"
#include "reference/full_model.h"

namespace mb {

namespace {

struct Job {
  Resolution resolution;
  double tolerance;
  Trajectory* result;
};

class TruthRuns {
 public:
  TruthRuns(std::shared_ptr<const Scene> scene, const Catalogue& catalogue, const Store& store,
            const Progress& progress)
      : scene_(std::move(scene)), catalogue_(catalogue), store_(store), progress_(progress) {}

  void run(const Job& job) {
    const std::string hash = truth_hash(*scene_, job.resolution, job.tolerance);
    if (auto stored = read(hash)) {
      *job.result = std::move(*stored);
      return;
    }
    const double time = seconds([&] { *job.result = compute(job); });
    if (job.result->status != Status::ok)
      throw std::runtime_error(fmt::format("the truth of {} on {} at rtol {:.0e} failed: {}", scene_->name,
                                           to_string(job.resolution), job.tolerance, to_string(job.result->status)));
    write(hash, *job.result);
    // What is stored is cut at 1e-12 (trajectory_file.h): whoever computed it goes on with what all others read.
    if (auto stored = read(hash)) *job.result = std::move(*stored);
    say(fmt::format("{} · truth {} rtol {:.0e} · {} steps · {:.1f} s", scene_->name, to_string(job.resolution),
                    job.tolerance, job.result->work.steps, time));
  }

 private:
  // HDF5's library serves one thread at a time.
  void write(const std::string& hash, const Trajectory& trajectory) {
    const std::lock_guard lock(store_mutex_);
    store_.write_truth(hash, trajectory);
  }
  std::optional<Trajectory> read(const std::string& hash) {
    if (!store_.has_truth(hash)) return {};
    try {
      const std::lock_guard lock(store_mutex_);
      return store_.read_truth(hash);
    } catch (const StoreError& damaged) {
      say(std::string(damaged.what()) + "; computed again");
      return {};
    }
  }
  Trajectory compute(const Job& job) const {
    const Model model = make_model(scene_, job.resolution);
    Settings settings;
    settings.relative_tolerance = job.tolerance;
    return catalogue_.method("full-order")
        .prepare(model, settings, catalogue_.integrator("sundials"))
        ->simulate({sample_times(*scene_), true});
  }
  void say(const std::string& line) {
    const std::lock_guard lock(mutex_);
    progress_(line);
  }

  std::shared_ptr<const Scene> scene_;
  const Catalogue& catalogue_;
  const Store& store_;
  const Progress& progress_;
  std::mutex mutex_, store_mutex_;
};

}  // namespace

Modes modes_of_a_mesh(const System& system, const Body& body, int n_elastic) {
  return lowest_modes(system, n_elastic, physical_shift(body));
}

Model make_model(const std::shared_ptr<const Scene>& scene, const Resolution& resolution) {
  return build_model(scene, &resolution, modes_of_a_mesh);
}

const Trajectory& TruthSet::of(TruthKind kind) const {
  if (kind == TruthKind::exact && !exact) throw std::logic_error("the case names no exact solution");
  return kind == TruthKind::finer ? finer : kind == TruthKind::same_mesh ? same_mesh : *exact;
}

std::optional<TruthSet> truths(const std::shared_ptr<const Scene>& scene, const Catalogue& catalogue,
                               const Store& store, const Progress& progress, const std::function<bool()>& interrupted) {
  if (interrupted()) return {};
  TruthSet set;
  TruthRuns runs(scene, catalogue, store, progress);
  const TruthSettings& t = scene->truth;
  const Resolution mesh = own_meshes(*scene);
  const auto is_stored = [&](const Resolution& resolution, double tolerance) {
    return store.has_truth(truth_hash(*scene, resolution, tolerance));
  };
  if (!is_stored(t.finer, t.relative_tolerance) || !is_stored(t.coarser, t.relative_tolerance) ||
      !is_stored(mesh, t.relative_tolerance / 100) || !is_stored(mesh, t.relative_tolerance))
    require_memory(memory(*scene), available_memory());
  // The finer one costs about as much as the others together: two lanes.
  auto lane = std::async(std::launch::async, [&] {
    forbid_openmp();
    runs.run({t.finer, t.relative_tolerance, &set.finer});
  });
  for (const Job& job :
       {Job{t.coarser, t.relative_tolerance, &set.coarser}, Job{mesh, t.relative_tolerance / 100, &set.same_mesh},
        Job{mesh, t.relative_tolerance, &set.loose}}) {
    if (interrupted()) return lane.get(), std::nullopt;
    runs.run(job);
  }
  lane.get();
  if (!t.exact.empty()) {
    const ExactSolution& solution = exact_solution(t.exact);
    set.exact = solution.at(*scene, evaluation_points(*scene, scene->bodies.front()), sample_times(*scene));
    set.exact_bar = solution.error_bar;
  }
  return set;
}

double error_bar(const Metric& metric, const TruthSet& truth, TruthKind kind, const MetricContext& context) {
  if (kind == TruthKind::exact) return truth.exact_bar * truth_size(metric, truth.of(kind), context);
  const double time = distance(metric, truth.loose, truth.same_mesh, context);
  return kind == TruthKind::same_mesh ? time : time + distance(metric, truth.coarser, truth.finer, context);
}

}  // namespace mb
