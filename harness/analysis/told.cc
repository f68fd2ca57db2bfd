#include "harness/analysis/told.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "harness/analysis/footings.h"
#include "harness/analysis/modal_body.h"

namespace mb {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TruthSet neighbour_of(const TruthSet& truth) {
  TruthSet other = truth;
  other.finer = truth.coarser;
  other.same_mesh = truth.loose;
  return other;
}

// Another mesh in the place of the body's, in scene and truth.
struct OnAnotherMesh {
  std::shared_ptr<const Scene> scene;
  TruthSet truth;
  double bar_per_distance;
};
OnAnotherMesh on_another_mesh(const AnalysisContext& context) {
  const Scene& scene = *context.scene;
  const auto [mesh, bar_per_distance] = another_mesh(scene);
  TruthSet truth = context.truth;
  truth.same_mesh = truth.loose = mesh == scene.truth.finer ? truth.finer : truth.coarser;
  return {std::make_shared<const Scene>(on_meshes(scene, mesh)), std::move(truth), bar_per_distance};
}

double number(const FindingCell& cell) { return cell.index() == 1 ? std::get<double>(cell) : nan; }

// Of rows that tell of the same: the cell that names a row, text or count, and texts before the first number that is
// measured. A verdict behind it follows from numbers, and turns where they are not known well enough.
bool tell_of_the_same(const std::vector<FindingColumn>& columns, const std::vector<FindingCell>& a,
                      const std::vector<FindingCell>& b, bool counts_too) {
  if (!columns.empty() && columns[0].unit.empty() && a[0] != b[0]) return false;
  for (std::size_t j = 0; j < columns.size() && columns[j].unit.empty(); ++j) {
    const bool is_text = a[j].index() == 0, is_nothing = std::isnan(number(a[j])) && std::isnan(number(b[j]));
    if (a[j].index() != b[j].index() || ((is_text || (counts_too && !is_nothing)) && a[j] != b[j])) return false;
  }
  return true;
}

// Counts and settings are the same in both and have no bar. A phase turns round once in 360 degrees.
double distance(const FindingColumn& column, const FindingCell& a, const FindingCell& b) {
  const double difference = number(a) - number(b);
  if (column.unit.empty() || !std::isfinite(difference)) return nan;
  return std::abs(column.unit == "deg" ? std::remainder(difference, 360) : difference);
}

}  // namespace

void add_bars(std::vector<Finding>& findings, const std::vector<Finding>& neighbours, double per_distance) {
  for (Finding& finding : findings) {
    const auto other = std::ranges::find(neighbours, finding.name, &Finding::name);
    if (other == neighbours.end()) continue;
    const std::size_t n = std::min(finding.rows.size(), other->rows.size());
    const bool counts_too = other->rows.size() != finding.rows.size();
    if (finding.bars.empty()) finding.bars.assign(finding.rows.size(), std::vector(finding.columns.size(), nan));
    for (std::size_t i = 0; i < n; ++i) {
      const auto &row = finding.rows[i], &beside = other->rows[i];
      if (!tell_of_the_same(finding.columns, row, beside, counts_too)) continue;
      for (std::size_t j = 0; j < row.size(); ++j)
        finding.bars[i][j] =
            std::fmax(finding.bars[i][j], per_distance * distance(finding.columns[j], row[j], beside[j]));
    }
  }
}

void bar_fits(Finding& finding) {
  for (std::size_t j = 1; j < finding.columns.size(); ++j) {
    if (finding.columns[j].name != "standard error") continue;
    if (finding.bars.empty()) finding.bars.assign(finding.rows.size(), std::vector(finding.columns.size(), nan));
    for (std::size_t i = 0; i < finding.rows.size(); ++i)
      finding.bars[i][j - 1] = std::fmax(finding.bars[i][j - 1], number(finding.rows[i][j]));
  }
}

std::vector<Finding> told(const Analysis& analysis, const AnalysisContext& context) {
  std::vector<Finding> findings = analysis.run(context);
  if (analysis.of_truth && context.scene->contacts.empty()) {
    const TruthSet neighbour = neighbour_of(context.truth);
    add_bars(findings, analysis.run({context.scene, context.catalogue, neighbour, context.model}));
  }
  if (analysis.of_mesh) {
    const OnAnotherMesh other = on_another_mesh(context);
    add_bars(findings, analysis.run({other.scene, context.catalogue, other.truth, context.model}),
             other.bar_per_distance);
  }
  for (Finding& finding : findings) {
    bar_fits(finding);
    finding.footing = footing_of(finding);
  }
  return findings;
}

}  // namespace mb
