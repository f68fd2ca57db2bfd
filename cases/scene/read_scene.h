// A case from text, before it is known to be right: what read_toml does once it holds the file's bytes.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "cases/scene/read_toml.h"

namespace mb {

// file: the name that messages show; folder: where files that the case refers to must lie below. Throws CaseErrors.
Scene read_scene(std::string_view text, const std::string& file, const std::filesystem::path& folder,
                 const Vocabulary& vocabulary, const std::string& profile = "quick");

// Every key that the reader asks for in such a text, right or wrong, with what it takes there:
// "body.material.density" -> "a number in [0.001, 100000] kg/m^3". For the documentation of the format.
std::map<std::string, std::string> keys_asked(std::string_view text, const std::filesystem::path& folder,
                                              const Vocabulary& vocabulary);

}  // namespace mb
