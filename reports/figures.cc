#include "reports/figures.h"

#include <algorithm>
#include <set>
#include <tuple>

#include "reports/number.h"

namespace mb {
namespace {

// A name that came from a store as part of a file name.
std::string file_part(const std::string& text) {
  std::string part;
  for (const char c : text.substr(0, 64)) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    part += plain ? c : '-';
  }
  return part;
}

}  // namespace

std::vector<Quantity> quantities(const Analysis& analysis) {
  static const std::vector<std::string> order = {"displacement-error", "strain-error",  "surface-deviation",
                                                 "pose-translation",   "pose-rotation", "probe-error"};
  const auto place = [](const Quantity& quantity) {
    return std::tuple(std::find(order.begin(), order.end(), quantity.metric) - order.begin(), quantity);
  };
  std::set<Quantity> found;
  for (const Record& record : analysis.input.records) {
    if (is_mark(record) && is_reduced(record.contender)) found.insert({record.metric, record.subject, record.unit});
  }
  std::vector<Quantity> sorted(found.begin(), found.end());
  std::sort(sorted.begin(), sorted.end(), [&](const Quantity& a, const Quantity& b) { return place(a) < place(b); });
  return sorted;
}

std::string title(const Quantity& quantity) {
  static const std::map<std::string, std::string> known = {
      {"displacement-error", "relative displacement error, M norm"},
      {"strain-error", "relative strain error, K norm"},
      {"surface-deviation", "largest surface deviation / body size"},
      {"pose-translation", "pose error, translation"},
      {"pose-rotation", "pose error, rotation"},
      {"probe-error", "relative error of the probe signal"},
      {"probe-magnitude", "Sprague-Geers magnitude error"},
      {"probe-phase", "Sprague-Geers phase error"},
      {"probe-combined", "Sprague-Geers combined error"}};
  const auto entry = known.find(quantity.metric);
  const std::string name = entry == known.end() ? quantity.metric : entry->second;
  return quantity.subject.empty() ? name : name + ", " + quantity.subject;
}

std::vector<std::string> series(const Analysis& analysis) {
  std::vector<std::string> names;
  for (const Run& run : analysis.runs) {
    const std::string name = describe_series(run.contender);
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  std::stable_sort(names.begin(), names.end(), [](const std::string& a, const std::string& b) {
    return std::pair(a.starts_with("full order"), a) < std::pair(b.starts_with("full order"), b);
  });
  return names;
}

TimeAxis time_axis(const Analysis& analysis) {
  const bool known = std::all_of(analysis.runs.begin(), analysis.runs.end(),
                                 [&](const Run& run) { return simulated_seconds(analysis, run).has_value(); });
  return {known, known ? "online time per simulated second [s]" : "online time [s]"};
}

Json run_json(const Analysis& analysis, const Run& run) {
  const Contender& contender = run.contender;
  Json json = {{"series", describe_series(contender)},
               {"run", describe(contender)},
               {"reduced", is_reduced(contender)},
               {"mesh", to_string(contender.resolution)},
               {"unknowns", run.n_unknowns}};
  if (is_reduced(contender)) {
    json["r"] = contender.settings.modes;
    json["r_used"] = std::max(run.modes_used, 0);
  }
  if (contender.settings.time_step > 0) json["time_step"] = contender.settings.time_step;
  if (!run.online || !is_usable(*run.online)) return json;
  const double per = time_axis(analysis).per_simulated_second ? *simulated_seconds(analysis, run) : 1;
  json["time"] = run.online->value / per;
  if (run.online->error_bar) json["spread"] = *run.online->error_bar / per;  // a single run has none
  return json;
}

std::vector<Figure> figures(const Analysis& analysis) {
  std::map<std::tuple<std::string, std::string, std::string, Quantity>, Json> data;
  for (const Run& run : analysis.runs) {
    for (const auto& [measure, record] : run.measures) {
      if (!is_usable(record)) continue;
      Json datum = run_json(analysis, run);
      datum["value"] = record.value;
      datum["bar"] = record.error_bar.value_or(0);
      const Quantity quantity{measure.metric, measure.subject, record.unit};
      data[{run.case_name, run.profile, measure.truth, quantity}].push_back(std::move(datum));
    }
  }
  std::vector<Figure> all;
  for (auto& [key, values] : data) {
    const auto& [case_name, profile, truth, quantity] = key;
    std::string stem = file_part(case_name);
    for (const std::string& part : {profile, truth, quantity.metric, quantity.subject}) {
      if (part.empty()) continue;
      stem += '-';
      stem += file_part(part);
    }
    Json modes = error_against_modes(quantity, series(analysis), values);
    Json work = work_against_precision(quantity, series(analysis), time_axis(analysis), values);
    for (Json* specification : {&modes, &work}) {
      (*specification)["title"] = case_name + ", profile " + profile + ", truth " + truth;
    }
    all.push_back({"error-against-modes-" + stem, std::move(modes)});
    all.push_back({"work-against-precision-" + stem, std::move(work)});
  }
  return all;
}

}  // namespace mb
