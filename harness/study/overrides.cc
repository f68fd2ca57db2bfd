#include "harness/study/overrides.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "cases/scene/printable.h"
#include "cases/scene/read_study.h"
#include "harness/study/study_table.h"

namespace mb {

namespace {

bool is_text(const TomlValue& value, const std::string& text) {
  const auto* own = std::get_if<std::string>(&value.value);
  return own != nullptr && *own == text;
}

// "none" stands alone: among other words it is one that nobody knows.
bool is_none(const TomlArray& words) { return words.items.size() == 1 && is_text(words.items[0], "none"); }

// What the case itself states has no place among the words: where it is refused for one of them, it is shown at that.
void place(TomlValue& value, const Position& where) {
  if (value.where.line > 0) return;
  value.where = where;
  if (auto* const array = std::get_if<TomlArray>(&value.value))
    for (TomlValue& item : array->items) place(item, where);
}
void place(TomlFields& fields, const Position& where) {
  for (auto& [key, value] : fields) place(value, where);
}

// One study, changed value by value into the tables of the study that is asked for.
class Change {
 public:
  Change(const Assignments& asked, const Vocabulary& vocabulary, const Study& study, Findings& findings)
      : asked_(asked), vocabulary_(vocabulary), all_(study_table(study)), findings_(findings) {}

  // Without it the study's own methods stay where they are, valid as they were, for the reader alone.
  bool has_closed_form() const {
    const auto* const integrators = words("modal.integrators");
    return !integrators ||
           std::ranges::any_of(integrators->items, [](const auto& name) { return is_text(name, "exact"); });
  }

  StudyTable run() {
    for (const char* key : {"modal.integrators", "rival.integrators"}) refuse_repeated(key);
    change_modal();
    change_rivals();
    refuse_idle_keys();
    replace(all_.fields, "analyses", "study.analyses");
    if (const auto* analyses = words("study.analyses"); analyses && is_none(*analyses)) all_.fields.erase("analyses");
    return all_;
  }

 private:
  const TomlArray* words(const std::string& key) const {
    const TomlValue* const found = asked_.find(key);
    return found == nullptr ? nullptr : &std::get<TomlArray>(found->value);
  }
  void replace(TomlFields& fields, const std::string& name, const std::string& key) {
    const TomlValue* const found = asked_.find(key);
    if (!found) return;
    fields[name] = *found;
    place(fields, found->where);
    taken_.insert(key);
  }

  // Each makes a table of its own: the reader would not know that they were one list.
  void refuse_repeated(const std::string& key) {
    const auto* const list = words(key);
    if (!list) return;
    for (auto here = list->items.begin(); here != list->items.end(); ++here) {
      const auto* const name = std::get_if<std::string>(&here->value);
      if (name && std::any_of(list->items.begin(), here, [&](const auto& other) { return is_text(other, *name); }))
        findings_.error(here->where, fmt::format("'{}' is listed twice", printable(*name)));
    }
  }

  // "relative_tolerances" or "time_steps", what the accuracy of the table's integrator is set by.
  std::string accuracy(const TomlFields& fields) const {
    const auto& adaptive = vocabulary_.adaptive_integrators;
    const bool chooses =
        std::ranges::any_of(adaptive, [&](const std::string& name) { return is_text(fields.at("integrator"), name); });
    return chooses ? "relative_tolerances" : "time_steps";
  }

  bool take_modes(const TomlFields& contender) const {
    const auto takes = [&](const TomlValue& method) {
      return std::ranges::none_of(vocabulary_.methods_without_modes,
                                  [&](const std::string& name) { return is_text(method, name); });
    };
    return std::ranges::any_of(std::get<TomlArray>(contender.at("methods").value).items, takes);
  }

  // A mode count is of no use where no method takes one: the reader would refuse it.
  void change_stepping(TomlFields& stepping) {
    replace(stepping, "methods", "modal.methods");
    if (take_modes(stepping))
      replace(stepping, "modes", "modal.modes");
    else
      stepping.erase("modes");
  }

  void change_modal() {
    const auto* const integrators = words("modal.integrators");
    if (integrators) all_.steppings.clear();
    for (const TomlValue& name : integrators ? integrators->items : std::vector<TomlValue>()) {
      if (is_text(name, "exact")) continue;
      TomlFields stepping{{"integrator", name}, {"methods", all_.fields.at("methods")}};
      if (all_.fields.contains("modes")) stepping["modes"] = all_.fields.at("modes");
      place(stepping, name.where);
      replace(stepping, accuracy(stepping), "modal." + accuracy(stepping));
      all_.steppings.push_back(std::move(stepping));
    }
    for (TomlFields& stepping : all_.steppings) change_stepping(stepping);
    if (has_closed_form()) replace(all_.fields, "methods", "modal.methods");
    const bool closed_form_takes_modes = has_closed_form() && take_modes(all_.fields);
    const bool modes_matter = closed_form_takes_modes || taken_.contains("modal.modes");
    replace(all_.fields, "modes", "modal.modes");
    if (!modes_matter) taken_.erase("modal.modes");
    replace(all_.fields, "contact_steps", "modal.contact_steps");
    for (const char* key : {"modal.time_steps", "modal.relative_tolerances"}) {
      const TomlValue* const found = asked_.find(key);
      if (!found || integrators) continue;
      findings_.error(found->where, fmt::format("'{}' needs modal.integrators", key));
      taken_.insert(key);  // once is enough
    }
  }

