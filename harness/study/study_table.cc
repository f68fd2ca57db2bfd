#include "harness/study/study_table.h"

namespace mb {

namespace {

TomlValue value(double x) { return {x, {}}; }
TomlValue value(int n) { return {std::int64_t{n}, {}}; }
TomlValue value(const std::string& text) { return {text, {}}; }
template <class T>
TomlValue value(const std::vector<T>& list) {
  TomlArray array;
  for (const T& entry : list) array.items.push_back(value(entry));
  return {std::move(array), {}};
}

template <class T>
void put(TomlFields& fields, const std::string& key, const std::vector<T>& list) {
  if (!list.empty()) fields[key] = value(list);
}

TomlFields fields_of(const Stepping& stepping) {
  TomlFields fields{{"integrator", value(stepping.integrator)}};
  put(fields, "methods", stepping.methods);
  put(fields, "modes", stepping.modes);
  put(fields, "time_steps", stepping.time_steps);
  put(fields, "relative_tolerances", stepping.relative_tolerances);
  return fields;
}

TomlTable table(const TomlFields& fields) {
  TomlTable all;
  for (const auto& [key, what] : fields) all.entries.push_back({key, what.where, what});
  return all;
}

// Errors of a whole table are shown where its integrator was named, those of all of them at the first that has a place.
TomlValue tables(const std::vector<TomlFields>& list) {
  TomlArray array;
  Position first;
  for (const TomlFields& fields : list) {
    array.items.push_back({table(fields), fields.at("integrator").where});
    if (first.line == 0) first = array.items.back().where;
  }
  return {std::move(array), first};
}

}  // namespace

TomlFields fields_of(const Rival& rival) {
  TomlFields fields{{"integrator", value(rival.integrator)}};
  put(fields, "degrees", rival.degrees);
  put(fields, "cells", rival.cells);
  put(fields, "time_steps", rival.time_steps);
  put(fields, "relative_tolerances", rival.relative_tolerances);
  put(fields, "second_cells", rival.second_cells);
  if (rival.graded > 0) fields["graded"] = value(rival.graded);
  return fields;
}

StudyTable study_table(const Study& study) {
  StudyTable all;
  put(all.fields, "methods", study.methods);
  put(all.fields, "modes", study.modes);
  put(all.fields, "contact_steps", study.contact_steps);
  if (study.rotations != Study{}.rotations) {
    std::vector<std::string> names;
    for (const RotationCoupling rotation : study.rotations) names.emplace_back(to_string(rotation));
    put(all.fields, "rotation", names);
  }
  put(all.fields, "analyses", study.analyses);
  all.fields["load_tolerance"] = value(study.load_tolerance);
  for (const Rival& rival : study.rivals) all.rivals.push_back(fields_of(rival));
  for (const Stepping& stepping : study.steppings) all.steppings.push_back(fields_of(stepping));
  return all;
}

TomlTable document(const StudyTable& study) {
  TomlFields fields = study.fields;
  fields["rival"] = tables(study.rivals);
  fields["stepping"] = tables(study.steppings);
  return table(fields);
}

}  // namespace mb
