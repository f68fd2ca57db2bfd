// A case from text, before it is known to be right: what read_toml does once it holds the file's bytes.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "cases/scene/read_toml.h"

namespace mb {

// file: the name that messages show; folder: where files that the case refers to must lie below. Throws CaseErrors.
Scene read_scene(std::string_view text, const std::string& file, const std::filesystem::path& folder,
                 const Vocabulary& vocabulary, const std::string& profile = "quick");

}  // namespace mb
