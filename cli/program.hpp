// The program as a function: what is asked on the command line is done, and what goes wrong is said
// on stderr.
#pragma once

#include "numerics/floors.hpp"

namespace reeve::cli {

// The exit code (cli/complaint.hpp).
int program(int argc, char** argv);

}  // namespace reeve::cli
