#include "cases/json/record_json.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cases/contract/status.h"
#include "cases/json/json.h"
#include "cases/json/members.h"
#include "cases/scene/printable.h"

namespace mb {

namespace {

constexpr long max_count = std::numeric_limits<long>::max();
constexpr std::size_t max_status = 1000;  // [bytes] kept of a message, in one line that prints: readers refuse others

// The tolerance of an integrator that has one is part of the answer even at its default.
Json settings_json(const Record& record) {
  const Settings& settings = record.contender.settings;
  const Settings standard;
  const std::string& integrator = record.contender.integrator;
  Json json = Json::object();
  if (record.modes_used >= 0 || settings.modes != standard.modes) json["modes"] = settings.modes;
  if (settings.time_step != standard.time_step) json["time_step"] = settings.time_step;
  if (integrator == "sundials" || settings.relative_tolerance != standard.relative_tolerance) {
    json["relative_tolerance"] = settings.relative_tolerance;
  }
  if (integrator == "exact" || settings.load_tolerance != standard.load_tolerance) {
    json["load_tolerance"] = settings.load_tolerance;
  }
  if (settings.rotation != standard.rotation) json["rotation"] = to_string(settings.rotation);
  return json;
}

RotationCoupling rotation_from(const std::string& text) {
  for (const RotationCoupling rotation :
       {RotationCoupling::rigid, RotationCoupling::coupled, RotationCoupling::unstiffened})
    if (text == to_string(rotation)) return rotation;
  refuse("rotation", "is none that is known");
}

Settings settings_from(const Json& json) {
  Members members(json, "settings");
  Settings settings;
  const auto read = [&](const char* key, double& value) {
    if (members.find(key) != nullptr) value = members.number(key);
    if (value < 0) refuse(key, "is negative");
  };
  if (members.find("modes") != nullptr) {
    settings.modes = static_cast<int>(members.integer("modes", 0, std::numeric_limits<int>::max()));
  }
  read("time_step", settings.time_step);
  read("relative_tolerance", settings.relative_tolerance);
  read("load_tolerance", settings.load_tolerance);
  if (members.find("rotation") != nullptr) settings.rotation = rotation_from(members.text("rotation"));
  members.expect_no_more();
  return settings;
}

Json work_json(const Work& work) {
  return {{"steps", work.steps},
          {"rejected", work.rejected},
          {"factorisations", work.factorisations},
          {"solves", work.solves},
          {"load_evaluations", work.load_evaluations}};
}

Work work_from(const Json& json) {
  Members members(json, "work");
  const auto count = [&](const char* key) { return members.integer(key, 0, max_count); };
  const Work work{.steps = count("steps"),
                  .rejected = count("rejected"),
                  .factorisations = count("factorisations"),
                  .solves = count("solves"),
                  .load_evaluations = count("load_evaluations")};
  members.expect_no_more();
  return work;
}

Resolution mesh_from(Members& members) {
  Resolution resolution{.degree = static_cast<int>(members.integer("degree", 0, 99)), .cells = {}};
  const Json& cells = members.get("cells");
  if (!cells.is_array() || cells.size() > 3) refuse("cells", "is not a list of at most 3 counts");
  for (const Json& n : cells) resolution.cells.push_back(static_cast<int>(integer(n, "cells", 0, 1 << 20)));
  if (const Json* graded = members.find("graded"))
    resolution.graded = static_cast<int>(integer(*graded, "graded", 1, 99));
  if (const Json* bias = members.find("bias")) {
    if (!bias->is_array() || bias->size() != 3) refuse("bias", "is not a list of 3 numbers");
    for (const Json& ratio : *bias) {
      if (!ratio.is_number() || !(ratio.get<double>() > 0)) refuse("bias", "is not a list of positive numbers");
      resolution.bias.push_back(ratio.get<double>());
    }
  }
  if (members.find("distorted")) resolution.distorted = members.number("distorted");
  return resolution;
}

// Of a whole scene.
Resolution resolution_from(Members& members) {
  Resolution resolution = mesh_from(members);
  if (const Json* others = members.find("others")) {
    if (!others->is_array() || others->empty() || others->size() > 63)
      refuse("others", "is not a list of 1 to 63 meshes");
    for (const Json& other : *others) {
      Members own(other, "others");
      resolution.others.push_back(mesh_from(own));
      own.expect_no_more();
    }
  }
  return resolution;
}

double value_from(Members& members, const std::string& status) {
  if (!members.get("value").is_null()) return members.number("value");
  if (status == "ok") refuse("value", "is null although the status is ok");
  return std::numeric_limits<double>::quiet_NaN();
}

std::optional<double> error_bar_from(Members& members) {
  if (members.get("error_bar").is_null()) return std::nullopt;
  const double bar = members.number("error_bar");
  if (bar < 0) refuse("error_bar", "is negative");
  return bar;
}

}  // namespace

namespace {

void add(Json& json, const Resolution& mesh) {
  json["degree"] = mesh.degree;
  json["cells"] = mesh.cells;
  if (mesh.graded > 0) json["graded"] = mesh.graded;
  if (!mesh.bias.empty()) json["bias"] = mesh.bias;
  if (mesh.distorted > 0) json["distorted"] = mesh.distorted;
  for (const Resolution& other : mesh.others) {
    Json own;
    add(own, other);
    json["others"].push_back(own);
  }
}

}  // namespace

Json to_json(const Record& record) {
  const bool finite = std::isfinite(record.value);
  const bool is_number = finite && !is_undefined(record.status);
  const bool has_bar = record.error_bar && std::isfinite(*record.error_bar);
  Json json;
  json["schema"] = record_schema;
  json["run"] = record.run;
  json["case"] = record.case_name;
  json["profile"] = record.profile;
  json["method"] = record.contender.method;
  json["integrator"] = record.contender.integrator;
  add(json, record.contender.resolution);
  json["settings"] = settings_json(record);
  json["modes_used"] = record.modes_used;
  json["n_unknowns"] = record.n_unknowns;
  json["metric"] = record.metric;
  json["subject"] = record.subject;
  json["truth"] = record.truth;
  json["value"] = is_number ? Json(record.value) : Json(nullptr);
  json["unit"] = record.unit;
  json["error_bar"] = has_bar ? Json(*record.error_bar) : Json(nullptr);
  json["status"] = !finite && record.status == "ok" ? "not_finite" : one_line(record.status, max_status);
  json["work"] = work_json(record.work);
  json["provenance"] = record.provenance;
  return json;
}

Record record_from_json(const Json& json) {
  Members members(json, "record");
  if (integer(members.get("schema"), "schema", 0, max_count) != record_schema) refuse("schema", "is not 1");
  Record record;
  record.run = members.hash("run");
  record.case_name = members.name("case");
  record.profile = members.one_of("profile", {"quick", "standard", "full"});
  record.contender = {.method = members.name("method"),
                      .integrator = members.name_or_none("integrator"),
                      .resolution = resolution_from(members),
                      .settings = settings_from(members.get("settings"))};
  record.modes_used = static_cast<int>(members.integer("modes_used", -1, std::numeric_limits<int>::max()));
  record.n_unknowns = members.integer("n_unknowns", 0, max_count);
  record.metric = members.name("metric");
  record.subject = members.name_or_none("subject");
  record.truth = members.one_of("truth", {"finer", "same_mesh", "exact", "same_modes", ""});
  record.status = members.text("status");
  record.value = value_from(members, record.status);
  record.unit = members.text("unit");
  record.error_bar = error_bar_from(members);
  record.work = work_from(members.get("work"));
  record.provenance = members.texts("provenance");
  members.expect_no_more();
  return record;
}

}  // namespace mb
