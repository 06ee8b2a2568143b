// The options of `explore` once more, as a store or the file of a shard keeps them.
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

#include "cli/flags/explore_flags.hpp"

namespace reeve::cli {

// With the parser that the options belong to.
struct ParsedExplore {
  // `place` stands before what is wrong with them. Throws InputError.
  ParsedExplore(const std::vector<std::string>& arguments, const std::string& place);
  ParsedExplore(const ParsedExplore&) = delete;
  ParsedExplore& operator=(const ParsedExplore&) = delete;

  CLI::App command{"", "explore"};
  ExploreFlags flags;
};

}  // namespace reeve::cli
