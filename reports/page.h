// The page: a template made at build time (markup, style, one script, content security policy) with the report's data
// in a <script type="application/json">.
#pragma once

#include <string>
#include <string_view>

#include "cases/json/json_type.h"
#include "reports/views.h"

namespace mb {

std::string_view page_template();  // "" where the browser part was not built; made by the build

// JSON text that stands inside a script element: `<` is written \u003c, so that neither </script nor <!-- can occur.
std::string script_json(const Json& json);

// Six digits are more than anybody reads off a page (the files in data/ have all of them); null where not finite.
Json rounded(double value);

// A cell is "text", [text, value], [text, value, bar] or [text, value, bar, status]; status "ok" is left out. In a
// column that has a pool a cell is its place there, a whole number.
Json table_json(const Sheet& table);

Json page_json(const Evaluation& evaluation);

// Throws std::logic_error where the template has no place for the data.
std::string page(const Evaluation& evaluation, std::string_view page_template);

}  // namespace mb
