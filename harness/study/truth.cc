#include "harness/study/truth.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <future>
#include <mutex>
#include <optional>
#include <set>
#include <stdexcept>

#include "cases/exact/exact.h"
#include "harness/measure.h"
#include "harness/study/estimate.h"
#include "harness/study/identity.h"
#include "harness/study/memory.h"
#include "harness/study/storable.h"
#include "mechanics/algebra/threads.h"
#include "modal/bases/eigenmodes.h"
#include "reference/full_model.h"

namespace mb {

namespace {

struct TruthJob {
  Resolution resolution;
  double tolerance;
  Trajectory* result;
};

class TruthRuns {
 public:
  TruthRuns(std::shared_ptr<const Scene> scene, const Catalogue& catalogue, const Store& store,
            const Progress& progress)
      : scene_(std::move(scene)), catalogue_(catalogue), store_(store), progress_(progress) {}

  // Whether the store may hold it, and whether it did.
  bool has(const TruthJob& job) const { return store_.has_truth(truth_hash(*scene_, job.resolution, job.tolerance)); }
  void require_room(const TruthJob& job) const {
    store_.require_room(truth_hash(*scene_, job.resolution, job.tolerance));
  }
  bool find(const TruthJob& job) {
    auto stored = read(truth_hash(*scene_, job.resolution, job.tolerance));
    if (stored) *job.result = std::move(*stored);
    return stored.has_value();
  }
  void run(const TruthJob& job) {
    if (find(job)) return;  // another one of the case, or another process, may have stored it since
    const std::string hash = truth_hash(*scene_, job.resolution, job.tolerance);
    const double time = seconds([&] { *job.result = compute(job); });
    if (job.result->status != Status::ok)
      throw std::runtime_error(fmt::format("the truth of {} on {} at rtol {:.0e} failed: {}", scene_->name,
                                           to_string(job.resolution), job.tolerance, to_string(job.result->status)));
    job.result->case_name = scene_->name;
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
      Trajectory stored = store_.read_truth(hash);
      if (fits(stored)) return stored;
      if (is_news(hash))
        say(fmt::format("truth {}: is of other times or points than the case asks for; computed again", hash));
      return {};
    } catch (const StoreError& damaged) {
      if (is_news(hash)) say(std::string(damaged.what()) + "; computed again");
      return {};
    }
  }
  Trajectory compute(const TruthJob& job) const {
    const Model model = make_model(scene_, job.resolution);
    Settings settings;
    settings.relative_tolerance = job.tolerance;
    return catalogue_.method("full-order")
        .prepare(model, settings, catalogue_.integrator("sundials"))
        ->simulate({sample_times(*scene_), true});
  }
  // Sound files may be of another case, under this one's name.
  bool fits(const Trajectory& stored) const {
    const VectorXd times = sample_times(*scene_);
    if (stored.t.size() != times.size() || stored.bodies.size() != scene_->bodies.size()) return false;
    if (!((stored.t - times).cwiseAbs().maxCoeff() <= 1e-9 / scene_->samples_per_second)) return false;
    for (std::size_t i = 0; i < stored.bodies.size(); ++i) {
      const Body& body = scene_->bodies[i];
      const EvaluationPoints points = evaluation_points(*scene_, body);
      const auto& [displacement, strain] = std::tie(stored.bodies[i].displacement, stored.bodies[i].strain);
      if (displacement.rows() != 3 * points.size() || displacement.cols() != times.size()) return false;
      if (strain.rows() != 6 * points.n_strained() || strain.cols() != times.size()) return false;
    }
    return true;
  }
  bool is_news(const std::string& hash) {
    const std::lock_guard lock(mutex_);
    return told_.insert(hash).second;
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
  std::set<std::string> told_;  // hashes of truths that were found damaged
};

// Of those that are missing and of reading the others; before either is begun.
double memory_of(const std::vector<TruthJob>& missing, const Scene& scene) {
  std::vector<Resolution> meshes;
  for (const TruthJob& job : missing)
    if (std::ranges::find(meshes, job.resolution) == meshes.end()) meshes.push_back(job.resolution);
  return memory_of_truths(scene, meshes);
}

void require_feasible(const std::vector<TruthJob>& missing, const Scene& scene) {
  if (!missing.empty()) require_storable(scene);
  require_memory(memory_of(missing, scene), available_memory());
}

// All that are missing, or false where interrupted. The finer one costs about as much as the others together: two
// lanes.
bool computed(const std::vector<TruthJob>& missing, const TruthSet& set, TruthRuns& runs, const Scene& scene,
              const std::function<bool()>& interrupted) {
  const auto is_finer = [&](const TruthJob& job) { return job.result == &set.finer; };
  try {
    auto lane = std::async(std::launch::async, [&] {
      forbid_openmp();
      for (const TruthJob& job : missing)
        if (is_finer(job)) runs.run(job);
    });
    for (const TruthJob& job : missing) {
      if (is_finer(job)) continue;
      if (interrupted()) return lane.get(), false;
      runs.run(job);
    }
    lane.get();
  } catch (const std::bad_alloc& error) {
    throw std::runtime_error(failure_text(error, memory_of(missing, scene)));
  }
  return true;
}

// What the mass that both meshes lack may come to; 0 where there is nothing to compare.
double of_missing_mass(const Metric& metric, const TruthSet& truth, const MetricContext& context) {
  const double size = metric.of_truth_alone ? mark(metric, truth.finer, truth.finer, context).value
                                            : truth_size(metric, truth.finer, context);
  return std::isfinite(size) ? metric.per_mass * truth.missing_volume * size : 0;
}

// How far the finer truth is from the closed form, beyond that one's own bar; 0 of what it leaves out.
double beyond_exact(const Metric& metric, const TruthSet& truth, const MetricContext& context) {
  if (!truth.exact || metric.of_truth_alone) return 0;
  const double off = distance(metric, *truth.exact, truth.finer, context);
  return std::isfinite(off) ? off - truth.exact_bar * truth_size(metric, *truth.exact, context) : 0;
}

}  // namespace

Modes modes_of_a_mesh(const System& system, const Body& body, int n_elastic) {
  return lowest_modes(system, n_elastic, physical_shift(body));
}

Model make_model(const std::shared_ptr<const Scene>& scene, const Resolution& resolution) {
  return build_model(scene, &resolution, modes_of_a_mesh);
}

const Trajectory& TruthSet::of(TruthKind kind) const {
  if (kind == TruthKind::exact && !exact) throw std::logic_error("the case names no exact solution");
  if (kind == TruthKind::same_modes) throw std::logic_error("the closed form of modes is no truth of the case");
  return kind == TruthKind::finer ? finer : kind == TruthKind::same_mesh ? same_mesh : *exact;
}

std::optional<TruthSet> truths(const std::shared_ptr<const Scene>& scene, const Catalogue& catalogue,
                               const Store& store, const Progress& progress, const std::function<bool()>& interrupted) {
  if (interrupted()) return {};
  TruthSet set;
  TruthRuns runs(scene, catalogue, store, progress);
  const TruthSettings& t = scene->truth;
  const Resolution mesh = own_meshes(*scene);
  std::vector<TruthJob> missing{{t.finer, t.relative_tolerance, &set.finer},
                                {t.coarser, t.relative_tolerance, &set.coarser},
                                {mesh, t.relative_tolerance / 100, &set.same_mesh},
                                {mesh, t.relative_tolerance, &set.loose}};
  for (const TruthJob& job : missing) runs.require_room(job);
  std::vector<TruthJob> without_file = missing;
  std::erase_if(without_file, [&](const TruthJob& job) { return runs.has(job); });
  require_feasible(without_file, *scene);
  std::erase_if(missing, [&](const TruthJob& job) { return runs.find(job); });  // what is damaged is missing, too
  if (missing.size() > without_file.size()) require_feasible(missing, *scene);
  if (!missing.empty() && !computed(missing, set, runs, *scene, interrupted)) return {};
  // What they differ by is in their distance.
  const double lack = missing_volume(*scene, t.finer);
  set.missing_volume = std::max(0.0, lack - std::abs(missing_volume(*scene, t.coarser) - lack));
  set.per_distance = bars_per_distance(*scene);
  if (!t.exact.empty()) {
    const ExactSolution& solution = exact_solution(t.exact);
    set.exact = solution.at(*scene, evaluation_points(*scene, scene->bodies.front()), sample_times(*scene));
    set.exact_bar = solution.error_bar;
  }
  return set;
}

void name_damaged_truths(const Scene& scene, const Store& store, const Progress& progress) {
  for (const std::string& hash : truth_hashes(scene)) try {
      if (store.has_truth(hash)) store.read_truth(hash);
    } catch (const StoreError& damaged) {
      progress(std::string(damaged.what()) + "; computed again once it is needed");
    }
}

double error_bar(const Metric& metric, const TruthSet& truth, TruthKind kind, const MetricContext& context) {
  if (kind == TruthKind::exact) return truth.exact_bar * truth_size(metric, truth.of(kind), context);
  const double time = distance(metric, truth.loose, truth.same_mesh, context);
  if (kind == TruthKind::same_mesh) return time;
  const PerDistance& F = truth.per_distance;
  const double mesh =
      (is_of_least_order(metric) ? F.local : F.mean) * distance(metric, truth.coarser, truth.finer, context) +
      of_missing_mass(metric, truth, context);
  return std::max(time + mesh, beyond_exact(metric, truth, context));
}

}  // namespace mb
