#include "harness/commands/schema.h"

#include "cases/json/json.h"
#include "cases/scene/keys.h"

namespace mb {

namespace {

Json object() { return {{"type", "object"}, {"properties", Json::object()}, {"additionalProperties", false}}; }

bool is_table(const KeyDoc& key) { return key.type == "a table"; }
bool is_table_list(const KeyDoc& key) { return key.type.ends_with(" tables"); }

Json value_schema(const KeyDoc& key) {
  if (is_table(key)) return object();
  if (is_table_list(key)) return {{"type", "array"}, {"items", object()}};
  if (key.type == "\"auto\" or a number") return {{"anyOf", {{{"const", "auto"}}, {{"type", "number"}}}}};
  if (key.type == "a number") return {{"type", "number"}};
  if (key.type == "an integer" || key.type == "the number 1") return {{"type", "integer"}};
  if (key.type.starts_with("an array") || key.type == "integers") return {{"type", "array"}};
  return {{"type", "string"}};
}

// The keys directly below a table, under whatever name their home has: what stands in several places is told once.
std::vector<std::pair<std::string, const KeyDoc*>> keys_below(const std::string& table) {
  std::vector<std::pair<std::string, const KeyDoc*>> found;
  for (const KeyGroup& group : key_groups())
    for (const KeyDoc& key : group.keys) {
      const auto dot = key.path.rfind('.');
      const std::string name = dot == std::string::npos ? key.path : key.path.substr(dot + 1);
      const bool top = table.empty() && dot == std::string::npos;
      const KeyDoc* there = top ? &key : table.empty() ? nullptr : find_key(table + "." + name);
      if (there == &key) found.emplace_back(name, &key);
    }
  return found;
}

void fill(Json& schema, const std::string& table) {
  for (const auto& [name, key] : keys_below(table)) {
    if (name == "NAME" || name == "BODY") continue;  // any name: filled below
    Json entry = value_schema(*key);
    const std::string path = table.empty() ? name : table + "." + name;
    if (is_table(*key)) fill(entry, path);
    if (is_table_list(*key)) fill(entry["items"], path);
    entry["description"] = key->meaning + " (" + takes(*key) + "; " + key->fallback + ")";
    schema["properties"][name] = std::move(entry);
    if (key->fallback == "required") schema["required"].push_back(name);
  }
  if (table == "profile")
    for (const char* profile : {"quick", "standard", "full"})
      fill(schema["properties"][profile] = object(), table + "." + profile);
  if (table.ends_with(".resolution") && table.starts_with("profile.")) {
    Json mesh = object();
    fill(mesh, table + ".any");
    schema["additionalProperties"] = std::move(mesh);
  }
}

}  // namespace

std::string case_schema() {
  Json schema = object();
  schema["$schema"] = "https://json-schema.org/draft/2020-12/schema";
  schema["title"] = "Modalbench case";
  fill(schema, "");
  return to_line(schema);
}

}  // namespace mb
