#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/api.hpp"
#include "cli/command_line.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/explore_merged.hpp"
#include "cli/exploration_files.hpp"
#include "cli/flags/explore_flags.hpp"
#include "cli/inputs.hpp"
#include "cli/launched.hpp"
#include "cli/outputs.hpp"
#include "cli/printing.hpp"
#include "cli/supervision.hpp"
#include "core/error.hpp"
#include "core/hand.hpp"
#include "reports/exploration/design_list.hpp"
#include "reports/exploration/explore_report.hpp"
#include "reports/exploration/shard_file.hpp"
#include "reports/exploration/tradeoff_report.hpp"
#include "reports/output/files.hpp"
#include "search/uncertainty/uncertainty.hpp"
#include "studies/exploration_study.hpp"
#include "studies/ranks.hpp"

namespace reeve::cli {
namespace {

// Everything that is given, before anything is written or takes long.
struct ExploreInputs {
  Catalogue catalogue;
  ExploreOptions options;
  UncertaintyOptions drawn;
  std::optional<UncertaintyOptions> uncertainty;
  std::optional<CoefficientRange> over;
  std::optional<SizingOptions> target;
  ListColumns columns;
};

ExploreReport planned(const ExploreInputs& inputs) {
  ExploreReport report = planned_report(inputs.options, inputs.uncertainty, inputs.catalogue);
  report.sweep_over = inputs.over;
  if (inputs.target) report.target_shares = inputs.target->goal.target;
  return report;
}

// With none of the catalogue's routings, which may not be among them.
Document shortest_document(const ExploreInputs& inputs, const ListedWith& with) {
  ExploreReport report = planned(inputs);
  report.top = {shortest_line("M-1-F", inputs.options.order, with)};
  report.front = report.top;
  report.tradeoff =
      shortest_tradeoff(report.top.front(), inputs.options.order, inputs.options.tradeoff);
  return explore_document(report, inputs.columns);
}

ExploreInputs read(const ExploreFlags& flags) {
  ExploreInputs inputs;
  inputs.catalogue = shipped_catalogue();
  const ModelFile file = flags.model.read(inputs.catalogue);
  inputs.options = flags.read(file.model, inputs.catalogue);
  inputs.drawn = flags.read_uncertainty(file, inputs.options);
  inputs.target = flags.read_target(file, inputs.options);
  const ListedWith with{inputs.options.prices.has_value(), hand(file.model.hardware).has_value(),
                        flags.ranking.uncertainty, !inputs.options.constraints.empty()};
  inputs.columns =
      flags.tables.read_columns(flags.format, list_column_names(with), missing_columns(with));
  flags.tables.require_width(flags.format);
  if (flags.ranking.uncertainty) {
    validate(inputs.drawn, flags.top);
    inputs.uncertainty = inputs.drawn;
  }
  inputs.over = flags.sweep.read();
  require_sweep(inputs.over, inputs.drawn, flags.ranking.uncertainty,
                [&](ValueUse& use) { look_at(inputs.options.generator, use); });
  flags.tables.require_room(flags.format, [&] { return shortest_document(inputs, with); });
  return inputs;
}

// The store in which the exploration continues and is saved; nothing without --store.
class OpenedStore {
 public:
  OpenedStore(const ExploreFlags& flags, const CLI::App& command, const ExploreInputs& inputs)
      : flags_(flags) {
    if (flags.store.is_given()) {
      flags.store.open(store_, planned(inputs), explore_arguments(command));
    }
  }

  Checkpoint checkpoint() { return store_ ? flags_.store.checkpoint(*store_) : Checkpoint{}; }

