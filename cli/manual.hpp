// The man page, the completion of bash and docs/options.md, made of the one table of options
// (option_texts.hpp).
#pragma once

#include <string>
#include <vector>

#include "cli/option_texts.hpp"

namespace reeve::cli {

// reeve.1, in the macros of man(7).
std::string man_page(const std::vector<SubcommandText>& subcommands, const std::string& version);

// A script for bash: subcommands, options, and values where an option takes some alone; file names
// otherwise.
std::string bash_completion(const std::vector<SubcommandText>& subcommands);

// docs/options.md: each option once, under the subcommands that take it with this text.
std::string options_document(const std::vector<SubcommandText>& subcommands);

}  // namespace reeve::cli
