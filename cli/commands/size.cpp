#include "sizing/size.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "cli/api.hpp"
#include "cli/command_line.hpp"
#include "cli/commands/commands.hpp"
#include "cli/flags/ranking_flags.hpp"
#include "cli/flags/table_flags.hpp"
#include "cli/hand_inputs.hpp"
#include "cli/inputs.hpp"
#include "cli/outputs.hpp"
#include "cli/printing.hpp"
#include "cli/supervision.hpp"
#include "core/error.hpp"
#include "core/graph.hpp"
#include "core/hand_pulls.hpp"
#include "core/notation.hpp"
#include "pages/pages.hpp"
#include "pages/shell/result_files.hpp"
#include "reports/exploration/explored_folder.hpp"
#include "reports/jam_words.hpp"
#include "reports/model_text.hpp"
#include "reports/output/files.hpp"
#include "reports/sizing_report.hpp"
#include "studies/sizing_study.hpp"

namespace reeve::cli {
namespace {

struct SizeFlags {
  std::vector<std::string> routings;
  TextOption from;
  std::size_t top = 20;
  std::vector<std::string> vary;
  std::vector<std::string> equal;
  std::string goal = "uniformity*efficiency";
  TextOption target;
  TextOption grasps{"single"};
  TextOption score{"authors"};
  bool nominal = false;
  SizingOptions search;  // draws, seed, starts, evaluations, threads
  TextOption save;
  OutOption out;
  ModelOption model;
  TableFlags tables;
  FormatOption format;
};

void add_goal(CLI::App& command, SizeFlags& flags) {
  CLI::Option* goal = add_with_default(
      command, "--goal", flags.goal,
      "Goal: an objective, a product such as uniformity_worst*efficiency_worst, or "
      "score (of --score)");
  flags.target
      .add(command, "--target",
           "In place of a goal: ratio of the fingers' pulls, such as 1=2,others=1")
      ->excludes(goal);
  flags.score.add(command, "--score", "For --goal score: objectives with weights");
  flags.grasps.add(command, "--grasps", "Grasps as in rank; the default for --target is none held");
}

void add_search(CLI::App& command, SizeFlags& flags) {
  SizingOptions& search = flags.search;
  CLI::Option* nominal =
      command.add_flag("--nominal", flags.nominal,
                       "Size for the nominal coefficients, not for the 5 % quantile over their "
                       "ranges");
  add_with_default(command, "--draws", search.draws, "Number of draws of the coefficients")
      ->excludes(nominal)
      ->check(CLI::Range(std::size_t{1}, std::size_t{10000}));
  add_with_default(command, "--seed", search.seed, "Seed of the draws and of the starts")
      ->check(is_seed);
  add_with_default(command, "--starts", search.starts,
                   "Number of local searches besides the global one")
      ->check(CLI::Range(1, 1000));
  add_with_default(command, "--evaluations", search.evaluations,
                   "Greatest number of evaluations in each search")
      ->check(CLI::Range(10, 1000000));
  add_threads(command, search.threads);
}

void add_options(CLI::App& command, SizeFlags& flags) {
  command.add_option("routing", flags.routings, "Catalogue names or words");
  flags.from.add(command, "--from", "Folder of an exploration, whose best designs are sized too")
      ->check(names_a_file);
  add_with_default(command, "--top", flags.top, "Number of designs of --from")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1000}))
      ->needs(flags.from.option);
  command
      .add_option("--vary", flags.vary,
                  "Vary, as X=3..9: sheath_angle tip_angle strand_mm closing arm_mm contact_angle "
                  "motor_side_mm hand_mm")
      ->allow_extra_args(false);
  command
      .add_option("--equal", flags.equal,
                  "Dimensions that stay equal: tips, sheaths, strands, arms, or "
                  "'sheath_angle[2,3,4]'; may be repeated")
      ->allow_extra_args(false);
  add_goal(command, flags);
  add_search(command, flags);
  flags.save.add(command, "--save-hardware", "TOML file for the sized hardware");
  flags.out.add_to(command, "a page, index.html, with sizing.json and figures/");
  flags.model.add_with_friction_to(command);
  flags.tables.add_to(command, "the dimensions or routings");
  flags.format.add_to(command, with_tables({"json"}));
}

std::vector<Routing> read_routings(const SizeFlags& flags, const Catalogue& catalogue) {
  std::vector<Routing> routings;
  for (const std::string& text : flags.routings) {
    routings.push_back(read_actuated_routing(text, catalogue));
  }
  if (flags.from.is_given()) {
    for (Routing& routing :
         for_option("--from", [&] { return explored_designs(flags.from.text, flags.top); })) {
      for_option("--from", [&] { require_actuated(expand(routing), to_word(routing)); });
      routings.push_back(std::move(routing));
    }
    for_option("--from", [&] { return summary_of_one_exploration(flags.from.text); });
  }
  if (routings.empty()) {
    throw InputError({.where = "size",
                      .what = "nothing to size",
                      .expected = "routings, or --from with the folder of an exploration",
                      .form = InputForm::unknown});
  }
  return routings;
}

