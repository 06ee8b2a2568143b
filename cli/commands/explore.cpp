#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/commands/commands.hpp"
#include "cli/commands/explore_merged.hpp"
#include "cli/exploration_files.hpp"
#include "cli/flags/explore_flags.hpp"
#include "cli/hand_inputs.hpp"
#include "cli/inputs.hpp"
#include "cli/outputs.hpp"
#include "cli/printing.hpp"
#include "cli/supervision.hpp"
#include "core/error.hpp"
#include "core/hand/hand.hpp"
#include "reports/files.hpp"
#include "reports/results/design_list.hpp"
#include "reports/results/explore_report.hpp"
#include "search/uncertainty/uncertainty.hpp"
#include "studies/exploration_study.hpp"

namespace reeve::cli {
namespace {

// What is printed and written is the same of one exploration and of its shards.
int run(const ExploreFlags& flags, const CLI::App& command, const std::vector<ShardFile>& shards) {
  const Catalogue catalogue = shipped_catalogue();
  const ModelFile file = flags.model.read();
  const ExploreOptions explore_options = flags.read(file.model, catalogue);
  const UncertaintyOptions drawn = flags.read_uncertainty(file, explore_options);
  const ListedWith with{explore_options.prices.has_value(), hand(file.model.hardware).has_value(),
                        flags.ranking.uncertainty, !explore_options.constraints.empty()};
  const ListColumns columns = flags.tables.read_columns(flags.format, list_column_names(with));
  flags.tables.require_width(flags.format);
  if (flags.ranking.uncertainty) validate(drawn, flags.top);
  const auto uncertainty = flags.ranking.uncertainty ? std::optional(drawn) : std::nullopt;
  const std::optional<CoefficientRange> over = flags.sweep.read();
  require_sweep(over, drawn, flags.ranking.uncertainty);
  std::vector<ShardRecord> records;
  ExploreReport planned = planned_report(explore_options, uncertainty, catalogue);
  planned.sweep_over = over;
  for (const ShardFile& shard : shards) {
    require_same_exploration(shard, planned);
    records.push_back(shard.record);
  }
  prepare_directory(flags.out, "--out");
  require_file_can_be_written(std::filesystem::path(flags.out) / "index.html", "--out");
  std::optional<ExplorationStore> store;
  if (flags.store.is_given()) flags.store.open(store, planned, explore_arguments(command));
  const ExploreReport report = supervised([&](const StudySupervision& supervision) {
    const Keeping keeping = store ? flags.store.keeping(*store) : Keeping{};
    ExploreReport made =
        records.empty()
            ? exploration_study(explore_options, uncertainty, catalogue, supervision, keeping)
            : merged_study(explore_options, uncertainty, records, catalogue, supervision);
    if (over) add_sweep(made, {drawn, flags.ranking.uncertainty, *over}, supervision);
    return made;
  });
  write_exploration(report, command, catalogue, flags.details, flags.out);
  std::cout << (flags.format.is("json")
                    ? explore_summary_json(report)
                    : flags.tables.printed(explore_sheet(report, columns), flags.format));
  std::cout << announced(
      fmt::format("index.html, designs.csv, pareto.csv, sample.csv, ladder.csv, {}{}summary.json "
                  "and figures",
                  report.sweep ? "sweep.csv, " : "", report.result.record ? "shard.json, " : ""),
      flags.out, flags.format);
  if (!partial_note(report).empty()) return interrupted;
  return report.result.unmet.empty() ? done : answer_is_no;
}

}  // namespace

void add_explore(CLI::App& program, int& exit_code) {
  CLI::App* command = program.add_subcommand(
      "explore", "Every routing that a set of parts allows: evaluated, ranked, written to files");
  auto flags = std::make_shared<ExploreFlags>();
  flags->add_to(*command);
  command->callback([flags, command, &exit_code] { exit_code = run(*flags, *command, {}); });
}

int explore_merged(const std::vector<ShardFile>& shards, const std::vector<std::string>& here) {
  CLI::App command("", "explore");
  ExploreFlags flags;
  flags.add_to(command);
  std::vector<std::string> arguments = shards.front().arguments;
  arguments.insert(arguments.end(), here.begin(), here.end());
  std::reverse(arguments.begin(), arguments.end());  // as CLI11 wants them
  try {
    command.parse(std::move(arguments));
  } catch (const CLI::ParseError& error) {
    throw InputError({.where = shards.front().name, .what = error.what()});
  }
  return run(flags, command, shards);
}

}  // namespace reeve::cli
