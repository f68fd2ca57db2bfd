// A Record as one flat JSON object, schema 1, one a line in results.jsonl:
//
//   {"schema":1,"run":"<32 hex digits>","case":"cylinder-compression","profile":"quick","method":"eigenmodes",
//    "integrator":"exact","degree":4,"cells":[1,4],"settings":{"modes":16,"load_tolerance":1e-05},"modes_used":16,
//    "n_unknowns":22,"metric":"displacement-error","subject":"cylinder","truth":"finer","value":0.0123,"unit":"-",
//    "error_bar":0.0004,"status":"ok","work":{"steps":175,...},"provenance":{"commit":"...",...}}
//
// settings holds what matters to the contender: modes where it is modal, time_step where it steps, the tolerance its
// integrator uses, and whatever differs from its default. value is null where it is not finite, and then status says
// why.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "cases/contract/record.h"
#include "cases/json/json_type.h"

namespace mb {

inline constexpr int record_schema = 1;

// A value that is not finite under the status "ok" is written with the status "not_finite".
Json to_json(const Record& record);

// Throws std::runtime_error that names the key and what is wrong with it. Unknown keys are refused.
Record record_from_json(const Json& json);

struct RefusedLine {
  std::filesystem::path file;
  int line;  // 1-based; 0: the file as a whole
  std::string reason;
};
std::string to_string(const RefusedLine& refused);  // "FILE:LINE: REASON", of the file as a whole "FILE: REASON"

struct RecordLines {
  std::vector<Record> records;  // in the file's order
  std::vector<RefusedLine> refused;
};
// Blank lines are skipped. Lines longer than 64 KiB and files larger than 1 GiB are refused, never loaded.
RecordLines read_records(const std::filesystem::path& file);
// The same of text at hand; file: the name that refusals show.
RecordLines read_records(std::string_view text, const std::filesystem::path& file);

}  // namespace mb
