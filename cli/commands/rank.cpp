#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/api.hpp"
#include "cli/command_line.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/rank_store.hpp"
#include "cli/flags/ranking_flags.hpp"
#include "cli/flags/reading_flags.hpp"
#include "cli/flags/table_flags.hpp"
#include "cli/flags/tradeoff_flags.hpp"
#include "cli/hand_inputs.hpp"
#include "cli/inputs.hpp"
#include "cli/outputs.hpp"
#include "cli/printing.hpp"
#include "cli/ranked_routings.hpp"
#include "cli/supervision.hpp"
#include "core/error.hpp"
#include "core/hand.hpp"
#include "core/notation.hpp"
#include "pages/pages.hpp"
#include "pages/shell/result_files.hpp"
#include "reports/exploration/design_list.hpp"
#include "reports/exploration/sweep_report.hpp"
#include "reports/exploration/tradeoff_report.hpp"
#include "reports/rank_report.hpp"
#include "studies/ranking_study.hpp"
#include "studies/tension_distributions.hpp"

namespace reeve::cli {
namespace {

struct RankFlags {
  StoredRankingFlags stored;
  std::vector<std::string> routings;
  bool catalog = false;
  int fingers = 2;
  CLI::Option* fingers_given = nullptr;
  FamilyOption family;
  bool margin = false;
  OutOption out;
  TextOption data;
  ReadingFlags readings;
  std::optional<std::string> distributions;
  RankingFlags ranking;
  TradeoffFlags tradeoff;
  SweepFlags sweep;
  ModelOption model;
  TableFlags tables;
  FormatOption format;
};

// Routings that are given say how many fingers those of the catalogue have.
void require_fingers_to_count(const RankFlags& flags) {
  if (flags.fingers_given->count() == 0 || flags.routings.empty()) return;
  throw InputError(
      {.what = "--fingers",
       .value = fmt::format("{}", flags.fingers),
       .expected = "--catalogue with it, and no routings: where there are some, theirs count"});
}

AskedRoutings asked_routings(const RankFlags& flags, const Catalogue& catalogue) {
  require_fingers_to_count(flags);
  return {flags.routings, flags.catalog, flags.fingers, flags.family.read(catalogue)};
}

// Otherwise the first design need not have the greatest product, and a lead says nothing.
void require_the_two_means(Order order) {
  std::ranges::sort(order.objectives);
  const std::vector means{Objective::uniformity_mean, Objective::efficiency_mean};
  if (order.objectives == means && !order.by_score) return;
  throw InputError(
      "--margin is a lead in mean uniformity x mean efficiency: expected --objectives "
      "uniformity,efficiency with it, and no --score");
}

// Everything that is given, before anything is written or takes long.
struct RankInputs {
  Catalogue catalogue;
  std::vector<Routing> routings;
  ModelFile file;
  std::vector<FrictionCase> cases;
  std::optional<MeasuredData> data;
};

// The coefficients of the paper's figures, if they say something of this hardware.
const char* usual_cases(const Model& model) {
  const Hardware own = effective_hardware(model);
  const Hardware paper;
  const bool is_of_paper = own.tube.mu == paper.tube.mu && own.sheath.mu == paper.sheath.mu;
  return is_of_paper ? "0.18,0.09" : "model";
}

RankInputs read(const RankFlags& flags) {
  RankInputs inputs;
  inputs.catalogue = shipped_catalogue();
  const AskedRoutings asked = asked_routings(flags, inputs.catalogue);
  inputs.routings = ranked_routings(asked, inputs.catalogue);
  if (asked.family) name_by(*asked.family, inputs.catalogue);
  inputs.file = flags.model.read(inputs.catalogue);
  require_hardware_to_fit(inputs.file.model.hardware, inputs.routings);
  require_values_to_act(inputs.file.model.hardware, inputs.routings);
  require_known_fingers(inputs.file.model.hardware, finger_count(inputs.routings.front()));
  flags.model.friction().require_to_act(inputs.file.model.hardware, looks_at(inputs.routings));
  inputs.cases = read_friction_cases(flags.distributions.value_or(usual_cases(inputs.file.model)),
                                     inputs.file.model);
  if (flags.data.is_given()) {
    inputs.data = flags.readings.read(flags.data.text, inputs.catalogue);
  }
  return inputs;
}

void print(const RankReport& report, const RankFlags& flags, const ListColumns& columns) {
  const FormatOption& format = flags.format;
  if (format.is("json")) {
    std::cout << rank_json(report);
  } else if (format.is("csv")) {
    std::cout << design_csv(report.designs);
  } else {
    std::cout << flags.tables.printed(rank_document(report, columns), format);
  }
}

void write_page(const RankReport& report, const std::filesystem::path& folder,
                const CLI::App& command) {
  const std::string text =
      command_line(command, {"--format", "--threads", "--columns", "--text-width"});
  std::vector<ResultFile> tables{{"tradeoff.csv", tradeoff_csv(report.tradeoff)}};
  if (report.sweep) tables.push_back({"sweep.csv", sweep_csv(*report.sweep)});
  write_result(folder, ranking_page(report, text), {"ranking.json", rank_json(report)},
               std::move(tables));
}

RankRequest request(const RankFlags& flags, const RankInputs& inputs) {
  RankRequest request;
  request.routings = inputs.routings;
  request.model = inputs.file.model;
  request.ranges = inputs.file.uncertainty;
  request.grasps = flags.ranking.read_grasps(inputs.routings);
  request.order = flags.ranking.read_order();
  request.score = flags.ranking.read_score();
  require_hand_for("--objectives", request.order.objectives, request.model.hardware);
  require_hand_for("--score", request.score, request.model.hardware);
  if (flags.ranking.uncertainty) request.draws = Draws{flags.ranking.draws, flags.ranking.seed};
  if (flags.margin) require_the_two_means(request.order);
  request.margins = flags.margin;
  request.threads = flags.ranking.threads;
  request.prices = flags.tradeoff.read_prices();
  request.tradeoff = flags.tradeoff.read();
  flags.tradeoff.require_prices(request.order, request.score, {});
  request.sweep = flags.sweep.read();
  require_sweep(request.sweep, uncertainty_of(request), request.draws.has_value(),
                looks_at(request.routings));
  return request;
}

void require_places(const RankFlags& flags) {
  std::vector<InputFile> inputs;
  flags.model.list_in(inputs);
  flags.tradeoff.prices.list_in(inputs, "the prices");
  flags.data.list_in(inputs, "the data");
  flags.out.require_apart_from(inputs);
}

TensionDistributions distributions_of(const RankInputs& inputs) {
  return tension_distributions({inputs.routings, inputs.cases, inputs.data}, inputs.catalogue);
}

void add_distributions(RankReport& report, TensionDistributions distributions) {
  report.unconverged += distributions.unconverged;
  report.details->distributions = std::move(distributions);
}

Document shortest_document(const RankRequest& asked, const ListedWith& with,
                           const ListColumns& columns) {
  RankReport report;
  static_cast<RankSettings&>(report) = static_cast<const RankSettings&>(asked);
  if (asked.draws) report.uncertainty = uncertainty_of(asked);
  for (const Routing& routing : asked.routings) {
    report.designs.push_back(shortest_line(to_word(routing), asked.order, with));
  }
  if (report.designs.size() > 1) {
    report.tradeoff = shortest_tradeoff(report.designs.front(), asked.order, asked.tradeoff);
  }
  return rank_document(report, columns);
}

// Refuses --margin and --sweep, which take long, if no output would show them. A page has both.
void require_all_to_be_shown(const RankFlags& flags) {
  const char* asked = flags.margin ? "--margin" : flags.sweep.text.empty() ? "" : "--sweep";
  if (*asked == '\0' || flags.out.is_given()) return;
  const char* lacks = flags.format.is("csv")               ? "--format csv"
                      : !flags.tables.columns.text.empty() ? "--columns"
                                                           : "";
  if (*lacks == '\0') return;
  throw InputError({.where = asked,
                    .what = fmt::format("{} prints the ranking alone", lacks),
                    .expected = "one of the two, or --out with them for a page",
                    .form = InputForm::unknown});
}

int run(const RankFlags& flags, const CLI::App& command) {
  if (flags.stored.store.is_given()) {
    return rank_stored(command, flags.stored, flags.tables, flags.format);
  }
  require_all_to_be_shown(flags);
  const RankInputs inputs = read(flags);
  RankRequest asked = request(flags, inputs);
  asked.details = flags.out.is_given();
  const ListedWith with{asked.prices.has_value(), hand(asked.model.hardware).has_value(),
                        asked.draws.has_value()};
  const ListColumns columns =
      flags.tables.read_columns(flags.format, list_column_names(with), missing_columns(with));
  flags.tables.require_room(flags.format, [&] { return shortest_document(asked, with, columns); });
  require_places(flags);
  // First what may still refuse its input: then the folder, then what takes long.
  TensionDistributions distributions;
  if (flags.out.is_given()) {
    distributions = distributions_of(inputs);
    flags.out.prepare();
  }
  std::optional<RankReport> report = supervised([&](const StudySupervision& supervision) {
    return ranking_study(asked, inputs.catalogue, supervision);
  });
  if (!report) throw Interrupted();
  if (report->details) {
    add_distributions(*report, std::move(distributions));
    write_page(*report, flags.out.text, command);
  }
  print(*report, flags, columns);
  if (flags.out.is_given()) {
    std::cout << announced(report->sweep
                               ? "index.html, tradeoff.csv, sweep.csv, ranking.json and figures"
                               : "index.html, tradeoff.csv, ranking.json and figures",
                           flags.out.text, flags.format);
  }
  return done;
}

void add_options(CLI::App& command, RankFlags& flags) {
  command.add_option("routing", flags.routings, "Catalogue names or words");
  CLI::Option* catalog =
      command.add_flag("--catalogue", flags.catalog,
                       "All routings of one family of the catalogue that have the same number of "
                       "fingers, or --fingers");
  flags.family
      .add(command, "--family",
           "Family of --catalogue: paper, or a folder of catalog/families (default: paper)")
      ->needs(catalog);
  flags.fingers_given = add_with_default(command, "--fingers", flags.fingers,
                                         "Number of fingers, for --catalogue without routings")
                            ->needs(catalog)
                            ->check(CLI::Range(1, max_fingers));
  command.add_flag("--margin", flags.margin,
                   "Find the coefficients, within their ranges, at which the best design's lead "
                   "is least");
  CLI::Option* out =
      flags.out.add_to(command, "index.html, ranking.json, tradeoff.csv, sweep.csv and figures/");
  flags.data
      .add(command, "--data",
           "CSV file of readings to draw on the page beside the model's tensions; see docs/data.md")
      ->check(names_a_file)
      ->needs(out);
  flags.readings.add_to(command, flags.data.option);
  command
      .add_option("--distribution-mu", flags.distributions,
                  "Friction of the tension distributions on the page, or 'model' (default: "
                  "0.18,0.09, or model)")
      ->needs(out);
  flags.stored.add_to(command);
  flags.ranking.add_to(command);
  flags.tradeoff.add_to(command);
  flags.sweep.add_to(command, "the designs");
  flags.model.add_with_friction_to(command);
  flags.tables.add_to(command, "the ranking");
  flags.format.add_to(command, with_tables({"json", "csv"}));
}

constexpr Subcommand<RankFlags> rank_command{"rank", "Rank routings that you name, best first",
                                             add_options, run};

}  // namespace

void add_rank(CLI::App& program, int& exit_code) { rank_command.add_to(program, exit_code); }

std::optional<RankReport> api::rank(const Arguments& arguments,
                                    const StudySupervision& supervision) {
  const auto parsed = rank_command.parsed(arguments);
  const RankInputs inputs = read(parsed.flags());
  RankRequest wanted = request(parsed.flags(), inputs);
  wanted.details = true;
  TensionDistributions distributions = distributions_of(inputs);
  auto report = ranking_study(wanted, inputs.catalogue, supervision);
  if (report) add_distributions(*report, std::move(distributions));
  return report;
}

StoredRanking api::rank_stored(const Arguments& arguments) {
  const auto parsed = rank_command.parsed(arguments);
  return stored_ranking_of(parsed.command(), parsed.flags().stored);
}

void api::write(const RankReport& report, const Arguments& arguments) {
  const auto parsed = rank_command.parsed(arguments);
  require_places(parsed.flags());
  write_page(report, parsed.flags().out.prepare(), parsed.command());
}

}  // namespace reeve::cli
