#include "harness/analysis/told.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "harness/analysis/footings.h"
#include "harness/analysis/modal_body.h"

namespace mb {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();

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
  PerDistance per_distance;
};
OnAnotherMesh on_another_mesh(const AnalysisContext& context) {
  const Scene& scene = *context.scene;
  const Resolution mesh = another_mesh(scene).meshes;
  TruthSet truth = context.truth;
  truth.same_mesh = truth.loose = mesh == scene.truth.finer ? truth.finer : truth.coarser;
  return {std::make_shared<const Scene>(on_meshes(scene, mesh)), std::move(truth),
          own_bars_per_distance(scene, context.truth)};
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

bool is_of_least_order(const FindingColumn& column) {
  return column.name == "K norm" || column.name == "largest rotation" ||
         column.name.find("strain") != std::string::npos;
}

using RowPairs = std::vector<std::vector<std::size_t>>;  // of every row those of the other table

RowPairs in_same_places(const Finding& finding, const Finding& other) {
  RowPairs all(finding.rows.size());
  const bool counts_too = other.rows.size() != finding.rows.size();
  for (std::size_t i = 0; i < std::min(all.size(), other.rows.size()); ++i)
    if (tell_of_the_same(finding.columns, finding.rows[i], other.rows[i], counts_too)) all[i].push_back(i);
  return all;
}

std::optional<std::size_t> column_of_modes(const Finding& finding) {
  for (std::size_t j = 0; j < finding.columns.size(); ++j)
    if (finding.columns[j].name == "mode" || finding.columns[j].name == "undamped mode") return j;
  return std::nullopt;
}

// Numbers in column j from 1 on: of the first elastic mode, or of the first.
Index first_of(const Finding& finding, std::size_t j, const ElasticPairs& elastic) {
  return finding.columns[j].name == "mode" ? 1 : 1 + elastic.n_rigid;
}

// Rows of that mode, in their order, of which what stands before it is as in `row`; a running count is not.
std::vector<std::size_t> rows_of(const Finding& finding, std::size_t j, double mode,
                                 const std::vector<FindingCell>& row) {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < finding.rows.size(); ++i) {
    const auto& one = finding.rows[i];
    bool is_same = number(one[j]) == mode;
    for (std::size_t k = 0; k < j; ++k) {
      const bool is_count = one[k].index() == 1 && finding.columns[k].unit.empty();
      is_same = is_same && (is_count || one[k] == row[k]);
    }
    if (is_same) all.push_back(i);
  }
  return all;
}

// The row in the same place where the other table has none of the mode's pairs.
RowPairs of_same_modes(const Finding& finding, const Finding& other, std::size_t j, const ElasticPairs& elastic) {
  RowPairs all = in_same_places(finding, other);
  const Index first = first_of(finding, j, elastic), n = std::ssize(elastic.pairs);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto& row = finding.rows[i];
    const double mode = number(row[j]);
    const auto own = rows_of(finding, j, mode, row);
    const auto place = static_cast<std::size_t>(std::ranges::find(own, i) - own.begin());
    if (!(mode >= static_cast<double>(first) && mode < static_cast<double>(first + n))) continue;
    std::vector<std::size_t> found;
    for (const Index pair : elastic.pairs[static_cast<std::size_t>(mode) - static_cast<std::size_t>(first)]) {
      const auto theirs = rows_of(other, j, static_cast<double>(pair + first), row);
      if (place < theirs.size()) found.push_back(theirs[place]);
    }
    if (!found.empty()) all[i] = found;
  }
  return all;
}

// Of the modes that the tables tell of; none where they tell of none.
std::optional<ElasticPairs> pairs_of(const std::vector<Finding>& findings, const AnalysisContext& context) {
  double last = 0;
  for (const Finding& finding : findings)
    if (const auto j = column_of_modes(finding))
      for (const auto& row : finding.rows) last = std::fmax(last, number(row[*j]));
  if (last == 0) return std::nullopt;
  const int n = static_cast<int>(last);
  const SeenModes other = seen_modes(modal_body(context, n + more_of_other, another_mesh(*context.scene).meshes));
  const ModalBody body = modal_body(context, n);
  return ElasticPairs{body.modes.n_rigid, mode_pairs(seen_modes(body).shapes, other.shapes)};
}

// What was known to 0 by one neighbour, and has nothing beside it in another that moves the column, is known to
// nothing.
void forget_zeros(Finding& finding, const RowPairs& beside) {
  for (std::size_t j = 0; j < finding.columns.size(); ++j) {
    if (std::ranges::none_of(finding.bars, [&](const auto& bars) { return bars[j] > 0; })) continue;
    for (std::size_t i = 0; i < finding.rows.size(); ++i)
      if (beside[i].empty() && finding.bars[i][j] == 0) finding.bars[i][j] = infinity;
  }
}

}  // namespace

void add_bars(std::vector<Finding>& findings, const std::vector<Finding>& neighbours, PerDistance per_distance,
              const ElasticPairs* elastic) {
  for (Finding& finding : findings) {
    const auto other = std::ranges::find(neighbours, finding.name, &Finding::name);
    if (other == neighbours.end()) continue;
    if (finding.bars.empty()) finding.bars.assign(finding.rows.size(), std::vector(finding.columns.size(), nan));
    const auto mode = elastic ? column_of_modes(finding) : std::nullopt;
    const RowPairs beside = mode ? of_same_modes(finding, *other, *mode, *elastic) : in_same_places(finding, *other);
    for (std::size_t i = 0; i < finding.rows.size(); ++i)
      for (const std::size_t k : beside[i])
        for (std::size_t j = 0; j < finding.columns.size(); ++j)
          finding.bars[i][j] = std::fmax(
              finding.bars[i][j], (is_of_least_order(finding.columns[j]) ? per_distance.local : per_distance.mean) *
                                      distance(finding.columns[j], finding.rows[i][j], other->rows[k][j]));
    forget_zeros(finding, beside);
  }
}

void bar_fits(Finding& finding) {
  for (std::size_t j = 1; j < finding.columns.size(); ++j) {
    if (!finding.columns[j].name.starts_with("standard error")) continue;  // "of time", of several
    if (finding.bars.empty()) finding.bars.assign(finding.rows.size(), std::vector(finding.columns.size(), nan));
    for (std::size_t i = 0; i < finding.rows.size(); ++i)
      finding.bars[i][j - 1] = std::fmax(finding.bars[i][j - 1], number(finding.rows[i][j]));
  }
}

std::vector<Finding> told(const Analysis& analysis, const AnalysisContext& context) {
  std::vector<Finding> findings = analysis.run(context);
  if (analysis.of_truth && context.scene->contacts.empty()) {
    const TruthSet neighbour = neighbour_of(context.truth);
    add_bars(findings, analysis.run({context.scene, context.catalogue, neighbour, context.model}),
             context.truth.per_distance);
  }
  if (analysis.of_mesh) {
    const OnAnotherMesh other = on_another_mesh(context);
    const auto neighbours = analysis.run({other.scene, context.catalogue, other.truth, context.model});
    const auto elastic = pairs_of(findings, context);
    add_bars(findings, neighbours, other.per_distance, elastic ? &*elastic : nullptr);
  }
  for (Finding& finding : findings) {
    bar_fits(finding);
    finding.footing = footing_of(finding);
  }
  return findings;
}

}  // namespace mb
