// A study as the tables of a case file that would state it: what the reader of case files takes.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "cases/scene/scene.h"
#include "cases/scene/toml.h"

namespace mb {

using TomlFields = std::map<std::string, TomlValue>;

struct StudyTable {
  TomlFields fields;  // methods, modes, contact_steps, analyses, load_tolerance
  std::vector<TomlFields> rivals, steppings;
};
StudyTable study_table(const Study& study);  // lists that are empty are left out, and meshes not graded
TomlFields fields_of(const Rival& rival);
TomlTable document(const StudyTable& table);

}  // namespace mb
