#include "cli/flags/parsed_explore.hpp"

#include <algorithm>
#include <utility>

#include "core/error.hpp"

namespace reeve::cli {

ParsedExplore::ParsedExplore(std::vector<std::string> arguments, const std::string& place) {
  flags.add_to(command);
  std::reverse(arguments.begin(), arguments.end());  // as CLI11 wants them
  try {
    command.parse(std::move(arguments));
  } catch (const CLI::ParseError& error) {
    throw InputError({.where = place, .what = error.what()});
  }
}

}  // namespace reeve::cli
