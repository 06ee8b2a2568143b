// The options of `explore`, which what it stored or wrote in shards is read back with.
#pragma once

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

#include "cli/flags/generator_flags.hpp"
#include "cli/flags/ranking_flags.hpp"
#include "cli/flags/table_flags.hpp"
#include "cli/flags/tradeoff_flags.hpp"
#include "cli/inputs.hpp"
#include "cli/outputs.hpp"
#include "search/checkpoint.hpp"
#include "search/explore.hpp"
#include "search/uncertainty/uncertainty.hpp"
#include "sizing/sizing_problem.hpp"
#include "store/exploration_store.hpp"
#include "studies/exploration_study.hpp"

namespace reeve::cli {

// The store that keeps an exploration while it runs, to continue it there.
class StoreFlags {
 public:
  void add_to(CLI::App& command);
  bool is_given() const { return file_.is_given(); }
  void list_in(std::vector<InputFile>& inputs) const { file_.list_in(inputs, "the store"); }
  bool asks_for_all() const { return is_given() && keep_.text == "all"; }

  // Opens the store of the planned exploration. Throws InputError.
  void open(std::optional<ExplorationStore>& store, const ExploreReport& planned,
            const std::vector<std::string>& arguments) const;
  Checkpoint checkpoint(ExplorationStore& store) const;

 private:
  TextOption file_;
  int seconds_ = 60;
  TextOption keep_{"best"};
};

struct ExploreFlags {
  void add_to(CLI::App& command);
  // Throws InputError that names the option.
  ExploreOptions read(const Model& model, const Catalogue& catalogue) const;
  UncertaintyOptions read_uncertainty(const ModelFile& file, const ExploreOptions& options) const;
  // Returns nothing without --target.
  std::optional<SizingOptions> read_target(const ModelFile& file,
                                           const ExploreOptions& options) const;

  GeneratorFlags generator;
  RankingFlags ranking;
  TradeoffFlags tradeoff;
  SweepFlags sweep;
  StoreFlags store;
  std::vector<std::string> constraints;
  TextOption target;
  TextOption shard{"1/1"};
  std::size_t top = 1000;
  std::optional<std::size_t> details;
  std::string out = "out/explore";
  ModelOption model;
  TableFlags tables;
  FormatOption format;
};

// The same once more, as a store or the file of a shard keeps them, with the parser that they
// belong to.
struct ParsedExplore {
  // `place` stands before what is wrong with them. Throws InputError.
  ParsedExplore(const std::vector<std::string>& arguments, const std::string& place);
  ParsedExplore(const ParsedExplore&) = delete;
  ParsedExplore& operator=(const ParsedExplore&) = delete;

  CLI::App command{"", "explore"};
  ExploreFlags flags;
};

}  // namespace reeve::cli
