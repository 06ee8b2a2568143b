#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/api.hpp"
#include "cli/command_line.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/explore_merged.hpp"
#include "cli/exploration_files.hpp"
#include "cli/inputs.hpp"
#include "cli/outputs.hpp"
#include "cli/printing.hpp"
#include "core/error.hpp"
#include "core/input_file.hpp"
#include "reports/exploration/explored_folder.hpp"
#include "reports/exploration/shard_file.hpp"
#include "reports/exploration/store_description.hpp"

namespace reeve::cli {
namespace {

constexpr std::size_t most_bytes = std::size_t{1} << 30;

struct MergeFlags {
  std::vector<std::string> folders;
  std::string out;
  int threads = 0;
  FormatOption format;
};

ShardFile read_shard(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "shard.json";
  std::error_code ignored;
  if (std::filesystem::is_directory(folder, ignored) && !std::filesystem::exists(file, ignored)) {
    throw InputError({.where = folder.string(),
                      .what = "there is no shard.json",
                      .expected = "the folder of an exploration with --shard",
                      .form = InputForm::unknown});
  }
  ShardFile shard = read_shard_json(
      read_input(file, most_bytes, "the shard.json of an exploration"), file.string());
  summary_of_one_exploration(folder);
  return shard;
}

// A store may hold several.
void add_shards(const std::filesystem::path& place, std::vector<ShardFile>& shards) {
  if (place.empty()) {
    throw InputError({.where = "''",
                      .what = "it is no name",
                      .expected = "that of a folder of explore --shard, or of a store",
                      .form = InputForm::unknown});
  }
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(place, ignored)) {
    shards.push_back(read_shard(place));
    return;
  }
  append(shards, shard_files(StoreReader(place), place.string()));
}

// Its own files would be written over, and with them what it can be merged from.
void require_not_a_shard(const MergeFlags& flags) {
  for (const std::string& folder : flags.folders) {
    std::error_code ignored;
    if (!std::filesystem::equivalent(flags.out, folder, ignored)) continue;
    throw InputError({.what = "--out",
                      .value = flags.out,
                      .expected = "another folder than those that are put together"});
  }
}

std::vector<ShardFile> read_shards(const MergeFlags& flags) {
  std::vector<ShardFile> shards;
  for (const std::string& place : flags.folders) add_shards(place, shards);
  require_all_shards(shards);
  // Spelled as the first was asked for, in whichever order they are named.
  std::ranges::sort(shards, {}, [](const ShardFile& file) { return file.shard.index; });
  return shards;
}

// All that was read of them.
std::vector<InputFile> places(const MergeFlags& flags) {
  std::vector<InputFile> places;
  for (const std::string& place : flags.folders) {
    std::error_code ignored;
    if (!std::filesystem::is_directory(place, ignored)) {
      places.push_back({place, "the store"});
      continue;
    }
    for (const std::string& file : exploration_files()) {
      places.push_back({std::filesystem::path(place) / file, "the shard in " + place});
    }
  }
  return places;
}

// Returns the options that the exploration takes.
std::vector<std::string> here(const MergeFlags& flags) {
  return {"--out=" + flags.out, fmt::format("--threads={}", flags.threads),
          "--format=" + flags.format.format};
}

int run(const MergeFlags& flags, const CLI::App&) {
  require_not_a_shard(flags);
  return explore_merged(read_shards(flags), here(flags), places(flags));
}

void add_options(CLI::App& command, MergeFlags& flags) {
  command
      .add_option("folders", flags.folders,
                  "Folders of explore --shard i/N --out, or stores of --store, all N in any "
                  "order")
      ->required();
  command.add_option("--out", flags.out, "Folder for the files of the whole exploration")
      ->required();
  add_threads(command, flags.threads);
  flags.format.add_to(command, with_tables({"json"}));
}

constexpr Subcommand<MergeFlags> merge_command{
    "merge", "Join the shards of an exploration into one exploration", add_options, run};

}  // namespace

void add_merge(CLI::App& program, int& exit_code) { merge_command.add_to(program, exit_code); }

api::MergedExploration api::merge(const Arguments& arguments, const StudySupervision& supervision) {
  const auto parsed = merge_command.parsed(arguments);
  const std::vector<ShardFile> shards = read_shards(parsed.flags());
  return {merged_exploration(shards, here(parsed.flags()), supervision), shards.front().arguments};
}

void api::write(const MergedExploration& merged, const Arguments& arguments) {
  const auto parsed = merge_command.parsed(arguments);
  require_not_a_shard(parsed.flags());
  write_merged(merged.report, merged.arguments, here(parsed.flags()), places(parsed.flags()));
}

}  // namespace reeve::cli
