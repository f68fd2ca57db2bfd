// Findings as JSON (cases/contract/finding.h), schema 4, one object a table:
//
//   {"schema":4,"run":"<32 hex digits>","analysis":"step-limits","name":"step-limits","title":"...","note":"...",
//    "case":"cylinder-shear","profile":"quick","columns":[{"name":"modes","unit":""},{"name":"limit","unit":"s"}],
//    "rows":[[8,0.0123],["full",{"special":"inf"}]],"provenance":{"commit":"...",...}}
//
// A number that does not exist, in memory NaN, is null; infinities are the objects {"special": "inf"}, {"special":
// "-inf"}.
#pragma once

#include "cases/contract/finding.h"
#include "cases/json/json_type.h"

namespace mb {

inline constexpr int finding_schema = 4;

// Bounds: 1 to 64 columns, at most 100,000 rows, each as long as columns, texts of at most 4096 bytes.
// Throws std::invalid_argument where the finding is out of bounds, so that nothing unreadable is ever written.
Json to_json(const Finding& finding);
// Throws std::runtime_error that names the key, on what is missing, unknown, of the wrong type or out of bounds.
Finding finding_from_json(const Json& json);

}  // namespace mb
