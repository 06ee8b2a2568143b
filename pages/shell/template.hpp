// Templates of the pages: pages/assets/*.mustache, filled with values.
//
// {{key}} escapes what HTML would take for markup; {{{key}}} does not, and is for what is HTML or
// SVG already. {{#key}}…{{/key}} repeats for a list and is left out for false, null and [].
#pragma once

#include <string>
#include <string_view>

#include "reports/output/json.hpp"

namespace reeve::pages {

// Throws std::out_of_range if there is no such template, std::runtime_error if it is malformed.
std::string render(std::string_view name, const Json& values);

// JSON that can stand inside a script element: no text in it can close the element.
std::string script_json(const Json& json);

}  // namespace reeve::pages
