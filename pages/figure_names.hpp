// Names of figures as files: TR6-held-1.svg. A file's name says what it shows when it lies in
// somebody else's folder.
#pragma once

#include <string>
#include <vector>

#include "core/grasp.hpp"
#include "pages/routing_labels.hpp"

namespace reeve::pages {

// The first part of the names of each routing's files: its label, in which whatever is no letter,
// digit or '-' of ASCII has become '_', so that every file system takes it. No two are alike, also
// where case does not count, and none is that of a chart of the page ("tensions").
std::vector<std::string> file_stems(const std::vector<NamedRouting>& routings);

// "TR6-held-1"
std::string schematic_name(const std::string& stem, Grasp grasp);

}  // namespace reeve::pages
