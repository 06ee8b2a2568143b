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
      "File (SQLite, docs/store.md) that keeps what is found; the same command goes on in it");
  command
      .add_option("--store-every", seconds_,
                  "Seconds between two times that the store is written: what a kill can cost")
      ->needs(option_)
      ->check(CLI::Range(0, a_day))
      ->capture_default_str();
  keep_given_ = command
                    .add_option("--keep", keep_,
                                "What the store keeps: best, or all designs with their objectives, "
                                "so that rank can rank them otherwise")
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
