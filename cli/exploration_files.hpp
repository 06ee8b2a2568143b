// Files of an exploration in its folder: tables, values, the page and its figures.
#pragma once

#include <CLI/CLI.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "catalog/catalogue.hpp"
#include "reports/exploration/explore_report.hpp"

namespace reeve::cli {

// Returns the arguments of a command that determine the result, as they can be given again: without
// the destination, the shard and the speed.
std::vector<std::string> explore_arguments(const CLI::App& command);

// All that an exploration may write in its folder, but for figures.
std::vector<std::string> exploration_files();

// Writes also shard.json if the report holds the record of a shard. `command` is the subcommand as
// it was given; `details` as in ExplorationView.
void write_exploration(const ExploreReport& report, const CLI::App& command,
                       const Catalogue& catalogue, std::optional<std::size_t> details,
                       const std::filesystem::path& directory);

}  // namespace reeve::cli
