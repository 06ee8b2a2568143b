// Messages name the words of a command line that are no option, subcommand or value.
#pragma once

#include <CLI/CLI.hpp>

#include <string>

#include "numerics/floors.hpp"

namespace reeve::cli {

// "explore: unexpected --fingerz 3; did you mean --fingers? See reeve explore --help". `program`
// has been parsed as far as that; the words stand in the order in which they were typed.
std::string unknown_words(const CLI::App& program);

// "complaint; see reeve explore --help", or "complaint? See …" of a question.
std::string pointed_to_help(const std::string& complaint, const CLI::App& program);

// "reeve explore --help", or "reeve --help" as long as no subcommand was given.
std::string help_command(const CLI::App& program);

}  // namespace reeve::cli
