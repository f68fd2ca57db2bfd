// Tables of analyses of the made-up study, with the columns that analyses give theirs. No number here was measured.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "cases/contract/finding.h"

namespace mb::synthetic {

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double unbounded = std::numeric_limits<double>::infinity();

inline Finding finding(const std::string& case_name, const std::string& analysis, const std::string& name,
                       std::vector<FindingColumn> columns) {
  Finding result{};
  result.run = std::string(32, '1');
  result.analysis = analysis;
  result.name = name;
  result.title = "Synthetic table " + name;
  result.note = "Made up.";
  result.case_name = case_name;
  result.profile = std::string("quick");
  result.columns = std::move(columns);
  return result;
}

inline std::vector<Finding> step_limits(const std::string& case_name) {
  Finding limits = finding(case_name, "step-limits", "step-limits",
                           {{"system", ""},
                            {"modes r", ""},
                            {"scheme", ""},
                            {"integrator", ""},
                            {"omega max", "rad/s"},
                            {"zeta", "-"},
                            {"formula", ""},
                            {"dt formula", "s"},
                            {"dt measured", "s"},
                            {"measured / formula", "-"}});
  for (const char* scheme :
       {"central difference", "symplectic Euler", "explicit Euler", "explicit Euler, exact damping"}) {
    const bool is_stepped = std::string(scheme).find(',') == std::string::npos;
    for (const int r : {4, 16, 64, 256, 0}) {
      const double omega = 40 * std::pow(r ? r : 4096, 0.6), zeta = 0.8 / omega;
      const double dt = scheme[0] == 'e' ? 2 * zeta / omega : 2 / omega;
      const std::string formula = scheme[0] == 'e' ? "2 zeta/omega" : "2/omega";
      limits.rows.push_back({r ? "reduced" : "full", r ? double(r) : nan, scheme, is_stepped ? "its own" : "none",
                             omega, zeta, formula, dt, dt * (1 - 1e-9), 1 - 1e-9});
    }
  }
  Finding exponents = finding(case_name, "step-limits", "step-limit-exponents",
                              {{"claim", ""}, {"scheme", ""}, {"exponent", "-"}, {"claimed", "-"}, {"verdict", ""}});
  exponents.rows = {{"C6", "central difference", -1.0, -1.0, "holds"},
                    {"C6", "symplectic Euler", -1.0, -1.0, "holds"},
                    {"C6", "explicit Euler", -2.0, -1.0, "does not hold: dt ~ omega^-2.00"},
                    {"C6", "explicit Euler, exact damping", -2.0, -1.0, "does not hold: dt ~ omega^-2.00"}};
  return {limits, exponents};
}

// Stable up to 2/omega, inaccurate from a third of it.
inline Finding stability(const std::string& case_name) {
  Finding map = finding(case_name, "stability-map", "stability-map",
                        {{"integrator", ""}, {"modes r", ""}, {"dt", "s"}, {"found", ""}, {"limit", "s"}});
  for (const char* integrator : {"central-difference", "newmark"}) {
    for (const int r : {4, 16, 64}) {
      for (int i = -6; i < 7; ++i) {
        const double limit = 0.05 / std::pow(r, 0.6), dt = 0.01 * std::pow(10, i / 4.0);
        const bool grows = integrator[0] == 'c' && dt > limit;
        map.rows.push_back({integrator, double(r), dt,
                            grows            ? "unstable"
                            : 3 * dt > limit ? "inaccurate"
                                             : "stable",
                            integrator[0] == 'c' ? limit : std::numeric_limits<double>::infinity()});
      }
    }
  }
  return map;
}

inline std::vector<Finding> aliasing(const std::string& case_name) {
  Finding marks = finding(case_name, "aliasing", "aliasing",
                          {{"frame rate", "1/s"},
                           {"contender", ""},
                           {"modes r", ""},
                           {"shutter", ""},
                           {"sub-samples", ""},
                           {"aliasing", "-"},
                           {"droop", "-"}});
  Finding claim = finding(
      case_name, "aliasing", "aliasing-claim",
      {{"claim", ""}, {"frame rate", "1/s"}, {"aliasing cut modal", "-"}, {"sub-samples needed", ""}, {"verdict", ""}});
  for (const double rate : {24.0, 30.0, 60.0, 120.0}) {
    for (const int n : {1, 2, 4, 8, 16, 32, 64, 0}) {
      const double value = n ? 0.2 * 24 / rate / n : 0.002;
      marks.rows.push_back({rate, "full order", nan, n == 1 ? "point" : n ? "box" : "exact", double(n), value, 0.05});
    }
    for (const int r : {4, 16, 64}) {
      marks.rows.push_back({rate, "modal", double(r), "point", 1.0, 0.002 * r, 0.0});
      marks.rows.push_back({rate, "modal", double(r), "exact", 0.0, 0.0002 * r, 0.03});
    }
    marks.rows.push_back({rate, "modal, cut at F/2", 5.0, "point", 1.0, 1e-3, 0.0});
    claim.rows.push_back({"C2", rate, 1e-3, rate > 100 ? unbounded : 32.0, "holds"});
  }
  return {marks, claim};
}

inline Finding budget(const std::string& case_name, const std::string& body = "block") {
  Finding table = finding(case_name, "budget", "budget",
                          {{"body", ""},
                           {"method", ""},
                           {"modes r", ""},
                           {"integrator", ""},
                           {"setting", ""},
                           {"part", ""},
                           {"M norm", "-"},
                           {"K norm", "-"}});
  for (const int r : {4, 16, 64, 256}) {
    double total = 0;
    for (const auto& [part, size] :
         {std::pair("time stepping", 4e-3), std::pair("truncation", 0.3 / r), std::pair("discretisation", 2e-3)}) {
      table.rows.push_back(
          {body, "static-correction", double(r), "central-difference", "step 0.001 s", part, size, 3 * size});
      total = std::hypot(total, size);
    }
    table.rows.push_back(
        {body, "static-correction", double(r), "central-difference", "step 0.001 s", "finite strain", nan, nan});
    table.rows.push_back(
        {body, "static-correction", double(r), "central-difference", "step 0.001 s", "total", total, 3 * total});
  }
  return table;
}

inline Finding response(const std::string& case_name) {
  Finding table = finding(
      case_name, "frequency-response", "frequency-response",
      {{"load", ""}, {"contender", ""}, {"modes r", ""}, {"frequency", "Hz"}, {"amplitude", "m"}, {"phase", "rad"}});
  for (const int r : {0, 4, 16}) {
    for (int i = 0; i < 300; ++i) {
      const double f = 0.2 * (i + 1);
      double amplitude = r ? 0 : 1e-5;
      for (int k = 1; k <= (r ? r / 4 + 1 : 6); ++k) amplitude += 1e-3 / std::hypot(100.0 * k * k - f * f, 0.4 * f);
      table.rows.push_back({"squeeze", r ? "eigenmodes" : "full order", r ? double(r) : nan, f, amplitude, 0.1});
    }
  }
  return table;
}

inline std::vector<Finding> of_modes(const std::string& case_name) {
  Finding damping = finding(case_name, "damping", "damping",
                            {{"mode", ""}, {"frequency", "Hz"}, {"zeta asked", "-"}, {"zeta full", "-"}});
  Finding amplitudes = finding(case_name, "mode-amplitudes", "mode-amplitudes",
                               {{"mode", ""},
                                {"frequency", "Hz"},
                                {"fixed energy", "m kg^1/2"},
                                {"fixed force", "m kg^1/2"},
                                {"fixed impulse", "m kg^1/2"}});
  for (int i = 1; i <= 20; ++i) {
    const double f = 6.0 * std::pow(i, 0.7);
    damping.rows.push_back({double(i), f, i <= 6 ? 0.02 : nan, 0.02 + 1e-4 * i});
    amplitudes.rows.push_back({double(i), f, 6 / f, 36 / f / f, 6 / f});
  }
  Finding exponents = finding(case_name, "mode-amplitudes", "mode-amplitude-exponents",
                              {{"claim", ""}, {"held fixed", ""}, {"exponent", "-"}, {"theory", "-"}, {"verdict", ""}});
  exponents.rows = {{"C7", "energy", 1.0, 1.0, "does not hold: 1.00, not 2"},
                    {"C7", "force", 2.0, 2.0, "holds"},
                    {"C7", "impulse", 1.0, 1.0, "does not hold: 1.00, not 2"}};
  return {damping, amplitudes, exponents};
}

// Made up so that the claim holds against brute force and not against a tree, and not for all shapes.
inline std::vector<Finding> of_collision(const std::string& case_name) {
  Finding cost =
      finding(case_name, "collision-cost", "collision-cost",
              {{"partner", ""}, {"sweep", ""}, {"contender", ""}, {"polygons n", ""}, {"points m", ""}, {"time", "s"}});
  for (const double m : {100.0, 1000.0, 10000.0}) {
    cost.rows.push_back({"sphere", "n = m", "polygons, brute force", m, m, 1e-8 * m * m});
    cost.rows.push_back({"sphere", "n = m", "polygons, tree", m, m, 1e-7 * m * std::log2(m)});
    cost.rows.push_back({"sphere", "n = m", "analytic, distance", nan, m, 1e-7 * m});
  }
  Finding claim = finding(case_name, "collision-cost", "collision-cost-claim",
                          {{"claim", ""},
                           {"against", ""},
                           {"exponent analytic", "-"},
                           {"exponent rival", "-"},
                           {"crossover", ""},
                           {"verdict", ""}});
  claim.rows = {{"C11", "polygons, brute force; sphere", 1.0, 2.0, 100.0, "holds"},
                {"C11", "polygons, tree; sphere", 1.0, 1.1, 100.0, "does not hold: the rival ~ m^1.10"}};
  Finding errors = finding(case_name, "contact-forces", "contact-forces",
                           {{"shape", ""}, {"depth", "-"}, {"contender", ""}, {"samples", ""}, {"force", "-"}});
  for (const double n : {26.0, 386.0, 6146.0}) {
    errors.rows.push_back({"superquadric", 0.01, "vertices, areas", n, 30 / n});
    errors.rows.push_back({"superquadric", 0.01, "quadrature, region", n, 1 / n});
  }
  errors.rows.push_back({"superquadric", 0.01, "curvatures", nan, 0.02});
  Finding gains = finding(case_name, "contact-forces", "contact-forces-claim",
                          {{"claim", ""}, {"compared", ""}, {"gain", "-"}, {"least gain", "-"}, {"verdict", ""}});
  gains.rows = {{"C12", "force by curvatures, sphere", unbounded, unbounded, "holds"},
                {"C12", "force by quadrature, region, sphere", 30.0, 20.0, "holds"},
                {"C12", "force by quadrature, uniform, sphere", 0.9, 0.8, "does not hold: at 0 of 3"}};
  return {cost, claim, errors, gains};
}

// A half sine, of which few modes see less; and what the parts of a run take.
inline std::vector<Finding> of_contact(const std::string& case_name) {
  Finding force = finding(case_name, "contact", "force-history",
                          {{"contender", ""}, {"modes r", ""}, {"time", "s"}, {"normal force", "N"}});
  Finding time = finding(case_name, "contact", "contact-time",
                         {{"method", ""}, {"modes r", ""}, {"dt", "s"}, {"part", ""}, {"time", "s"}, {"share", "-"}});
  for (const int r : {0, 4, 64}) {
    for (int k = 0; k <= 60; ++k) {
      const double f = (r ? 9 - 6.0 / r : 9) * std::max(0.0, std::sin(0.07 * (k - 5)));
      force.rows.push_back({r ? "static-correction" : "truth, finer", r ? double(r) : nan, 0.3 + 5e-4 * k, f});
    }
    if (r == 0) continue;
    const double seconds[] = {2e-4, 4e-3, 1e-5 * r, 1e-4 * r};
    double sum = 0;
    for (const double one : seconds) sum += one;
    const char* const parts[] = {"search for the first touch", "loads of contact", "steps", "reconstruction"};
    for (int i = 0; i < 4; ++i) {
      time.rows.push_back({"static-correction", double(r), 1e-4, parts[i], seconds[i], seconds[i] / sum});
    }
  }
  force.rows.push_back({"eigenmodes", 4.0, 0.3, nan});
  time.rows.push_back({"eigenmodes", 4.0, 1e-4, "steps", nan, nan});
  return {force, time};
}

inline std::vector<Finding> findings(const std::string& case_name) {
  std::vector<Finding> all = step_limits(case_name);
  all.push_back(stability(case_name));
  for (const auto& more : {aliasing(case_name), of_modes(case_name), of_collision(case_name), of_contact(case_name)})
    all.insert(all.end(), more.begin(), more.end());
  all.push_back(budget(case_name));
  all.push_back(response(case_name));
  return all;
}

}  // namespace mb::synthetic
