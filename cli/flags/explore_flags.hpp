// The options of `explore`, which what it stored or wrote in shards is read back with.
#pragma once

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

#include "cli/flags/ladder_flags.hpp"
#include "cli/flags/store_flags.hpp"
#include "cli/flags/sweep_flags.hpp"
#include "cli/flags/table_flags.hpp"
#include "cli/inputs.hpp"
#include "search/explore.hpp"
#include "search/uncertainty/uncertainty.hpp"

namespace reeve::cli {

struct ExploreFlags {
  void add_to(CLI::App& command);
  // Throws InputError that names the option.
  ExploreOptions read(const Model& model, const Catalogue& catalogue) const;
  UncertaintyOptions read_uncertainty(const ModelFile& file, const ExploreOptions& options) const;

  GeneratorFlags generator;
  RankingFlags ranking;
  LadderFlags ladder;
  SweepFlags sweep;
  StoreFlags store;
  std::vector<std::string> constraints;
  std::string shard = "1/1";
  CLI::Option* shard_given = nullptr;
  std::size_t top = 1000;
  std::optional<std::size_t> details;
  std::string out = "out/explore";
  ModelOption model;
  TableFlags tables;
  FormatOption format;
};

}  // namespace reeve::cli
