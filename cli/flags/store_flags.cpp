#include "cli/flags/store_flags.hpp"

#include <chrono>

#include "cli/inputs.hpp"
#include "reports/exploration/store_description.hpp"
#include "studies/stored_exploration.hpp"

namespace reeve::cli {

void StoreFlags::add_to(CLI::App& command) {
  constexpr int a_day = 86400;
  option_ = command.add_option(
      "--store", file_,
      "Keep what is found in this SQLite file, and go on from what it holds; see docs/store.md");
  command
      .add_option("--store-every", seconds_,
                  "Seconds between two times that the store is written; 0: after every batch")
      ->needs(option_)
      ->check(CLI::Range(0, a_day))
      ->capture_default_str();
  keep_given_ =
      command
          .add_option("--keep", keep_,
                      "What the store keeps: best, what is listed; all, every design with "
                      "its objectives, which rank can then rank otherwise")
          ->needs(option_)
          ->check(CLI::IsMember({"best", "all"}))
          ->capture_default_str();
}

void StoreFlags::list_in(std::vector<InputFile>& inputs) const {
  if (is_given()) inputs.push_back({file_, "the store"});
}

void StoreFlags::open(std::optional<ExplorationStore>& store, const ExploreReport& planned,
                      const std::vector<std::string>& arguments) const {
  std::optional<Keep> keep;
  if (keep_given_->count() > 0) keep = keep_ == "all" ? Keep::all : Keep::best;
  for_option("--store", [&] {
    store.emplace(file_, store_description(planned, arguments), planned.options.shard, keep);
  });
}

Checkpoint StoreFlags::checkpoint(ExplorationStore& store) const {
  return checkpoint_in(store, std::chrono::seconds(seconds_));
}

}  // namespace reeve::cli
