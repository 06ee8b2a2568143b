// Draws Vega-Lite charts without a browser, with the same library that the pages draw them with:
// for readers without JavaScript, for print, and for the files in figures/.
//
// The library runs in SpiderMonkey, which sees no file and no network. The same specification gives
// the same bytes.
#pragma once

#include <string>
#include <string_view>

#include "reports/json.hpp"

namespace reeve {

// On white, in the light theme; a width of "container" becomes 640 px. Throws std::runtime_error
// with what Vega says of a specification that it cannot draw. Identifiers in the drawing begin with
// `ids`, so that a page can hold several. All calls must come from one thread.
std::string chart_svg(const Json& specification, const std::string& ids = "chart");

// What a function of one of the pages' scripts gives: so that a page and what is drawn here share
// one way to make a specification out of data. The script must not need a document, and is run
// once. Throws std::runtime_error with what the script throws.
Json script_value(std::string_view script, const std::string& function, const Json& argument);

}  // namespace reeve