 private:
  const ExploreFlags& flags_;
  std::optional<ExplorationStore> store_;
};

ExploreReport made(const ExploreInputs& inputs, const std::vector<ShardRecord>& records,
                   const Checkpoint& checkpoint, const StudySupervision& supervision,
                   const Searcher& search = {}) {
  ExploreReport report = records.empty()
                             ? exploration_study(inputs.options, inputs.uncertainty,
                                                 inputs.catalogue, supervision, checkpoint, search)
                             : merged_study(inputs.options, inputs.uncertainty, records,
                                            inputs.catalogue, supervision);
  add_motor(report, inputs.drawn);
  if (inputs.target) report.target_shares = inputs.target->goal.target;
  if (inputs.target && !report.result.partial) {
    report.target = target_study(inputs.options, *inputs.target, inputs.catalogue, supervision);
  }
  if (inputs.over) {
    add_sweep(report, {inputs.drawn, inputs.uncertainty.has_value(), *inputs.over}, supervision);
  }
  return report;
}

std::vector<ShardRecord> records_of(const std::vector<ShardFile>& shards,
                                    const ExploreInputs& inputs) {
  std::vector<ShardRecord> records;
  for (const ShardFile& shard : shards) {
    require_same_exploration(shard, planned(inputs));
    records.push_back(shard.record);
  }
  return records;
}

// `inputs`: what is read besides what the options name.
void prepare_folder(const ExploreFlags& flags, std::vector<InputFile> inputs) {
  flags.model.list_in(inputs);
  flags.tradeoff.prices.list_in(inputs, "the prices");
  flags.store.list_in(inputs);
  require_no_input_in(flags.out, inputs);
  prepare_directory(flags.out, "--out");
  // Better now than after hours.
  const std::filesystem::path out = flags.out;
  for (const std::string& file : exploration_files()) {
    require_file_can_be_written(out / file, "--out");
  }
  require_folder_can_be_written(out / "figures", "--out");
}

void write(const ExploreReport& report, const ExploreFlags& flags, const CLI::App& command,
           const std::vector<InputFile>& shards = {}) {
  prepare_folder(flags, shards);
  write_exploration(report, command, shipped_catalogue(), flags.details, flags.out);
}

[[noreturn]] void refuse_to_keep_all() {
  throw InputError({.what = "--keep",
                    .value = "all",
                    .expected = "best under mpirun, where every design would pass through one "
                                "process; --shard with a store for each keeps all"});
}

// The launcher ends the processes by SIGTERM, also if one of them has died.
void require_all_present(const ExploreReport& report, const ExploreFlags& flags) {
  if (!was_terminated() || partial_note(report).empty()) return;
  const std::string why = "one of the processes died, or all were ended from outside; ";
  throw Interrupted(why + (flags.store.is_given() ? "the same command goes on where the store ends"
                                                  : "nothing was written"));
}

// The output is the same for one exploration, for its shards, and for one that several processes
// search for.
int run(const ExploreInputs& inputs, const ExploreFlags& flags, const CLI::App& command,
        const std::vector<ShardRecord>& records, const std::vector<InputFile>& shards,
        const Searcher& shared = {}) {
  prepare_folder(flags, shards);
  OpenedStore store(flags, command, inputs);
  const Checkpoint checkpoint = store.checkpoint();
  if (shared && checkpoint.design) refuse_to_keep_all();
  const ExploreReport report = supervised([&](const StudySupervision& supervision) {
    return made(inputs, records, checkpoint, supervision, shared);
  });
  if (shared) require_all_present(report, flags);
  write_exploration(report, command, inputs.catalogue, flags.details, flags.out);
  std::cout << (flags.format.is("json")
                    ? explore_summary_json(report)
                    : flags.tables.printed(explore_document(report, inputs.columns), flags.format));
  std::cout << announced(
      fmt::format("index.html, designs.csv, pareto.csv, sample.csv, tradeoff.csv, {}{}summary.json "
                  "and figures",
                  report.sweep ? "sweep.csv, " : "", report.result.record ? "shard.json, " : ""),
      flags.out, flags.format);
  if (!partial_note(report).empty()) return interrupted;
  const bool any_was_actuated = report.result.evaluated + report.result.without_tensions.count > 0;
  // A shard may have none that is actuated where the whole has some.
  const bool may_answer = any_was_actuated || !report.result.record;
  const bool none_is_left = may_answer && report.top.empty();
  return none_is_left || misses_target(report.target) ? answer_is_no : done;
}

// The command that the shards are parts of. How their own lists were shown is no part of it.
ParsedExplore parsed_merge(std::vector<std::string> arguments, const std::vector<std::string>& here,
                           const std::string& name) {
  std::erase_if(arguments, [](const std::string& argument) {
    return argument.starts_with("--columns=") || argument.starts_with("--text-width=");
  });
  arguments.insert(arguments.end(), here.begin(), here.end());
  return {arguments, name};
}

ParsedExplore parsed_merge(const std::vector<ShardFile>& shards,
                           const std::vector<std::string>& here) {
  return parsed_merge(shards.front().arguments, here, shards.front().name);
}

ExploreInputs read_by(const Processes& processes, const ExploreFlags& flags) {
  ExploreInputs inputs = read(flags);
  inputs.options.threads = threads_of_one(processes, inputs.options.threads);
  return inputs;
}

constexpr RecordText as_json{record_json, read_record_json};

// The first of several processes does all that one alone would do; the others search for it.
int lead(const ExploreFlags& flags, const CLI::App& command, Processes& processes) {
  stop_on_interrupt();  // also of what comes before the search
  Leader leader(processes, was_terminated());
  const ExploreInputs inputs = read_by(processes, flags);
  if (flags.store.asks_for_all()) refuse_to_keep_all();
  return run(inputs, flags, command, {}, {},
             leader.search(exploration_id(planned(inputs)), as_json));
}

int follow(const ExploreFlags& flags, Processes& processes) {
  leave_interrupts_to_others();
  Follower follower(processes);
  try {
    const ExploreInputs inputs = read_by(processes, flags);
    follower.follow(inputs.options, exploration_id(planned(inputs)), as_json);
  } catch (const std::exception& failure) {
    follower.report_failure(failure);
  }
  follower.go_home();
  return done;
}

int run_launched(const ExploreFlags& flags, const CLI::App& command) {
  if (launched().size == 1) return run(read(flags), flags, command, {}, {});
  const std::unique_ptr<Processes> processes = connected();
  return processes->rank() == 0 ? lead(flags, command, *processes) : follow(flags, *processes);
}

void add_options(CLI::App& command, ExploreFlags& flags) { flags.add_to(command); }

constexpr Subcommand<ExploreFlags> explore_command{
    "explore", "Enumerate, evaluate and rank all routings of a set of parts", add_options,
    run_launched};

}  // namespace

void add_explore(CLI::App& program, int& exit_code) { explore_command.add_to(program, exit_code); }

ExploreReport api::explore(const Arguments& arguments, const StudySupervision& supervision) {
  const auto parsed = explore_command.parsed(arguments);
  const ExploreInputs inputs = read(parsed.flags());
  OpenedStore store(parsed.flags(), parsed.command(), inputs);
  return made(inputs, {}, store.checkpoint(), supervision);
}

void api::write(const ExploreReport& report, const Arguments& arguments) {
  const auto parsed = explore_command.parsed(arguments);
  cli::write(report, parsed.flags(), parsed.command());
}

ExploreReport merged_exploration(const std::vector<ShardFile>& shards,
                                 const std::vector<std::string>& here,
                                 const StudySupervision& supervision) {
  const ParsedExplore explore = parsed_merge(shards, here);
  const ExploreInputs inputs = read(explore.flags);
  return made(inputs, records_of(shards, inputs), {}, supervision);
}

void write_merged(const ExploreReport& report, const std::vector<std::string>& arguments,
                  const std::vector<std::string>& here, const std::vector<InputFile>& places) {
  const ParsedExplore explore = parsed_merge(arguments, here, "merge");
  write(report, explore.flags, explore.command, places);
}

int explore_merged(const std::vector<ShardFile>& shards, const std::vector<std::string>& here,
                   const std::vector<InputFile>& places) {
  const ParsedExplore explore = parsed_merge(shards, here);
  const ExploreInputs inputs = read(explore.flags);
  return run(inputs, explore.flags, explore.command, records_of(shards, inputs), places);
}

}  // namespace reeve::cli
