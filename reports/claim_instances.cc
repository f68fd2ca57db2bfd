#include "reports/claim_instances.h"

#include <algorithm>
#include <cmath>

#include "reports/findings.h"
#include "reports/number.h"
#include "reports/words.h"

namespace mb {
namespace {

Ruling ruling_of(const std::string& verdict) {
  if (verdict == "holds") return Ruling::holds;
  if (verdict.starts_with("holds")) return Ruling::holds_within_limits;
  if (verdict.starts_with("does not hold")) return Ruling::does_not_hold;
  return verdict.starts_with("not decided") ? Ruling::not_decided : Ruling::not_measured;
}

std::string range(std::vector<double> values) {
  std::erase_if(values, [](double v) { return std::isnan(v); });
  if (values.empty()) return "n/a";
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const auto text = [](double v) { return v > 0 && std::isinf(v) ? "unbounded" : format_number(v); };
  const std::string a = text(*low), b = text(*high);
  return a == b ? a : a + " to " + b;
}

std::string place(const Instance& one) { return one.label.empty() ? one.where : one.where + " (" + one.label + ")"; }

std::string label_of(const Finding& finding, std::size_t row, const std::string& column) {
  const std::string text = text_at(finding, row, column);
  if (!text.empty()) return text;
  const auto j = column_of(finding, column);
  const double value = number_at(finding, row, column);
  if (!j || std::isnan(value)) return "";
  return format_setting(value) + " " + finding.columns[*j].unit;
}

}  // namespace

std::string limits(const std::vector<Instance>& instances) {
  std::string text;
  for (const auto& [ruling, words] :
       {std::pair(Ruling::holds, "holds in "), std::pair(Ruling::holds_within_limits, "within limits in "),
        std::pair(Ruling::does_not_hold, "does not hold in "), std::pair(Ruling::not_decided, "not decided in ")}) {
    std::vector<std::string> places;
    for (const Instance& one : instances) {
      if (one.decides && one.ruling == ruling) places.push_back(place(one));
    }
    if (!places.empty()) text += (text.empty() ? "" : "; ") + std::string(words) + listed(places);
  }
  return text;
}

std::string by_label(const std::vector<Instance>& instances) {
  std::vector<std::pair<std::string, std::vector<double>>> groups;
  for (const Instance& one : instances) {
    auto group = std::find_if(groups.begin(), groups.end(), [&](const auto& g) { return g.first == one.label; });
    if (group == groups.end()) group = groups.insert(groups.end(), {one.label, {}});
    group->second.push_back(one.value);
  }
  std::string text;
  for (const auto& [label, values] : groups) {
    text += (text.empty() ? "" : "; ") + (label.empty() ? "" : label + ": ") + range(values);
  }
  return text;
}

void conclude(Claim& claim, const std::vector<Instance>& instances) {
  std::vector<Ruling> rulings;
  for (const Instance& one : instances) {
    if (one.decides) rulings.push_back(one.ruling);
  }
  claim.ruling = together(rulings);
  if (claim.ruling == Ruling::not_measured) return;
  claim.measured += by_label(instances);
  claim.limits = limits(instances);
}

std::vector<Instance> rows_of(const Evaluation& evaluation, const std::string& claim, const std::string& table,
                              const std::string& label, const std::string& value) {
  std::vector<Instance> all;
  for (const Finding& finding : evaluation.input.findings) {
    if (finding.name != table) continue;
    for (std::size_t i = 0; i < finding.rows.size(); ++i) {
      const std::string named = text_at(finding, i, "claim");
      if (!named.empty() && named != claim) continue;
      all.push_back({finding.case_name, label_of(finding, i, label), number_at(finding, i, value),
                     ruling_of(text_at(finding, i, "verdict"))});
    }
  }
  return all;
}

}  // namespace mb
