#include "harness/analysis/modal_body.h"

#include <algorithm>
#include <limits>
#include <set>
#include <stdexcept>

#include "harness/study/estimate.h"
#include "harness/study/memory.h"
#include "harness/study/mesh_bar.h"
#include "harness/study/truth.h"
#include "modal/bases/eigenmodes.h"

namespace mb {

namespace {
constexpr Index small_body = 350;  // [-] unknowns of which a dense solver finds all modes in a second
}  // namespace

Modes leading(const Modes& modes, int n_elastic) {
  Index n = std::min(modes.size(), modes.n_rigid + n_elastic);
  const VectorXd lambda = modes.omega.array().square();
  while (n > modes.n_rigid && n < modes.size() && are_one_multiplet(lambda(n - 1), lambda(n), modes.lambda_max)) ++n;
  return {modes.n_rigid, modes.omega.head(n), modes.Phi.leftCols(n), modes.residual.head(n), modes.lambda_max};
}

VectorXd damping_ratios(const System& system, const Modes& modes) {
  const Index n_elastic = modes.size() - modes.n_rigid;
  VectorXd zeta(n_elastic);
  for (Index i = 0; i < n_elastic; ++i) {
    const VectorXd phi = modes.Phi.col(modes.n_rigid + i);
    zeta(i) = phi.dot(apply_damping(system, phi)) / (2 * modes.omega(modes.n_rigid + i));
  }
  return zeta;
}

double rounding_of_damping(const MatrixXd& C) {
  const double terms = std::max(8., static_cast<double>(C.rows()));
  return terms * std::numeric_limits<double>::epsilon() * C.lpNorm<Eigen::Infinity>();
}

VectorXd without_rounding(const VectorXd& omega, const VectorXd& zeta) {
  const VectorXd c = 2 * zeta.cwiseProduct(omega);
  return (c.array() > rounding_of_damping(c)).select(zeta, 0);
}

double rounding_of_frequency(const Modes& modes, double omega) {
  return std::numeric_limits<double>::epsilon() * modes.lambda_max / (2 * omega * omega);
}

Model model_of_own_mesh(const std::shared_ptr<const Scene>& scene, const Resolution& mesh) {
  require_memory(memory(*scene, mesh), available_memory());
  return make_model(scene, mesh);
}

ModalBody modal_body(const AnalysisContext& context, int n_elastic) {
  return modal_body(context, n_elastic, own_meshes(*context.scene));
}

ModalBody modal_body(const AnalysisContext& context, int n_elastic, const Resolution& meshes) {
  const Body& body = context.scene->bodies.front();
  const Model& scene_model = context.model(meshes);
  const BodyModel& model = scene_model.bodies.front();
  const System& system = model.full->system();
  ShiftedFactor shifted = shifted_factor(system, physical_shift(body));
  Modes modes = lowest_modes(system, n_elastic, shifted);
  return {scene_model, model, system, std::move(shifted), std::move(modes)};
}

SeenModes seen_modes(const FullModel& full, const Quadrature& volume, const Modes& modes) {
  const VectorXd omega = modes.omega.tail(modes.size() - modes.n_rigid);
  return {omega, seen_at(full, volume, modes.Phi.rightCols(omega.size()))};
}

SeenModes seen_modes(const ModalBody& body) {
  return seen_modes(*body.model.full, body.model.points.volume, body.modes);
}

VectorXd paired_frequencies(const SeenModes& own, const SeenModes& other) {
  const ModePairs pairs = mode_pairs(own.shapes, other.shapes);
  VectorXd omega = VectorXd::Constant(own.omega.size(), std::numeric_limits<double>::quiet_NaN());
  for (Index i = 0; i < omega.size(); ++i) {
    const Index pair = farthest(own.omega[i], other.omega, pairs[static_cast<size_t>(i)]), j = pair >= 0 ? pair : i;
    if (j < other.omega.size()) omega[i] = other.omega[j];
  }
  return omega;
}

namespace {

// [-] Of the own mesh by its distance to `finer`.
double bar_of_own(const Scene& scene, const Order& order) {
  const double fall = fall_of_errors(scene.truth.finer, own_meshes(scene), order);
  if (!(fall > 1)) return std::numeric_limits<double>::infinity();
  return std::max(2.0, safety_of_meshes * fall / (fall - 1));
}

}  // namespace

AnotherMesh another_mesh(const Scene& scene) {
  if (scene.truth.finer == own_meshes(scene))
    return {scene.truth.coarser, bar_per_distance(scene.truth.finer, scene.truth.coarser, 2 * order_of_modes(scene))};
  return {scene.truth.finer, bar_of_own(scene, 2 * order_of_modes(scene))};
}

PerDistance own_bars_per_distance(const Scene& scene, const TruthSet& truth) {
  if (scene.truth.finer == own_meshes(scene)) return truth.per_distance;
  const auto [local, mean] = orders_of_motion(scene);
  return {bar_of_own(scene, mean), bar_of_own(scene, local)};
}

std::vector<int> mode_counts(const AnalysisContext& context) {
  const Scene& scene = *context.scene;
  std::set<int> all(scene.study.modes.begin(), scene.study.modes.end());
  for (const Stepping& stepping : scene.study.steppings) all.insert(stepping.modes.begin(), stepping.modes.end());
  const Index n = context.model(own_meshes(scene)).bodies.front().full->system().K.rows();
  std::vector<int> counts;
  for (const int r : all)
    if (r > 0 && (3 * r <= n || n <= small_body)) counts.push_back(r);
  if (counts.empty()) counts.push_back(1);
  return counts;
}

std::vector<int> few(const std::vector<int>& counts, int n_wanted) {
  const auto n = static_cast<int>(counts.size());
  if (n <= n_wanted) return counts;
  std::vector<int> picked;
  for (int i = 0; i < n_wanted; ++i) picked.push_back(counts[static_cast<size_t>(i * (n - 1) / (n_wanted - 1))]);
  return picked;
}

bool is_free(const AnalysisContext& context) { return !is_held(context.scene->bodies.front()); }

Finding table(std::string analysis, std::string name, std::string title, std::string note,
              std::vector<FindingColumn> columns) {
  Finding finding;
  finding.analysis = std::move(analysis);
  finding.name = std::move(name);
  finding.title = std::move(title);
  finding.note = std::move(note);
  finding.columns = std::move(columns);
  return finding;
}

void bar_last_row(Finding& finding, const std::vector<std::pair<const char*, double>>& bars) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  finding.bars.resize(finding.rows.size(), std::vector(finding.columns.size(), none));
  for (const auto& [name, bar] : bars) {
    const auto column = std::ranges::find(finding.columns, name, &FindingColumn::name);
    if (column == finding.columns.end()) throw std::logic_error(std::string("no column '") + name + "'");
    finding.bars.back()[static_cast<size_t>(column - finding.columns.begin())] = bar;
  }
}

FindingCell not_applicable() { return std::numeric_limits<double>::quiet_NaN(); }

}  // namespace mb
