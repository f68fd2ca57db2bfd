// Records of a made-up study, for tests and for looking at the page. No number here was measured.
//
//   error(r) = a (1 + r)^-p + b,   error(h, dt) = a h^2 + b dt^2,   time ~ unknowns x steps
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/content.h"
#include "reports/synthetic_findings.h"

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
  records.push_back(seconds("stepping-time", 0.4 * online, contender));
  records.push_back(seconds("assembly-time", 0.3 * offline, contender));
  for (std::size_t i = first; i < records.size(); ++i) {
    records[i].n_unknowns = n_unknowns;
    if (contender.method == "full-order" || contender.method == "full") continue;
    const int elastic = contender.method == "linear" ? 6 : contender.method == "quadratic" ? 24 : 0;
    records[i].modes_used = std::max(elastic, contender.settings.modes);
  }
}

inline Contender stepped(const std::string& method, int modes, const std::string& integrator, double time_step) {
  Contender contender = reduced(method, modes);
  contender.integrator = integrator;
  contender.settings.time_step = time_step;
  return contender;
}

// What the closed form leaves out and what the step adds, of the second order.
inline void step_reduced(std::vector<Record>& all) {
  for (const char* integrator : {"newmark", "symplectic-euler", "central-difference"}) {
    for (const int r : {8, 32, 128}) {
      for (const double time_step : {0.008, 0.004, 0.002, 0.001, 0.0005}) {
        const double order = integrator[0] == 's' ? 1 : 2;
        const double e = std::hypot(0.25 * std::pow(1 + r, -1.5), 0.3 * std::pow(time_step / 0.008, order));
        grade(all, stepped("static-correction", r, integrator, time_step), e, 3e-6 * r * 0.29 / time_step, 0.5);
      }
    }
  }
  for (const double rtol : {1e-2, 3e-3, 1e-3, 3e-4, 1e-4}) {
    Contender contender = stepped("eigenmodes", 32, "sundials", 0);
    contender.settings.relative_tolerance = rtol;
    grade(all, contender, std::hypot(0.6 * std::pow(33, -0.8), rtol), 0.01 / std::pow(rtol, 0.2), 0.6);
    contender.method = "full-order";
    contender.settings.modes = 0;
    grade(all, contender, std::hypot(5 * std::pow(rtol, 0.9), 8e-4), 0.4 / std::pow(rtol, 0.2), 0.7);
  }
  grade(all, reduced("linear", 0), 0.4, 2e-4, 0.1);
  grade(all, reduced("quadratic", 0), 0.12, 3e-4, 0.1);
  for (const double time_step : {0.002, 0.001, 0.0005}) {
    grade(all, stepped("full", 0, "central-difference", time_step), 4e3 * time_step * time_step, 0.02 / time_step, 0.4);
  }
  grade(all, stepped("eigenmodes", 32, "explicit-euler", 0.001), std::numeric_limits<double>::quiet_NaN(), 1, 1);
}

// Any number that is not finite is that of a contender that blew up.
inline void blow_up(std::vector<Record>& all) {
  for (Record& record : all) {
    const Settings& settings = record.contender.settings;
    const bool coarse = record.contender.method == "full-order" &&
                        record.contender.resolution == Resolution{1, {1, 4}} && settings.time_step == 0.02;
    const bool unstable = record.contender.integrator == "explicit-euler";
    if ((!coarse && !unstable) || record.unit != "-") continue;
    record.status = unstable ? "unstable" : "not_finite";
    record.value = std::numeric_limits<double>::quiet_NaN();
  }
}

// Times that something else disturbed, and times of another machine.
inline void disturb(std::vector<Record>& all) {
  for (Record& record : all) {
    const Contender& contender = record.contender;
    if (record.metric == "online-time" && contender.method == "static-correction" && contender.settings.modes == 8) {
      record.provenance["busy"] = "0.8";
    }
    if (record.unit == "s" && contender.integrator == "sundials" && contender.settings.relative_tolerance == 1e-2) {
      record.provenance["processor"] = "another processor";
    }
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
  step_reduced(all);
  blow_up(all);
  disturb(all);
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
  scene.bodies = {{.name = "cylinder",
                   .shape = Cylinder{.radius = 0.05, .length = 0.2},
                   .material = {.youngs_modulus = 5e4, .poissons_ratio = 0.45, .density = 1000},
                   .damping = {},
                   .damping_ratios = {},
                   .resolution = {4, {1, 4}},
                   .supports = {}}};
  const auto check = [](const char* method, const char* metric, int modes, double at_most, const char* why) {
    Check one{};
    one.method = method;
    one.metric = metric;
    one.truth = "finer";
    one.modes = modes;
    one.at_most = at_most;
    one.why = why;
    return one;
  };
  scene.checks = {check("static-correction", "displacement-error", 32, 0.02, "32 modes resolve the pulse"),
                  check("eigenmodes", "strain-error", 64, 0.15, "plain truncation misses the loaded faces"),
                  check("static-correction", "displacement-error", 128, 1e-4, "tighter than the truth can tell")};
  Check of_table{};
  of_table.table = "step-limits";
  of_table.column = "measured / formula";
  of_table.at_least = 0.999;
  of_table.why = "theory is met to 1e-3";
  scene.checks.push_back(of_table);
  return scene;
}

inline ReportInput input() {
  return {.records = records(),
          .findings = findings("cylinder-compression"),
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

// The same study under n names: what a page has to bear.
inline ReportInput many(int n) {
  ReportInput one = input(), all = one;
  all.records.clear();
  all.findings.clear();
  all.scenes.clear();
  for (int i = 1; i <= n; ++i) {
    const std::string name = "cylinder-" + std::to_string(i);
    for (Record& record : one.records) {
      record.case_name = name;
      all.records.push_back(record);
    }
    for (const Finding& finding : findings(name)) all.findings.push_back(finding);
    all.scenes.push_back(one.scenes[0]);
    all.scenes.back().name = name;
  }
  return all;
}

}  // namespace mb::synthetic
