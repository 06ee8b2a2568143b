#include "cli/flags/parsed_explore.hpp"

#include "cli/command_line.hpp"
#include "core/error.hpp"

namespace reeve::cli {

ParsedExplore::ParsedExplore(const std::vector<std::string>& arguments, const std::string& place) {
  flags.add_to(command);
  try {
    parse(command, arguments);
  } catch (const CLI::ParseError& error) {
    throw InputError({.where = place, .what = error.what()});
  }
}

}  // namespace reeve::cli
