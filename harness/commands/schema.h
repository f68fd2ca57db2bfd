// The format of case files for editors.
#pragma once

#include <string>

namespace mb {

// JSON schema (draft 2020-12), made of the documented keys (cases/scene/keys.h): tables, keys, types, what is required;
// ranges in words. One line.
std::string case_schema();

}  // namespace mb