void require_comparable(const std::vector<Routing>& routings) {
  GivenRoutings given;
  const int fingers = finger_count(routings.front());
  for (const Routing& routing : routings) {
    const std::string word = to_word(routing);
    const std::string where = fmt::format("routing '{}'", word);
    const int own = finger_count(routing);
    if (own == 0) {
      throw InputError(
          {.where = where, .what = "it has no fingers, so there is nothing to size it for"});
    }
    if (own != fingers) {
      throw InputError(
          {.where = where,
           .what = fmt::format("it has {} finger{}", own, own == 1 ? "" : "s"),
           .expected = fmt::format("as many as '{}' has: {}", to_word(routings.front()), fingers)});
    }
    given.add(routing);
  }
}

// Bounds of the command line replace those of the file, so that a file can be tried with others.
void read_bounds(const SizeFlags& flags, const VaryTable& table, SizingOptions& options) {
  for (const std::string& text : flags.vary) {
    options.varied.push_back(for_name("--", [&] { return parse_varied(text); }));
    options.varied.back().text.insert(0, "--");
  }
  for (const std::string& text : flags.equal) {
    for (EqualGroup& group : for_name("--", [&] { return parse_equal(text); })) {
      group.text.insert(0, "--");
      options.equal.push_back(std::move(group));
    }
  }
  if (flags.vary.empty()) {
    read_vary({table.bounds, flags.equal.empty() ? table.equal : std::vector<GivenEqual>{}},
              options);
  }
  if (options.varied.empty()) {
    throw InputError({.where = "size",
                      .what = "nothing to vary",
                      .expected = "--vary, such as --vary sheath_angle=3..9, or [vary] in the "
                                  "hardware file; reeve show says what motor the hand needs as it "
                                  "is",
                      .form = InputForm::unknown});
  }
}

bool counts_score(const Goal& goal) {
  return std::ranges::find(goal.factors, Objective::score) != goal.factors.end();
}

// Weights that nothing asks for would be passed over.
void require_score_to_count(const SizeFlags& flags, const Goal& goal) {
  if (!flags.score.is_given() || counts_score(goal)) return;
  throw InputError({.what = "--score",
                    .value = flags.score.text,
                    .expected = "--goal score with it; the goal is another"});
}

SizingOptions read_options(const SizeFlags& flags, const ModelFile& file,
                           const std::vector<Routing>& routings) {
  const int fingers = finger_count(routings.front());
  SizingOptions options = flags.search;
  options.nominal = file.model;
  options.ranges = file.uncertainty;
  options.robust = !flags.nominal;
  const bool targeted = flags.target.is_given();
  options.grasps = for_name("--", [&] { return grasps_of(flags.grasps.text, routings); });
  // A target is of all fingers that close; with one held, friction in it turns.
  if (targeted && !flags.grasps.is_given()) {
    options.target_grasps = parse_grasps("none", fingers);
  }
  options.score = for_name("--", [&] { return parse_score(flags.score.text); });
  options.goal = for_name("--", [&] {
    return targeted ? parse_target(flags.target.text, fingers) : parse_goal(flags.goal);
  });
  require_score_to_count(flags, options.goal);
  require_hand_for("--goal", options.goal.factors, options.nominal.hardware);
  if (counts_score(options.goal)) {
    require_hand_for("--score", options.score, options.nominal.hardware);
  }
  read_bounds(flags, file.vary, options);
  return options;
}

std::vector<std::string> notes(const SizeFlags& flags, const SizingOptions& options,
                               const std::vector<Routing>& routings) {
  std::vector<std::string> notes;
  if (options.robust) {
    notes = range_notes(effective_hardware(options.nominal), options.ranges);
    append(notes, undrawn_notes(options.nominal.hardware, looks_at(routings)));
  }
  std::vector<Network> networks;
  for (const Routing& routing : routings) networks.push_back(expand(routing));
  append(notes, model_notes(options.nominal, networks));
  const auto is_several = [](const Network& network) { return motor_groups(network).count > 1; };
  if (std::ranges::any_of(networks, is_several)) notes.emplace_back(motors_together_note);
  if (!flags.from.is_given()) return notes;
  const std::string differing = differing_settings(summary_of_one_exploration(flags.from.text),
                                                   options.nominal, options.grasps);
  if (differing.empty()) return notes;
  notes.insert(notes.begin(),
               fmt::format("the exploration in {} was made with other settings than these: {}",
                           flags.from.text, differing));
  return notes;
}

// Reads columns of the dimensions, or of the sized routings: whichever table has the first.
std::vector<std::string> read_columns(const SizeFlags& flags, const Hardware& hardware) {
  std::vector<std::string> known = dimension_column_names();
  const std::vector<std::string> of_routings = sized_column_names(hardware);
  const std::string first =
      flags.tables.columns.text.substr(0, flags.tables.columns.text.find(','));
  if (std::ranges::find(of_routings, first) != of_routings.end()) {
    known = of_routings;
  } else if (std::ranges::find(known, first) == known.end()) {
    known.insert(known.end(), of_routings.begin(), of_routings.end());
  }
  return flags.tables.read_columns(flags.format, known).chosen;
}

