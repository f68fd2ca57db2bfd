#include "harness/analysis/contact_variants.h"

#include <algorithm>
#include <stdexcept>

#include "harness/analysis/basis_model.h"
#include "modal/bases/eigenmodes.h"
#include "modal/bases/ritz_modes.h"
#include "modal/contact/contact_shapes.h"
#include "modal/contact/contact_step.h"

namespace mb {

namespace {

// What is prepared keeps the model that it refers to.
class Keeping final : public Prepared {
 public:
  Keeping(std::shared_ptr<const Model> model, std::unique_ptr<Prepared> prepared)
      : model_(std::move(model)), prepared_(std::move(prepared)) {}
  Trajectory simulate(const Sampling& sampling) const override { return prepared_->simulate(sampling); }
  std::vector<Decision> decisions() const override { return prepared_->decisions(); }
  int modes_used() const override { return prepared_->modes_used(); }
  Index n_unknowns() const override { return prepared_->n_unknowns(); }
  double load_error() const override { return prepared_->load_error(); }

 private:
  std::shared_ptr<const Model> model_;
  std::unique_ptr<Prepared> prepared_;
};

double least_step(const Study& study) {
  if (study.contact_steps.empty()) throw std::invalid_argument("the study has no contact_steps to take one from");
  return std::ranges::min(study.contact_steps);
}

}  // namespace

Scene linearised(const Scene& scene) {
  Scene linear = scene;
  for (Body& body : linear.bodies) body.kinematics = Kinematics::linear;
  return linear;
}

Scene thrown(const Scene& scene, double factor, double flight, double after) {
  Scene changed = scene;
  Body& body = changed.bodies.front();
  const Touchdown down = touchdown(scene, body);
  const auto waits = [&](const Body& b) {
    const bool rests = b.twist.velocity.isZero(0) && b.twist.angular_velocity.isZero(0) && scene.gravity.isZero(0);
    return is_held(b) || rests || &b == &scene.bodies.front();
  };
  if (is_held(body) || !std::ranges::all_of(scene.bodies, waits) || !body.twist.angular_velocity.isZero(0) ||
      !std::isfinite(down.t))
    throw std::invalid_argument(
        "only of one body that moves freely without spin, the first, and meets an obstacle or a body that is held or "
        "at rest where nothing pulls it");
  const Vector3d v = body.twist.velocity + down.t * scene.gravity;
  body.pose.position += down.t * body.twist.velocity + down.t * down.t / 2 * scene.gravity - flight * factor * v;
  body.twist.velocity = factor * v;
  changed.gravity.setZero();
  changed.duration = flight + after;
  changed.samples_from = 0;
  // The layer stays the scene's own where it is found from speed and weight, too.
  for (const Meeting& meeting : down.meetings) changed.contacts[meeting.contact].stiffness = meeting.size.stiffness;
  return changed;
}

ContactVariants::ContactVariants(const AnalysisContext& context)
    : context_(context), n_modes_(std::ranges::max(mode_counts(context))), body_(modal_body(context, n_modes_)) {
  if (context.scene->contacts.empty()) throw std::invalid_argument("the scene has no contact to be varied");
  modes_.push_back(body_.modes);
  for (std::size_t i = 1; i < context.scene->bodies.size(); ++i)
    modes_.push_back(
        lowest_modes(body_.scene_model.bodies[i].full->system(), n_modes_, physical_shift(context.scene->bodies[i])));
}

std::vector<ContactContender> ContactVariants::contenders() const {
  const double h = least_step(context_.scene->study);
  return {{"eigenmodes", n_modes_, h}, {"static-correction", n_modes_, h}, {"full-order", -1}};
}

Scene ContactVariants::with_stiffness(std::size_t contact, double stiffness) const {
  Scene scene = *context_.scene;
  scene.contacts.at(contact).stiffness = stiffness;
  return scene;
}

Scene ContactVariants::with_flight(double flight, double after) const {
  if (context_.scene->bodies.size() > 1) throw std::invalid_argument("only of one body that meets an obstacle");
  return thrown(*context_.scene, 1, flight, after);
}

namespace {

std::shared_ptr<Model> with_scene(const Model& model, const Scene& scene) {
  auto changed = std::make_shared<Model>(model);
  changed->scene = std::make_shared<const Scene>(scene);
  return changed;
}

std::shared_ptr<const FloatingBases> bases_of(const Model& model, const std::vector<Modes>& all,
                                              const ContactContender& contender) {
  const int degree = contender.method == "linear" ? 1 : contender.method == "quadratic" ? 2 : 0;
  std::vector<Modes> asked;
  for (size_t i = 0; i < all.size(); ++i) {
    const FullModel& full = *model.bodies[i].full;
    asked.push_back(degree > 0 ? ritz_modes(full.system(), full.polynomials(degree))
                               : leading(all[i], contender.modes));
  }
  return std::make_shared<const FloatingBases>(
      floating_bases(model, asked, contender.method == "static-correction", contender.finest_sample));
}

}  // namespace

std::shared_ptr<const FloatingBases> ContactVariants::bases(const Scene& scene,
                                                            const ContactContender& contender) const {
  return bases_of(*with_scene(body_.scene_model, scene), modes_, contender);
}

std::unique_ptr<Prepared> ContactVariants::prepare(const Scene& scene, const ContactContender& contender) const {
  const auto changed = with_scene(body_.scene_model, scene);
  Settings settings;
  if (contender.modes < 0) {
    settings.relative_tolerance = scene.truth.relative_tolerance;
    auto prepared =
        context_.catalogue.method("full-order").prepare(*changed, settings, context_.catalogue.integrator("sundials"));
    return std::make_unique<Keeping>(changed, std::move(prepared));
  }
  settings.time_step = contender.time_step;
  return std::make_unique<Keeping>(changed,
                                   prepare_floating(bases_of(*changed, modes_, contender),
                                                    context_.catalogue.integrator(contender.integrator), settings));
}

std::unique_ptr<Prepared> ContactVariants::prepare_on_mesh(const ContactContender& contender,
                                                           double mass_of_shapes) const {
  const auto mesh = with_scene(body_.scene_model, linearised(*context_.scene));
  std::vector<Basis> bases;
  for (std::size_t i = 0; i < modes_.size(); ++i) {
    const Body& body = mesh->scene->bodies[i];
    const BodyModel& model = mesh->bodies[i];
    bases.push_back({leading(modes_[i], contender.modes)});
    if (contender.method != "static-correction") continue;
    const Modes modes = std::move(bases.back().modes);
    const MatrixXd Psi = contact_shapes(*mesh->scene, body, model, modes, physical_shift(body));
    bases.back() = with_shapes(modes, Psi, model.full->system(), mass_of_shapes);
  }
  const auto reduced = std::make_shared<const Model>(in_bases(*mesh, bases));
  Settings settings;
  settings.relative_tolerance = context_.scene->truth.relative_tolerance / 100;
  auto prepared =
      context_.catalogue.method("full-order").prepare(*reduced, settings, context_.catalogue.integrator("sundials"));
  return std::make_unique<Keeping>(reduced, std::move(prepared));
}

Trajectory ContactVariants::simulate(const Scene& scene, const ContactContender& contender) const {
  return prepare(scene, contender)->simulate({.t = sample_times(scene), .strain = false, .reconstruct = false});
}

Trajectory ContactVariants::simulate_coarsely(const Scene& scene, const ContactContender& contender) const {
  Scene loose = scene;
  ContactContender coarse = contender;
  loose.truth.relative_tolerance *= 10;
  coarse.time_step *= 2;
  return simulate(loose, coarse);
}

}  // namespace mb
