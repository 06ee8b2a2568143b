// What an exploration leaves in its folder: tables, values, the page and its figures.
#pragma once

#include <CLI/CLI.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "catalog/catalogue.hpp"
#include "reports/exploration/explore_report.hpp"

namespace reeve::cli {

// What of a command decides what is found, as it can be given again: not where to, which shard, or
// how fast.
std::vector<std::string> explore_arguments(const CLI::App& command);

// All that an exploration may write or remove in its folder, but for figures.
std::vector<std::string> exploration_files();

// Of a report that holds the record of a shard also shard.json. `command` is the subcommand as it
// was given; `details` as in ExplorationView.
void write_exploration(const ExploreReport& report, const CLI::App& command,
                       const Catalogue& catalogue, std::optional<std::size_t> details,
                       const std::filesystem::path& directory);

}  // namespace reeve::cli
