#include "harness/study/bench.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "harness/study/memory.h"
#include "harness/study/plan.h"

namespace mb {

namespace {

// Frames, and the end where none falls on it: what happens in between counts, too.
VectorXd frames_to_the_end(const Scene& scene) {
  VectorXd t = frame_times(scene);
  if (t[t.size() - 1] == scene.duration) return t;
  t.conservativeResize(t.size() + 1);
  t[t.size() - 1] = scene.duration;
  return t;
}

}  // namespace

void Bench::let_go() {
  basis_ = {}, closed_form_ = {};
  model_.reset();
}

const Model& Bench::model(const Resolution& resolution) {
  if (!model_ || !(resolution_ == resolution)) {
    let_go();
    assembly_ = seconds([&] { model_ = std::make_unique<Model>(make_model(scene_, resolution)); });
    resolution_ = resolution;
  }
  return *model_;
}

const Model& Bench::model(const Resolution& resolution, double needed, std::optional<double> available) {
  if (!model_ || !(resolution_ == resolution)) {
    let_go();
    require_memory(needed, available);
  }
  return model(resolution);
}

const Bench::Basis& Bench::basis(const LinearMethod& method, const Settings& settings, const Model& mesh) {
  const bool known = basis_.reduction && basis_.method == method.name() && basis_.modes == settings.modes;
  if (!known) {
    basis_ = {method.name(), settings.modes, nullptr, 0};
    basis_.time = seconds([&] { basis_.reduction = std::make_shared<const Reduction>(method.reduce(mesh, settings)); });
  }
  return basis_;
}

ReadyContender Bench::prepare(const Contender& contender) {
  const Model& mesh = model(contender.resolution);
  const Method& method = catalogue_.method(contender.method);
  const Integrator& integrator = catalogue_.integrator(contender.integrator);
  ReadyContender ready{nullptr, assembly_, 0, nullptr};
  if (const auto* linear = dynamic_cast<const LinearMethod*>(&method)) {
    const Basis& shared = basis(*linear, contender.settings, mesh);
    ready.reduction = shared.reduction;
    ready.preparation = shared.time + seconds([&] {
                          ready.prepared =
                              prepare_linear(shared.reduction, integrator, contender.settings, scene_->duration);
                        });
  } else {
    ready.preparation = seconds([&] { ready.prepared = method.prepare(mesh, contender.settings, integrator); });
  }
  return ready;
}

const Prepared* Bench::closed_form(const Contender& contender, const ReadyContender& ready) {
  if (!ready.reduction || ready.reduction->in_contact || !steps_modes(contender)) return nullptr;
  if (closed_form_.reduction != ready.reduction) {
    Settings settings = contender.settings;
    settings.load_tolerance = scene_->study.load_tolerance;
    closed_form_ = {ready.reduction,
                    prepare_linear(ready.reduction, catalogue_.integrator("exact"), settings, scene_->duration)};
  }
  return closed_form_.prepared.get();
}

std::vector<Record> Bench::times(const Grader& grader, const Record& base, const ReadyContender& ready,
                                 double repeat_below) const {
  std::vector<Record> records;
  const auto add = [&](const char* metric, const Timing& time) {
    records.push_back(grader.number(base, metric, "s", time.median, time.spread));
    records.back().provenance["repeats"] = std::to_string(time.repeats);
    if (std::isfinite(time.busy)) records.back().provenance["busy"] = fmt::format("{:.3f}", time.busy);
  };
  const auto single = [](double t) { return Timing{t, std::numeric_limits<double>::quiet_NaN(), 1}; };
  Sampling frames{.t = frames_to_the_end(*scene_), .strain = false};
  Work work;
  const auto online = [&] { work = ready.prepared->simulate(frames).work; };
  const Timing first = once(online);
  const bool is_cheap = first.median < cheap;
  add("online-time", first.median < repeat_below ? measure(online, is_cheap ? 5 : 3) : first);
  records.back().work = work;  // of the run that is timed: marks are taken at many more points in time
  frames.reconstruct = false;
  if (is_cheap) add("stepping-time", measure(online));  // stands beside the online time, decides nothing
  add("assembly-time", single(ready.assembly));
  add("offline-time", single(ready.assembly + ready.preparation));
  return records;
}

}  // namespace mb