  // What would change nothing was meant to change something.
  void refuse_idle_keys() {
    for (const char* key : {"modal.modes", "modal.time_steps", "modal.relative_tolerances", "rival.degrees",
                            "rival.cells", "rival.time_steps", "rival.relative_tolerances"})
      if (const TomlValue* const found = asked_.find(key); found && !taken_.contains(key))
        findings_.error(found->where, fmt::format("no contender of the study takes '{}'", key));
  }

  void change_rivals() {
    if (const TomlValue* const cells = asked_.find("rival.cells"))
      for (TomlFields& rival : all_.rivals)
        if (rival.contains("second_cells")) place(rival.at("second_cells"), cells->where);  // one a mesh of these
    if (const auto* integrators = words("rival.integrators")) {
      std::vector<TomlFields> asked_for;
      for (const TomlValue& name : is_none(*integrators) ? std::vector<TomlValue>() : integrators->items) {
        const auto is_its = [&](const TomlFields& rival) {
          return is_text(name, std::get<std::string>(rival.at("integrator").value));
        };
        const size_t n = asked_for.size();
        std::ranges::copy_if(all_.rivals, std::back_inserter(asked_for), is_its);
        if (asked_for.size() == n) {
          asked_for.push_back(fields_of(Rival{"", {1, 2}, {}, {}, {}}));
          asked_for.back()["integrator"] = name;
        }
        for (size_t i = n; i < asked_for.size(); ++i) place(asked_for[i], name.where);
      }
      all_.rivals = std::move(asked_for);
    }
    for (TomlFields& rival : all_.rivals) {
      if (rival.contains("degrees") || rival.contains("cells")) {  // others keep the bodies' own meshes
        replace(rival, "degrees", "rival.degrees");
        replace(rival, "cells", "rival.cells");
      }
      replace(rival, accuracy(rival), "rival." + accuracy(rival));
    }
  }

  const Assignments& asked_;
  const Vocabulary& vocabulary_;
  StudyTable all_;
  Findings& findings_;
  std::set<std::string> taken_;  // keys that changed something
};

std::vector<BodyDraft> drafts(const Scene& scene) {
  std::vector<BodyDraft> all;
  for (const Body& body : scene.bodies) {
    BodyDraft draft{.name = body.name,
                    .shape = body.shape,
                    .of_kind = body.shape,
                    .material = body.material,
                    .resolution = body.resolution,
                    .damping = {},
                    .supports = {},
                    .dashpots = {.dashpots = body.dashpots, .at = {}}};
    draft.damping.ratios = body.damping_ratios;
    draft.supports.supports = body.supports;
    draft.theory = body.theory;
    draft.kinematics = body.kinematics;
    draft.touches = std::ranges::any_of(
        scene.contacts, [&](const auto& pair) { return pair.body == body.name || pair.obstacle == body.name; });
    all.push_back(std::move(draft));
  }
  return all;
}

}  // namespace

const std::vector<std::string>& set_keys() {
  static const std::vector<std::string> keys{"modal.methods",
                                             "modal.modes",
                                             "modal.integrators",
                                             "modal.time_steps",
                                             "modal.relative_tolerances",
                                             "modal.contact_steps",
                                             "rival.integrators",
                                             "rival.degrees",
                                             "rival.cells",
                                             "rival.time_steps",
                                             "rival.relative_tolerances",
                                             "study.analyses"};
  return keys;
}

Overrides::Overrides(const std::vector<std::string>& assignments, const Vocabulary& vocabulary)
    : assignments_(read_assignments(assignments, set_keys(), "rival.cells")), vocabulary_(vocabulary) {}

Scene Overrides::applied(Scene scene) const {
  if (empty()) return scene;
  Findings findings(scene.name + " --set", assignments_.text);
  Change change(assignments_, vocabulary_, scene.study, findings);
  const TomlTable table = document(change.run());
  std::optional<Section> no_profile;
  scene.study = read_study(Section(table, {}, "study", false, findings), no_profile, drafts(scene), vocabulary_,
                           {scene.duration, scene.duration});
  if (!findings.empty()) throw CaseErrors(findings.found());
  if (!change.has_closed_form()) scene.study.methods.clear();
  return scene;
}

}  // namespace mb
