// The one table of subcommands and options in words: Python's keywords and reference, the man page
// and the completion of the shell are made of it.
#pragma once

#include <string>
#include <vector>

#include "numerics/floors.hpp"

namespace reeve::cli {

// The texts of an option are those of `reeve SUBCOMMAND --help`.
struct OptionText {
  std::string name;  // "fingers"; of a positional "routing"
  std::string preset;
  std::string meaning;
  std::string kind;                       // flag, list (it may be given again), int, float or text
  bool positional = false;                // an argument without a name
  std::string short_name = {};            // "o" of -o
  std::vector<std::string> choices = {};  // all values that it takes; none if any are taken
};

struct SubcommandText {
  std::string name;
  std::string meaning;
  std::vector<OptionText> options;
};

// Returns the subcommands in the order of the program's help, without --help.
std::vector<SubcommandText> subcommand_texts();

}  // namespace reeve::cli
