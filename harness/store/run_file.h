// What the file of one run or analysis holds, from its bytes: a seal (seal.h) around lines of records, or around one
// line with a list of findings. Its name, HASH.jsonl or HASH.json, says whose they are.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "cases/contract/finding.h"
#include "cases/json/record_json.h"

namespace mb {

// Marks (in a folder `records`) or times of one run. There may be no times; a run without marks is one whose writing
// went wrong. Never throws for what the bytes say: all that is wrong is in `refused`.
RecordLines records_in(std::string_view bytes, const std::filesystem::path& file);

// Throws std::runtime_error with one sentence for the whole file.
std::vector<Finding> findings_in(std::string_view bytes, const std::filesystem::path& file);

}  // namespace mb
