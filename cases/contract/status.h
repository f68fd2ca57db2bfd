// What the status of a record says of the run (Record::status).
#pragma once

#include <string>

namespace mb {

// Steps past the limit of their integrator: a result, without a value. `unstable` of growth that the run shows, and
// `unstable: ...` of growth that theory alone foretells of it: what would grow was not moved, or has not grown yet.
inline constexpr const char* unstable = "unstable";
inline constexpr const char* unstable_by_theory = "unstable: by theory alone, the run does not show it";

inline bool is_unstable(const std::string& status) { return status == unstable || status == unstable_by_theory; }

// The metric has no meaning here: no fault of the contender.
inline bool is_undefined(const std::string& status) { return status.starts_with("undefined"); }

}  // namespace mb
