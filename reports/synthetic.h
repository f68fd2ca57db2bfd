// Records of a made-up study, for tests and for looking at the page. No number here was measured.
//
//   error(r) = a (1 + r)^-p + b,   error(h, dt) = a h^2 + b dt^2,   time ~ unknowns x steps
#pragma once

#include <cmath>
#include <limits>

#include "reports/content.h"

namespace mb::synthetic {

inline Record record(const std::string& metric, double value, double bar, const Contender& contender) {
  Record result{};
  result.run = std::string(32, '0');
  result.case_name = std::string("cylinder-compression");
  result.profile = std::string("quick");
  result.contender = contender;
  result.metric = metric;
  result.truth = std::string("finer");
  result.value = value;
  result.unit = std::string("-");
  result.error_bar = bar;
  result.status = std::string("ok");
  return result;
}

inline Record seconds(const std::string& metric, double value, const Contender& contender) {
  Record result = record(metric, value, 0.03 * value, contender);
  result.truth.clear();
  result.unit = std::string("s");
  return result;
}

inline Contender reduced(const std::string& method, int modes) {
  Contender contender{method, "exact", {4, {1, 4}}, {}};
  contender.settings.modes = modes;
  return contender;
}

inline Contender full(int degree, std::vector<int> cells, double time_step) {
  Contender contender{"full-order", "newmark", {degree, std::move(cells)}, {}};
  contender.settings.time_step = time_step;
  return contender;
}

// All metrics of one contender; scale: error of the displacement in the M norm.
inline void grade(std::vector<Record>& records, const Contender& contender, double scale, double online,
                  double offline) {
  const long n_unknowns =
      contender.method == "full-order" ? 1000 * contender.resolution.degree : contender.settings.modes;
  const std::size_t first = records.size();
  for (const double truth_bar : {4e-4, 0.0}) {  // finer, then same_mesh
    const double e = std::hypot(scale, truth_bar > 0 ? 3e-4 : 0);
    const double bar = truth_bar > 0 ? truth_bar : 1e-6;
    records.push_back(record("displacement-error", e, bar, contender));
    records.push_back(record("strain-error", 3.3 * e, 4 * bar, contender));
    records.push_back(record("surface-deviation", 0.04 * e, 0.04 * bar, contender));
    records.push_back(record("probe-error", 0.8 * e, bar, contender));
    records.push_back(record("probe-magnitude", -0.3 * e, bar, contender));
    records.push_back(record("probe-phase", 0.2 * e, bar, contender));
    records.push_back(record("probe-combined", 0.36 * e, bar, contender));
    for (std::size_t i = records.size() - 7; i < records.size(); ++i) {
      if (records[i].metric.starts_with("probe")) records[i].subject = "end-centre";
      if (truth_bar == 0) records[i].truth = "same_mesh";
    }
  }
  records.push_back(seconds("online-time", online, contender));
  records.push_back(seconds("offline-time", offline, contender));
  for (std::size_t i = first; i < records.size(); ++i) {
    records[i].n_unknowns = n_unknowns;
    if (contender.method != "full-order") records[i].modes_used = contender.settings.modes;
  }
}

inline std::vector<Record> records() {
  std::vector<Record> all;
  for (const int r : {0, 1, 2, 4, 8, 16, 32, 64, 128, 256}) {
    const double online = 2e-4 + 1.1e-5 * r;
    grade(all, reduced("eigenmodes", r), 0.6 * std::pow(1 + r, -0.8), online, 0.35 + 0.01 * r);
    grade(all, reduced("static-correction", r), 0.25 * std::pow(1 + r, -1.5), 1.2 * online, 0.42 + 0.01 * r);
  }
  for (const int degree : {1, 2, 3, 4}) {
    for (const double time_step : {0.02, 0.01, 0.005, 0.0025, 0.00125}) {
      for (const int layers : {2, 4}) {
        const double h = 0.9 / std::pow(layers, degree) / degree, steps = 0.29 / time_step;
        const double e = std::hypot(0.5 * h * h, 4e3 * time_step * time_step * 0.2);
        grade(all, full(degree, {1, layers}, time_step), e, 1.5e-5 * steps * degree * degree * degree * layers,
              0.02 * degree * degree * layers);
      }
    }
  }
  for (Record& record : all) {  // one contender that blew up
    const Settings& settings = record.contender.settings;
    if (record.contender.resolution == Resolution{1, {1, 4}} && settings.time_step == 0.02 && record.unit == "-") {
      record.status = "not_finite";
      record.value = std::numeric_limits<double>::quiet_NaN();
    }
  }
  return all;
}

inline Scene scene() {
  Scene scene{};
  scene.name = "cylinder-compression";
  scene.title = "Free gelatine cylinder under equal and opposite axial pulses";
  scene.purpose = "What truncation costs where the load is smooth and the body free.";
  scene.source = "synthetic stand-in for the case of the same name";
  scene.duration = 0.290643;
  scene.frame_rate = 60;
  scene.samples_per_second = 600;
  scene.profile = "quick";
  scene.checks = {
      {"static-correction", "displacement-error", "finer", 32, 0.02, {}, "32 modes resolve the pulse"},
      {"eigenmodes", "strain-error", "finer", 64, 0.15, {}, "plain truncation misses the loaded faces"},
      {"static-correction", "displacement-error", "finer", 128, 1e-4, {}, "tighter than the truth can tell"}};
  return scene;
}

inline ReportInput input() {
  return {.records = records(),
          .scenes = {scene()},
          .environment = {{"commit", "synthetic"},
                          {"date", "1970-01-01"},
                          {"profile", "quick"},
                          {"processor", "SYNTHETIC NUMBERS, nothing was measured"},
                          {"threads", "1"},
                          {"blas", "none"},
                          {"compiler", "none"}},
          .metric_docs = {
              {"displacement-error", "sqrt(sum w rho |u - u_truth|^2) over space and time, relative to the truth."},
              {"strain-error", "The same with w eps:C:eps: the error of the strain energy."},
              {"surface-deviation", "Largest |u - u_truth| on the surface over time, divided by the body's size."}}};
}

}  // namespace mb::synthetic