void print(const SizingReport& report, const SizeFlags& flags,
           const std::vector<std::string>& columns) {
  std::cout << (flags.format.is("json")
                    ? sizing_json(report)
                    : flags.tables.printed(sizing_document(report, columns), flags.format));
  if (flags.save.is_given() && flags.format.is("table")) {
    std::cout << "\nHardware file: " << flags.save.text << '\n';
  }
}

void write_page(const SizingReport& report, const std::filesystem::path& folder,
                const std::string& command) {
  write_result(folder, sizing_page(report, command), {"sizing.json", sizing_json(report)});
}

std::vector<InputFile> inputs_of(const SizeFlags& flags) {
  std::vector<InputFile> inputs;
  flags.model.list_in(inputs);
  if (!flags.from.is_given()) return inputs;
  for (const char* file : {"designs.csv", "summary.json", "index.html"}) {
    inputs.push_back({std::filesystem::path(flags.from.text) / file, "what is sized"});
  }
  return inputs;
}

void require_places(const SizeFlags& flags) {
  std::vector<InputFile> inputs = inputs_of(flags);
  flags.save.claim("--save-hardware", inputs);
  flags.out.require_apart_from(inputs);
}

std::string sizing_command(const CLI::App& command) {
  return command_line(command, {"--format", "--threads", "--columns", "--text-width"});
}

// Everything that is given, before anything is written or takes long.
struct SizeInputs {
  Catalogue catalogue;
  std::vector<Routing> routings;
  SizingOptions options;
  VaryTable vary;
  std::vector<std::string> columns;
};

Document shortest_document(const SizeInputs& inputs) {
  return sizing_document(planned_sizing(inputs.routings, inputs.options, inputs.catalogue),
                         inputs.columns);
}

SizeInputs read(const SizeFlags& flags) {
  SizeInputs inputs;
  inputs.catalogue = shipped_catalogue();
  inputs.routings = read_routings(flags, inputs.catalogue);
  require_comparable(inputs.routings);
  ModelFile file = flags.model.read(inputs.catalogue);
  Hardware& hardware = file.model.hardware;
  require_hardware_to_fit(hardware, inputs.routings);
  flags.model.friction().require_to_act(hardware, looks_at(inputs.routings));
  inputs.options = read_options(flags, file, inputs.routings);
  inputs.vary = file.vary;
  require_ranges_to_match(inputs.routings, hardware, inputs.options.varied, inputs.options.equal);
  inputs.columns = read_columns(flags, hardware);
  flags.tables.require_width(flags.format);
  flags.tables.require_room(flags.format, [&] { return shortest_document(inputs); });
  return inputs;
}

SizingReport sized(const SizeFlags& flags, const SizeInputs& inputs,
                   const StudySupervision& supervision) {
  SizingReport report =
      sizing_study(inputs.routings, inputs.options, inputs.catalogue, supervision);
  report.notes = notes(flags, inputs.options, inputs.routings);
  return report;
}

int run(const SizeFlags& flags, const CLI::App& command) {
  const SizeInputs inputs = read(flags);
  require_places(flags);
  if (flags.out.is_given()) flags.out.prepare();
  SizingReport report = supervised(
      [&](const StudySupervision& supervision) { return sized(flags, inputs, supervision); });
  if (flags.save.is_given()) {
    write_file(flags.save.text, sized_hardware_toml(report, inputs.vary));
  }
  if (flags.out.is_given()) {
    report.details = sizing_details(report, inputs.catalogue);
    write_page(report, flags.out.text, sizing_command(command));
  }
  print(report, flags, inputs.columns);
  if (flags.out.is_given()) {
    std::cout << announced("index.html, sizing.json and figures", flags.out.text, flags.format);
  }
  if (report.partial) return interrupted;
  return best_meets_target(report) ? done : answer_is_no;
}

constexpr Subcommand<SizeFlags> size_command{
    "size", "Choose the dimensions of a routing that are best for a goal, with their tolerances",
    add_options, run};

}  // namespace

void add_size(CLI::App& program, int& exit_code) { size_command.add_to(program, exit_code); }

SizingReport api::size(const Arguments& arguments, const StudySupervision& supervision) {
  const auto parsed = size_command.parsed(arguments);
  return sized(parsed.flags(), read(parsed.flags()), supervision);
}

void api::write(SizingReport report, const Arguments& arguments) {
  const auto parsed = size_command.parsed(arguments);
  require_places(parsed.flags());
  report.details = sizing_details(report, shipped_catalogue());
  write_page(report, parsed.flags().out.prepare(), sizing_command(parsed.command()));
}

std::string api::hardware_toml(const SizingReport& report, const Arguments& arguments) {
  const auto parsed = size_command.parsed(arguments);
  return sized_hardware_toml(report, parsed.flags().model.read(shipped_catalogue()).vary);
}

}  // namespace reeve::cli
