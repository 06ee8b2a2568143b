// `rank` of what a store keeps.
#pragma once

#include <CLI/CLI.hpp>

#include <functional>
#include <string>
#include <vector>

#include "cli/flags/table_flags.hpp"
#include "cli/inputs.hpp"
#include "reports/exploration/design_list.hpp"
#include "studies/stored_ranking.hpp"

namespace reeve::cli {

struct StoredRankingFlags {
  TextOption store;
  std::vector<std::string> constraints;
  std::size_t top = 0;

  void add_to(CLI::App& rank);
};

// Told what a list of the designs has, before the work. May be empty.
using AsListed = std::function<void(const ListedWith&)>;

// `rank` is the command as it was given, with a store.
StoredRanking stored_ranking_of(const CLI::App& rank, const StoredRankingFlags& flags,
                                const AsListed& as_listed = {});

// `rank` is the command as it was given, with a store; how it is shown is its own.
int rank_stored(const CLI::App& rank, const StoredRankingFlags& flags, const TableFlags& tables,
                const FormatOption& format);

}  // namespace reeve::cli
