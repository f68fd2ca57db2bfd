#include "cases/scene/read_truth.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "cases/scene/closed_form.h"
#include "cases/scene/number_text.h"
#include "cases/scene/read_mesh.h"
#include "cases/scene/refinement.h"
#include "cases/scene/resolution.h"

namespace mb {

namespace {

// Error bars take a hundredth of it, and the adaptive integrators' least is 1e-12: below that rounding rules.
const Range tolerance_range{1e-10, 1e-2};

struct Mesh {
  std::optional<Resolution> resolution;
  Position where;
};

// Of the whole scene: `others` has those of the bodies after the first by their names, in place of their own.
std::optional<Resolution> read_meshes(Section section, const std::vector<BodyDraft>& bodies) {
  auto others = bodies.size() > 1 ? section.section("others", true) : std::nullopt;
  auto all = read_mesh(section, bodies.empty() ? BodyDraft{} : bodies.front());
  bool all_named = true;
  for (size_t i = 1; i < bodies.size(); ++i) {
    const BodyDraft& body = bodies[i];
    all_named = all_named && body.name;
    const auto stated = others && body.name ? others->section(*body.name, true) : std::nullopt;
    const auto mesh = stated ? read_mesh(*stated, body) : body.resolution;
    if (!mesh) all = std::nullopt;
    if (all) all->others.push_back(*mesh);
  }
  if (others) others->finish(all_named);
  return all;
}

// The mesh in `key` of [truth], or that of the profile in its place.
Mesh read_mesh(Section& truth, std::optional<Section>& profile, const std::string& key,
               const std::vector<BodyDraft>& bodies) {
  const auto base = truth.section(key);
  Mesh mesh{base ? read_meshes(*base, bodies) : std::nullopt, truth.where(key)};
  const auto other = profile ? profile->section(key, true) : std::nullopt;
  return other ? Mesh{read_meshes(*other, bodies), profile->where(key)} : mesh;
}

// The bodies' own, as far as they could be read.
std::optional<Resolution> own_meshes(const std::vector<BodyDraft>& bodies) {
  if (bodies.empty() || !bodies.front().resolution) return {};
  Resolution all = *bodies.front().resolution;
  for (size_t i = 1; i < bodies.size(); ++i) {
    if (!bodies[i].resolution) return {};
    all.others.push_back(*bodies[i].resolution);
  }
  return all;
}

// Degrees of freedom of all bodies; nothing where one could not be read or is graded, of which an upper bound is known.
std::optional<double> n_dofs_of_all(const std::vector<BodyDraft>& bodies, const Resolution& all) {
  double n = 0;
  for (size_t i = 0; i < bodies.size(); ++i) {
    const Resolution& mesh = i == 0 ? all : all.others.at(i - 1);
    if (!bodies[i].shape || !bodies[i].theory || mesh.graded > 0) return {};
    n += n_dofs(*bodies[i].shape, mesh, *bodies[i].theory);
  }
  return n;
}

// Degree, cells and grading of each body at most those of the other, which is no less even.
bool is_nowhere_finer(const Resolution& mesh, const Resolution& other) {
  return mesh.degree <= other.degree && std::ranges::equal(mesh.cells, other.cells, std::less_equal{}) &&
         mesh.graded <= other.graded && mesh.bias == other.bias && mesh.distorted == other.distorted &&
         std::ranges::equal(mesh.others, other.others, is_nowhere_finer);
}

// A truth on a mesh that is no better than what it judges, or what its bar comes from, is none. Returns whether it is.
bool check_is_finer(const Mesh& finer, const Resolution& other, const std::string& its_name, const Position& where,
                    const std::vector<BodyDraft>& bodies, Findings& findings) {
  const auto n = n_dofs_of_all(bodies, *finer.resolution), n_other = n_dofs_of_all(bodies, other);
  const bool nowhere = is_nowhere_finer(*finer.resolution, other);
  if (!nowhere && (!n || !n_other || *n >= *n_other)) return true;
  findings.error(where, nowhere ? "'finer' is nowhere finer than " + its_name
                                : fmt::format("'finer' has {:.0f} degrees of freedom, and {} {:.0f}: it must have more",
                                              *n, its_name, *n_other));
  return false;
}

// Of what is off where `finer` is no better, or another kind of mesh, their distance tells nothing.
void check_sees_all(const Resolution& finer, const Resolution& coarser, const Position& where,
                    const std::vector<BodyDraft>& bodies, Findings& findings) {
  for (size_t i = 0; i < bodies.size(); ++i) {
    const Resolution& fine = i == 0 ? finer : finer.others.at(i - 1);
    const Resolution& coarse = i == 0 ? coarser : coarser.others.at(i - 1);
    const bool alike = fine.bias == coarse.bias && fine.distorted == coarse.distorted;
    if (alike && fall_of_body(fine, coarse, 1) > 1) continue;
    findings.error(
        where,
        fmt::format("'coarser' tells nothing of what 'finer' is off in body '{}': {}", bodies[i].name.value_or(""),
                    alike ? "errors need not fall between them in every direction in which they differ"
                          : "'bias' and 'distorted' of both must be the same"));
  }
}

// By how much errors fall at best from one mesh to another of the same degree p: r^p, r the largest ratio of cells
// along an axis. Nothing where degree, grading or a theory's half waves tell otherwise.
std::optional<double> best_fall(const Resolution& fine, const Resolution& coarse, const BodyDraft& body) {
  const bool alike = fine.degree == coarse.degree && fine.graded == coarse.graded && body.theory == Theory::solid;
  if (!alike || fine.cells.size() != coarse.cells.size()) return {};
  double r = 1;
  for (size_t k = 0; k < fine.cells.size(); ++k)
    r = std::max(r, fine.cells[k] / std::max(0.5, 1. * coarse.cells[k]));  // 0 splits: one block across
  return std::pow(r, fine.degree);
}

// Their distance is not less than Richardson's estimate of the error, distance/(r^p - 1), where r^p is 2 at least.
void check_is_apart(const Resolution& finer, const Resolution& coarser, const Position& where,
                    const std::vector<BodyDraft>& bodies, Findings& findings) {
  double largest = 1;
  for (size_t i = 0; i < bodies.size(); ++i) {
    const auto fall = i == 0 ? best_fall(finer, coarser, bodies[i])
                             : best_fall(finer.others.at(i - 1), coarser.others.at(i - 1), bodies[i]);
    if (!fall) return;
    largest = std::max(largest, *fall);
  }
  if (bodies.empty() || largest >= 2) return;
  findings.error(
      where, fmt::format("'coarser' is too near to 'finer': errors fall by {} at best between them, and must by two "
                         "for their distance to be an error bar",
                         number_beside(largest, 2)));
}

void check_ratios_of_all(const std::vector<BodyDraft>& bodies, const Mesh& mesh, Findings& findings) {
  if (!mesh.resolution) return;
  for (size_t i = 0; i < bodies.size(); ++i)
    check_ratios(bodies[i], i == 0 ? *mesh.resolution : mesh.resolution->others.at(i - 1), mesh.where, findings);
}

// Errors stand at what the profile states, where it does.
void check_meshes(const Mesh& finer, const Mesh& coarser, std::optional<Section>& profile,
                  const std::vector<BodyDraft>& bodies, Findings& findings) {
  if (!finer.resolution) return;
  const std::optional<Resolution> own = own_meshes(bodies);
  const bool own_finer = profile && profile->has("finer");
  if (coarser.resolution) {
    const bool own_coarser = profile && profile->has("coarser");
    const Position& where = own_finer && !own_coarser ? finer.where : coarser.where;
    if (*finer.resolution == *coarser.resolution)
      findings.error(where, "'coarser' equals 'finer': their distance is the error bar, and would be 0");
    else if (check_is_finer(finer, *coarser.resolution, "'coarser'", where, bodies, findings)) {
      check_is_apart(*finer.resolution, *coarser.resolution, where, bodies, findings);
      check_sees_all(*finer.resolution, *coarser.resolution, where, bodies, findings);
    }
  }
  if (!own) return;
  const bool own_mesh = profile && profile->has("resolution") && !own_finer;
  const Position where = own_mesh ? profile->where("resolution") : finer.where;
  const std::string name = bodies.front().name.value_or("");
  if (*finer.resolution == *own)
    findings.error(where, fmt::format("'finer' is the mesh of body '{}' itself: truth same_mesh has that one", name));
  else
    check_is_finer(finer, *own,
                   bodies.size() > 1 ? "the bodies' own meshes" : fmt::format("the mesh of body '{}'", name), where,
                   bodies, findings);
}

}  // namespace

TruthDraft read_truth(Section section, std::optional<Section>& profile, const std::vector<BodyDraft>& bodies) {
  const auto tolerance = section.number("relative_tolerance", tolerance_range);
  const Mesh finer = read_mesh(section, profile, "finer", bodies);
  const Mesh coarser = read_mesh(section, profile, "coarser", bodies);
  TruthDraft draft{std::nullopt, section.has("exact"), section.where("exact")};
  std::optional<std::string> exact = "";
  if (draft.has_exact) exact = section.choice("exact", {closed_form_names(), "closed form", "closed forms"});
  section.finish();
  check_meshes(finer, coarser, profile, bodies, section.findings());
  for (const Mesh& mesh : {finer, coarser}) check_ratios_of_all(bodies, mesh, section.findings());
  if (tolerance && finer.resolution && coarser.resolution && exact) {
    draft.settings = TruthSettings{*tolerance, *finer.resolution, *coarser.resolution, *exact};
  }
  return draft;
}

ReferenceFrequencies read_reference_frequencies(Section section) {
  ReferenceFrequencies reference;
  reference.hertz = section.numbers("hertz", {0, 1e12, "1/s", true}, {1, 256}).value_or(std::vector<double>{});
  reference.uncertainty = section.number("uncertainty", {0, 1}, 0);
  section.finish();
  const auto& hertz = reference.hertz;
  const auto lower = std::is_sorted_until(hertz.begin(), hertz.end());
  if (lower != hertz.end()) {
    section.error("hertz", fmt::format("'hertz' must ascend: {} follows {}", *lower, *(lower - 1)));
  }
  return reference;
}

}  // namespace mb
