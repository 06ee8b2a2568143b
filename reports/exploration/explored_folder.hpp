// Checks if the files in a folder are those of one exploration that was written to its end.
//
// summary.json is the last file of its batch (files.hpp), and each file says of which exploration
// it is (stamp.hpp). So what a kill, a full disk or a copy leaves half done is known.
#pragma once

#include <filesystem>
#include <string>

#include "numerics/floors.hpp"

namespace reeve::reports {

// The text of its summary.json. Throws InputError if there is none, or if files are of different
// explorations. Files that were written before there were ids have none and are taken as they are.
std::string summary_of_one_exploration(const std::filesystem::path& folder);

}  // namespace reeve::reports
