// Where an exploration is kept while it runs, to go on there.
#pragma once

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

#include "cli/outputs.hpp"
#include "search/checkpoint.hpp"
#include "store/exploration_store.hpp"
#include "studies/exploration_study.hpp"

namespace reeve::cli {

class StoreFlags {
 public:
  void add_to(CLI::App& command);
  bool is_given() const { return option_->count() > 0; }
  void list_in(std::vector<InputFile>& inputs) const;
  bool asks_for_all() const { return is_given() && keep_ == "all"; }

  // Of the exploration that is planned. Throws InputError.
  void open(std::optional<ExplorationStore>& store, const ExploreReport& planned,
            const std::vector<std::string>& arguments) const;
  Checkpoint checkpoint(ExplorationStore& store) const;

 private:
  std::string file_;
  int seconds_ = 60;
  std::string keep_ = "best";
  CLI::Option* option_ = nullptr;
  CLI::Option* keep_given_ = nullptr;
};

}  // namespace reeve::cli
