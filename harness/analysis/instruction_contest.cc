#include "harness/analysis/instruction_contest.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "cases/contract/touchdown.h"
#include "harness/instruction_counter.h"
#include "harness/study/truth.h"

namespace mb {

namespace {

constexpr int wanted_modes = 32;
constexpr double counted_share = 0.05;  // [-] of the time after the first touch, of full order

int nearest_count(const std::vector<int>& counts) {
  if (counts.empty()) return wanted_modes;
  return *std::ranges::min_element(counts, {}, [](int r) { return std::abs(r - wanted_modes); });
}

double first_touch(const Scene& scene) {
  double first = scene.duration;
  for (const Body& body : scene.bodies) first = std::min(first, touchdown(scene, body).t);
  return first;
}

double largest_step(const Study& study) {
  double largest = 0;
  for (const Rival& rival : study.rivals)
    if (rival.integrator == "newmark")
      for (const double h : rival.time_steps) largest = std::max(largest, h);
  return largest;
}

}  // namespace

std::vector<CountedContender> counted_contenders(const Scene& scene) {
  if (scene.contacts.empty() || scene.study.contact_steps.empty())
    throw std::invalid_argument("instructions are counted of scenes with contact and contact_steps");
  Settings settings;
  settings.time_step = std::ranges::max(scene.study.contact_steps);
  std::vector<CountedContender> all;
  all.push_back({"rigid", "eigenmodes", "exact", settings, scene.duration});
  all.push_back({"linear", "linear", "exact", settings, scene.duration});
  all.push_back({"quadratic", "quadratic", "exact", settings, scene.duration});
  settings.modes = nearest_count(scene.study.modes);
  all.push_back({"static-correction", "static-correction", "exact", settings, scene.duration});
  Settings full;
  full.time_step = largest_step(scene.study);
  const double touch = first_touch(scene);
  if (full.time_step > 0 && touch < scene.duration)
    all.push_back({"full order", "full-order", "newmark", full, touch + counted_share * (scene.duration - touch)});
  return all;
}

VectorXd counted_times(const Scene& scene, const CountedContender& contender) {
  const VectorXd frames = frame_times(scene);
  std::vector<double> t;
  std::ranges::copy_if(frames, std::back_inserter(t), [&](double frame) { return frame < contender.until; });
  t.push_back(contender.until);
  return Eigen::Map<const VectorXd>(t.data(), std::ssize(t));
}

std::unique_ptr<Prepared> prepare(const CountedContender& contender, const Catalogue& catalogue, const Model& model) {
  return catalogue.method(contender.method)
      .prepare(model, contender.settings, catalogue.integrator(contender.integrator));
}

Trajectory counted_work(const Prepared& prepared, const VectorXd& times) {
  return prepared.simulate({.t = times, .strain = false});
}

void count_contest(const std::shared_ptr<const Scene>& scene, const Catalogue& catalogue) {
  const Model model = make_model(scene, own_meshes(*scene));
  for (const CountedContender& contender : counted_contenders(*scene)) {
    const auto prepared = prepare(contender, catalogue, model);
    const VectorXd times = counted_times(*scene, contender);
    counted(contender.name, [&] { counted_work(*prepared, times); });
  }
}

}  // namespace mb
