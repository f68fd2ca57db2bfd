// JSON by name alone, for headers: what reads or writes it includes json.h.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace mb {

using Json = nlohmann::ordered_json;  // keys keep the order in which they were written

}  // namespace mb
