#include "search/explore.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/commands/asked_command.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/explore_merged.hpp"
#include "cli/exploration_files.hpp"
#include "cli/flags/ladder_flags.hpp"
#include "cli/flags/sweep_flags.hpp"
#include "cli/flags/table_flags.hpp"
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

struct ExploreFlags {
  GeneratorFlags generator;
  RankingFlags ranking;
  LadderFlags ladder;
  SweepFlags sweep;
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

// Which contacts the routings will have is not known yet; which strands, is.
void require_fingers(const Hardware& hardware, int fingers) {
  for (const ContactHardware& contact : hardware.contacts) {
    if (highest_finger(contact) <= fingers) continue;
    throw InputError({.where = "hardware",
                      .what = "contact",
                      .value = fmt::format("{}-{}", contact.segment, contact.other_segment),
                      .expected = fmt::format("strands of fingers 1 to {}", fingers)});
  }
}

ExploreOptions options(const ExploreFlags& flags, const Model& model, const Catalogue& catalogue) {
  ExploreOptions options;
  options.generator = flags.generator.read();
  // Says early, before anything is written, if there are too many to count.
  for_option(fmt::format("--fingers {}", flags.generator.fingers),
             [&] { return RoutingGenerator(options.generator).total(); });
  require_fingers(model.hardware, options.generator.fingers);
  require_known_fingers(model.hardware, options.generator.fingers);
  options.shard = for_name("--", [&] { return parse_shard(flags.shard); });
  options.keeps_record = flags.shard_given->count() > 0;
  options.model = model;
  options.grasps = flags.ranking.read_grasps(options.generator.fingers);
  options.order = flags.ranking.read_order();
  options.score = flags.ranking.read_score();
  require_hand_for("--objectives", options.order.objectives, model.hardware);
  require_hand_for("--score", options.score, model.hardware);
  for (const std::string& text : flags.constraints) {
    const Constraint constraint = for_name("--", [&] { return parse_constraint(text); });
    require_hand_for(fmt::format("--constraint '{}'", text), {constraint.objective},
                     model.hardware);
    for (const Constraint& other : options.constraints) {
      if (other.text != constraint.text) continue;
      throw InputError(fmt::format("--constraint '{}' is given twice", constraint.text));
    }
    options.constraints.push_back(constraint);
  }
  options.prices = flags.ladder.read_prices();
  options.ladder = flags.ladder.read();
  flags.ladder.require_prices(options.order, options.score, options.constraints);
  options.top = flags.top;
  options.threads = flags.ranking.threads;
  options.references = known_routings(options.generator, catalogue);
  return options;
}

UncertaintyOptions uncertainty_options(const ExploreFlags& flags, const ModelFile& file,
                                       const ExploreOptions& options) {
  return {file.model,          file.uncertainty,   options.grasps,        options.order,
          flags.ranking.draws, flags.ranking.seed, flags.ranking.threads, options.score,
          options.prices};
}

// Everything that is given, before anything is written or takes long.
struct ExploreInputs {
  Catalogue catalogue;
  ExploreOptions options;
  UncertaintyOptions drawn;
  std::optional<UncertaintyOptions> uncertainty;
  std::optional<CoefficientRange> over;
  ListColumns columns;
};

ExploreInputs read(const ExploreFlags& flags) {
  ExploreInputs inputs;
  inputs.catalogue = shipped_catalogue();
  const ModelFile file = flags.model.read();
  inputs.options = options(flags, file.model, inputs.catalogue);
  inputs.drawn = uncertainty_options(flags, file, inputs.options);
  const ListedWith with{inputs.options.prices.has_value(), hand(file.model.hardware).has_value()};
  inputs.columns = flags.tables.read_columns(flags.format, list_column_names(with));
  flags.tables.require_width(flags.format);
  if (flags.ranking.uncertainty) {
    validate(inputs.drawn, flags.top);
    inputs.uncertainty = inputs.drawn;
  }
  inputs.over = flags.sweep.read();
  require_sweep(inputs.over, inputs.drawn, flags.ranking.uncertainty);
  return inputs;
}

ExploreReport made(const ExploreInputs& inputs, const std::vector<ShardRecord>& records,
                   const StudySupervision& supervision) {
  ExploreReport report = records.empty() ? exploration_study(inputs.options, inputs.uncertainty,
                                                             inputs.catalogue, supervision)
                                         : merged_study(inputs.options, inputs.uncertainty, records,
                                                        inputs.catalogue, supervision);
  if (inputs.over) {
    add_sweep(report, {inputs.drawn, inputs.uncertainty.has_value(), *inputs.over}, supervision);
  }
  return report;
}

void prepare_folder(const std::string& folder) {
  prepare_directory(folder, "--out");
  require_file_can_be_written(std::filesystem::path(folder) / "index.html", "--out");
}

// What is printed and written is the same of one exploration and of its shards.
int run(const ExploreFlags& flags, const CLI::App& command, const std::vector<ShardFile>& shards) {
  const ExploreInputs inputs = read(flags);
  std::vector<ShardRecord> records;
  for (const ShardFile& shard : shards) {
    ExploreReport planned = planned_report(inputs.options, inputs.uncertainty, inputs.catalogue);
    planned.sweep_over = inputs.over;
    require_same_exploration(shard, planned);
    records.push_back(shard.record);
  }
  prepare_folder(flags.out);
  const ExploreReport report = supervised(
      [&](const StudySupervision& supervision) { return made(inputs, records, supervision); });
  write_exploration(report, command, inputs.catalogue, flags.details, flags.out);
  std::cout << (flags.format.is("json")
                    ? explore_summary_json(report)
                    : flags.tables.printed(explore_sheet(report, inputs.columns), flags.format));
  std::cout << announced(
      fmt::format("index.html, designs.csv, pareto.csv, sample.csv, ladder.csv, {}{}summary.json "
                  "and figures",
                  report.sweep ? "sweep.csv, " : "", report.result.record ? "shard.json, " : ""),
      flags.out, flags.format);
  if (!partial_note(report).empty()) return interrupted;
  return report.result.unmet.empty() ? done : answer_is_no;
}

void add_options(CLI::App& command, ExploreFlags& flags) {
  flags.generator.add_to(command, true);
  flags.ranking.add_to(command);
  flags.ladder.add_to(command);
  flags.sweep.add_to(command, "the first design, those of the ladder and the front (up to 8)");
  command
      .add_option("--constraint", flags.constraints,
                  "Keep only designs with, such as 'sheaths<=2'; may be given several times")
      ->allow_extra_args(false);
  flags.shard_given =
      command
          .add_option("--shard", flags.shard,
                      "i/N: only the i-th of N parts of the whole; reeve merge puts them together")
          ->capture_default_str();
  command
      .add_option("--top", flags.top,
                  "How many of the best designs to keep; the front is always kept")
      ->check(CLI::Range(std::size_t{1}, std::size_t{100000}))
      ->capture_default_str();
  command
      .add_option("--details", flags.details,
                  "Of how many of the best designs the page holds schematics and tensions, besides "
                  "the known routings; by default as many as 170 schematics show in all grasps")
      ->check(CLI::Range(std::size_t{0}, std::size_t{100000}));
  command
      .add_option(
          "--out", flags.out,
          "Folder for index.html, designs.csv, pareto.csv, sample.csv, ladder.csv, summary.json and "
          "figures, and sweep.csv of --sweep")
      ->capture_default_str();
  flags.model.add_to(command);
  flags.tables.add_to(command, "the list of the best");
  flags.format.add_to(command, with_tables({"json"}));
}

}  // namespace

void add_explore(CLI::App& program, int& exit_code) {
  CLI::App* command = program.add_subcommand(
      "explore", "Every routing that a set of parts allows: evaluated, ranked, written to files");
  auto flags = std::make_shared<ExploreFlags>();
  add_options(*command, *flags);
  command->callback([flags, command, &exit_code] { exit_code = run(*flags, *command, {}); });
}

ExploreReport asked_exploration(const Arguments& arguments, const StudySupervision& supervision) {
  const AskedCommand<ExploreFlags> asked("explore", add_options, arguments);
  return made(read(asked.flags()), {}, supervision);
}

void write_asked(const ExploreReport& report, const Arguments& arguments) {
  const AskedCommand<ExploreFlags> asked("explore", add_options, arguments);
  prepare_folder(asked.flags().out);
  write_exploration(report, asked.command(), shipped_catalogue(), asked.flags().details,
                    asked.flags().out);
}

int explore_merged(const std::vector<ShardFile>& shards, const std::vector<std::string>& here) {
  CLI::App command("", "explore");
  ExploreFlags flags;
  add_options(command, flags);
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
