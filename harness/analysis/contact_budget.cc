#include "harness/analysis/contact_budget.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>

#include "harness/analysis/budget_tables.h"
#include "harness/analysis/contact_variants.h"
#include "harness/analysis/modal_body.h"
#include "harness/analysis/told.h"
#include "harness/study/truth.h"

namespace mb {

namespace {

constexpr int n_mode_counts = 3, refinement = 4;
constexpr double hardly_any = 1e-4;  // [-] of the static shapes' mass: a hundredth of the period

std::string in_words(bool finite) {
  return fmt::format(
      "modal in steps, modal in steps of a quarter of that, the same modes and static shapes in the contact of full "
      "order (small rotations, points on the mesh's surface in the place of the exact one), these shapes with their "
      "mass, full order on the same mesh{0}, full order on the finer mesh{0}{1}",
      finite ? " with linear kinematics" : "", finite ? ", finite strain on that" : "");
}

class ContactBudget {
 public:
  explicit ContactBudget(const AnalysisContext& context)
      : context_(context),
        scene_(*context.scene),
        finite_(
            std::ranges::any_of(scene_.bodies, [](const Body& body) { return body.kinematics == Kinematics::finite; })),
        exact_(context.truth.exact && context.truth.exact->bodies.front().displacement.cols() > 0),
        tables_(in_words(finite_), exact_ ? std::optional(context.truth.exact_bar) : std::nullopt),
        beside_(in_words(finite_)),
        variants_(context) {
    for (const Body& body : scene_.bodies) points_.push_back(evaluation_points(scene_, body));
    finite_ ? add_finite_truths() : add_truths("truncation");
    if (exact_) add_full("finer mesh", *context.truth.exact, *context.truth.exact);
  }

  void add(const std::string& method, int r) {
    const double h = variants_.contenders().front().time_step;
    const auto modal = [&](double step) {
      return variants_.prepare(scene_, {method, r, step})->simulate({.t = sample_times(scene_)});
    };
    const Trajectory stepped = modal(h), limit = modal(h / refinement);
    const auto on_mesh = [&](double mass_of_shapes) {
      return tried("modes on the mesh's surface", [&] {
        return variants_.prepare_on_mesh({method, r}, mass_of_shapes);
      });
    };
    const bool with_shapes = method == "static-correction";
    const auto massless = on_mesh(hardly_any), with_mass = with_shapes ? on_mesh(1) : std::nullopt;
    for (size_t b = 0; b < points_.size(); ++b) {
      std::vector<BudgetLink> chain{{"", normed(stepped, b)}, {"time stepping", normed(limit, b)}};
      chain.push_back({"contact on the surface", normed(massless, b)});
      if (with_shapes) chain.push_back({"mass of static shapes", normed(with_mass, b)});
      const BudgetOf of{scene_.bodies[b].name, method, static_cast<double>(r), "exact",
                        fmt::format("dt = {:.3g} s", h)};
      std::vector<BudgetLink> other = chain;
      for (const FullLink& link : full_) {
        chain.push_back({link.name, normed(link.answer, b)});
        other.push_back({link.name, normed(link.neighbour, b)});
      }
      tables_.add(of, chain);
      beside_.add(of, other);
    }
  }

  std::vector<Finding> findings() && {
    for (const auto& [what, reason] : reasons_) tables_.note(reason);
    std::vector<Finding> found = std::move(tables_).findings();
    add_bars(found, std::move(beside_).findings(), context_.truth.per_distance);
    return found;
  }

 private:
  // What is not told of the truth is its own neighbour: full order with linear kinematics.
  struct FullLink {
    std::string name;
    std::optional<Trajectory> answer, neighbour;
  };

  std::shared_ptr<const Normed> normed(const Trajectory& answer, size_t b) const {
    return in_both_norms(answer, {scene_, static_cast<Index>(b), points_[b], !is_held(scene_.bodies[b])});
  }

  std::shared_ptr<const Normed> normed(const std::optional<Trajectory>& answer, size_t b) const {
    return answer ? normed(*answer, b) : nullptr;
  }

  // Nothing where it cannot be made: why goes into the note.
  std::optional<Trajectory> tried(const std::string& what, const std::function<std::unique_ptr<Prepared>()>& prepare) {
    std::string reason;
    try {
      Trajectory answer = prepare()->simulate({.t = sample_times(scene_)});
      if (answer.status == Status::ok) return answer;
      reason = to_string(answer.status);
    } catch (const std::exception& error) {
      reason = error.what();
    }
    // One reason for each: others of its kind differ in numbers alone.
    reasons_.try_emplace(what, fmt::format("Links are merged for want of {}: {}.", what, reason));
    return {};
  }

  void add_full(const std::string& name, std::optional<Trajectory> answer, std::optional<Trajectory> neighbour) {
    full_.push_back({name, std::move(answer), std::move(neighbour)});
  }

  void add_truths(const std::string& truncation) {
    add_full(truncation, context_.truth.same_mesh, context_.truth.loose);
    add_full("discretisation", context_.truth.finer, context_.truth.coarser);
  }

  // Where linear kinematics carry nothing at all, the truth on the same mesh still tells the finer mesh's part.
  void add_finite_truths() {
    const double rtol = scene_.truth.relative_tolerance;
    auto same_mesh = linear_truth("full order with linear kinematics", own_meshes(scene_), rtol / 100);
    if (!same_mesh) {
      add_truths("truncation + finite strain");
      return;
    }
    add_full("truncation", same_mesh, same_mesh);
    const auto finer = linear_truth("the finer mesh with linear kinematics", scene_.truth.finer, rtol);
    add_full("discretisation", finer, finer);
    add_full("finite strain", context_.truth.finer, context_.truth.coarser);
  }

  std::optional<Trajectory> linear_truth(const std::string& what, const Resolution& mesh, double rtol) {
    const Model model = model_of_own_mesh(std::make_shared<const Scene>(linearised(scene_)), mesh);
    Settings settings;
    settings.relative_tolerance = rtol;
    return tried(what, [&] {
      return context_.catalogue.method("full-order")
          .prepare(model, settings, context_.catalogue.integrator("sundials"));
    });
  }

  const AnalysisContext& context_;
  const Scene& scene_;
  bool finite_;                   // any body
  bool exact_;                    // a closed form that has more than the contact
  BudgetTables tables_, beside_;  // of the truths and of their neighbours
  ContactVariants variants_;
  std::vector<EvaluationPoints> points_;        // of every body
  std::vector<FullLink> full_;                  // after the modal answers
  std::map<std::string, std::string> reasons_;  // by what is missing
};

}  // namespace

std::vector<Finding> contact_budget(const AnalysisContext& context) {
  ContactBudget budget(context);
  for (const char* method : {"eigenmodes", "static-correction"}) {
    if (std::ranges::find(context.scene->study.methods, method) == context.scene->study.methods.end()) continue;
    for (const int r : few(mode_counts(context), n_mode_counts)) budget.add(method, r);
  }
  return std::move(budget).findings();
}

}  // namespace mb
