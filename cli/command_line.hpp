// The command that was given, to print where its results are shown: pasted into a shell, in the
// same folder, it gives them again.
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

#include "numerics/floors.hpp"

namespace reeve::cli {

// "reeve explore --fingers 3 --hardware 'my glove.toml'": what was given, not what it defaults to,
// positionals first. `left_out` names options that the results do not depend on.
std::string command_line(const CLI::App& command, const std::vector<std::string>& left_out = {});

// " --model 'my model.toml'", for another command that takes the same: of these options those that
// were given, each behind a blank.
std::string given_options(const CLI::App& command, const std::vector<std::string>& names);

}  // namespace reeve::cli
