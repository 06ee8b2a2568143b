#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iostream>
#include <set>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/inputs.hpp"
#include "cli/printing.hpp"
#include "cli/supervision.hpp"
#include "core/canonical.hpp"
#include "core/error.hpp"
#include "core/notation.hpp"
#include "reports/rank_report.hpp"
#include "search/evaluation.hpp"
#include "search/margin.hpp"
#include "search/uncertainty.hpp"

namespace reeve::cli {
namespace {

struct RankFlags {
  std::vector<std::string> routings;
  bool catalog = false;
  int fingers = 2;
  bool margin = false;
  RankingFlags ranking;
  ModelOption model;
  FormatOption format;
};

std::vector<Routing> routings(const RankFlags& flags, const Catalogue& catalogue) {
  std::vector<Routing> result;
  for (const std::string& text : flags.routings) {
    result.push_back(read_actuated_routing(text, catalogue));
  }
  if (flags.catalog) {
    const int fingers = result.empty() ? flags.fingers : finger_count(result.front());
    for (const CatalogueEntry& entry : catalogue.entries) {
      if (finger_count(entry.routing) == fingers) result.push_back(entry.routing);
    }
  }
  if (result.empty()) {
    throw InputError("rank: nothing to rank; expected routings, or --catalog");
  }
  std::set<std::string> words;
  for (const Routing& routing : result) {
    const std::string word = to_word(routing);
    if (finger_count(routing) == 0) {
      throw InputError(
          fmt::format("routing '{}': it has no fingers, so there is nothing to rank", word));
    }
    if (finger_count(routing) != finger_count(result.front())) {
      throw InputError(fmt::format(
          "routing '{}': it has {} finger{} and '{}' has {}; only routings with the same number of "
          "fingers can be compared",
          word, finger_count(routing), finger_count(routing) == 1 ? "" : "s",
          to_word(result.front()), finger_count(result.front())));
    }
    if (!words.insert(to_word(canonical(routing, FingerIdentity::distinct))).second) {
      throw InputError(fmt::format("routing '{}' is given twice", word));
    }
  }
  return result;
}

// Otherwise the first design need not have the greatest product, and a lead says nothing.
void require_the_two_means(std::vector<Objective> objectives) {
  std::sort(objectives.begin(), objectives.end());
  if (objectives == std::vector{Objective::uniformity_mean, Objective::efficiency_mean}) return;
  throw InputError(
      "--margin is a lead in mean uniformity x mean efficiency: expected --objectives "
      "uniformity,efficiency with it");
}

int run(const RankFlags& flags) {
  const Catalogue catalogue = shipped_catalogue();
  const std::vector<Routing> given = routings(flags, catalogue);
  const auto [model, uncertainty] = flags.model.read();
  require_contacts_to_match(model.hardware, given);
  RankReport report;
  report.objectives = parse_objectives(flags.ranking.objectives);
  if (flags.margin) require_the_two_means(report.objectives);
  report.grasps = flags.ranking.read_grasps(finger_count(given.front()));
  report.model = model;
  DesignEvaluator evaluator(model, report.grasps);
  std::vector<Design> designs;
  for (const Routing& routing : given) {
    designs.push_back({to_word(routing), evaluator.evaluate(routing)});
  }
  report.unconverged = evaluator.unconverged();
  const std::vector<RankedDesign> ranked = rank(designs, report.objectives);
  std::vector<RankDistribution> distributions;
  if (flags.ranking.uncertainty) {
    report.uncertainty = UncertaintyOptions{model,
                                            uncertainty,
                                            report.grasps,
                                            report.objectives,
                                            flags.ranking.draws,
                                            flags.ranking.seed,
                                            flags.ranking.threads};
    ProgressLine progress("drawing");
    const auto drawn = rank_distributions(plain_designs(ranked), *report.uncertainty,
                                          {std::ref(progress), &stop_on_interrupt()});
    if (!drawn) throw Interrupted();
    distributions = *drawn;
  }
  if (flags.margin) {
    MarginOptions options{model, uncertainty, report.grasps};
    options.threads = flags.ranking.threads;
    report.margins = margins(ranked, options, {{}, &stop_on_interrupt()});
    if (!report.margins) throw Interrupted();
  }
  report.designs = list_designs(ranked, distributions, catalogue);
  if (flags.format.is("json")) {
    std::cout << rank_json(report);
  } else if (flags.format.is("csv")) {
    std::cout << design_csv(report.designs);
  } else {
    std::cout << printed(rank_sheet(report), flags.format);
  }
  return done;
}

}  // namespace

void add_rank(CLI::App& program, int& exit_code) {
  CLI::App* command =
      program.add_subcommand("rank", "Compare routings that you have in mind, best first");
  auto flags = std::make_shared<RankFlags>();
  command->add_option("routing", flags->routings, "Catalogue names or words");
  command->add_flag("--catalog", flags->catalog,
                    "All routings of the catalogue with as many fingers as the routings given, or "
                    "with --fingers of them");
  command->add_option("--fingers", flags->fingers, "For --catalog alone: number of fingers")
      ->check(CLI::Range(1, max_fingers))
      ->capture_default_str();
  command->add_flag("--margin", flags->margin,
                    "Search the ranges of the coefficients for where the first design's lead over "
                    "each other one is least");
  flags->ranking.add_to(*command);
  flags->model.add_to(*command);
  flags->format.add_to(*command, with_tables({"json", "csv"}));
  command->callback([flags, &exit_code] { exit_code = run(*flags); });
}

}  // namespace reeve::cli
