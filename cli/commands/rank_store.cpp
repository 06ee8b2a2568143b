#include "cli/commands/rank_store.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <optional>

#include "cli/command_line.hpp"
#include "cli/commands/commands.hpp"
#include "cli/flags/explore_flags.hpp"
#include "core/error.hpp"
#include "core/hand.hpp"
#include "reports/exploration/store_description.hpp"
#include "reports/exploration/stored_ranking_report.hpp"

namespace reeve::cli {
namespace {

using RankArguments = std::vector<std::string>;

// Options that may differ from those of the store.
const RankArguments askable{"--objectives", "--score", "--constraint", "--top"};
// Decides how it is shown, or how fast.
const RankArguments showing{"--columns", "--text-width", "--threads", "--format"};

bool sets(const std::string& argument, const std::string& option) {
  return argument == option || argument.starts_with(option + "=");
}

void require_nothing_else(const CLI::App& rank) {
  for (const CLI::Option* option : rank.get_options()) {
    if (option->count() == 0 || option->check_name("--store")) continue;
    if (is_among(askable, *option) || is_among(showing, *option)) continue;
    throw InputError({.where = option->get_name(),
                      .what = "a store has been evaluated already",
                      .expected =
                          "with --store only --objectives, --score, --constraint, --top and "
                          "how it is shown",
                      .form = InputForm::unknown});
  }
}

// Hardware and prices are read again, and must say the same.
ExploreOptions stored_options(const ParsedExplore& explore, const StoreReader& store,
                              const std::string& name, const Catalogue& catalogue) {
  const ModelFile file = explore.flags.model.read(catalogue);
  ExploreOptions options = explore.flags.read(file.model, catalogue);
  const auto uncertainty = explore.flags.ranking.uncertainty
                               ? std::optional(explore.flags.read_uncertainty(file, options))
                               : std::nullopt;
  ExploreReport planned = planned_report(options, uncertainty, catalogue);
  planned.sweep_over = explore.flags.sweep.read();
  if (const auto differs = difference(store.description(), store_description(planned, {}))) {
    throw InputError({.where = name,
                      .what = fmt::format("it was made by {}", *differs),
                      .expected = "what its exploration was made with",
                      .form = InputForm::unknown});
  }
  return options;
}

// Returns the arguments of the exploration, with those asked for in place of the stored ones.
RankArguments as_asked(const RankArguments& stored, const RankArguments& asked) {
  RankArguments arguments = asked;
  for (const std::string& argument : stored) {
    const bool is_asked = std::ranges::any_of(askable, [&](const std::string& option) {
      return sets(argument, option) && std::ranges::any_of(asked, [&](const std::string& other) {
               return sets(other, option);
             });
    });
    if (!is_asked) arguments.push_back(argument);
  }
  return arguments;
}

// Returns the options of `rank` that may differ and are given.
RankArguments asked_arguments(const CLI::App& rank) {
  RankArguments arguments;
  for (const std::string& argument : given_arguments(rank, showing)) {
    const bool is_asked = std::ranges::any_of(
        askable, [&](const std::string& option) { return sets(argument, option); });
    if (is_asked) arguments.push_back(argument);
  }
  return arguments;
}

struct NamedObjective {
  std::string option;
  Objective objective;
};

std::vector<NamedObjective> named_objectives(const ExploreFlags& flags) {
  std::vector<NamedObjective> named;
  for (const Objective objective : flags.ranking.read_order().objectives) {
    named.push_back({"--objectives", objective});
  }
  for (const ScoreTerm& term : flags.ranking.read_score().terms) {
    named.push_back({"--score", term.objective});
  }
  for (const Constraint& constraint : read_constraints(flags.constraints)) {
    named.push_back({fmt::format("--constraint '{}'", constraint.text), constraint.objective});
  }
  return named;
}

// Requires that the store's designs have values of the objectives that the options name. No advice
// on options is given for values that are missing.
void require_values(const ExploreFlags& asked, const ExploreOptions& stored,
                    const std::string& store) {
  for (const auto& [option, objective] : named_objectives(asked)) {
    const bool lacks_prices = objective == Objective::cost && !stored.prices;
    const bool lacks_hand = row(objective).of_hand && !hand(stored.model.hardware);
    if (!lacks_prices && !lacks_hand) continue;
    throw InputError(
        {.where = option,
         .what = fmt::format("there is no {} of the designs of {}, which was explored without {}",
                             row(objective).name, store, lacks_prices ? "prices" : "a hand"),
         .expected = lacks_prices ? "a store of explore --cost FILE.toml"
                                  : "a store of explore with the joints of the fingers in the file "
                                    "of --hardware or --model"});
  }
}

std::string printed(const StoredRanking& ranking, const ListColumns& columns,
                    const TableFlags& tables, const FormatOption& format) {
  if (format.is("json")) return stored_ranking_json(ranking);
  if (format.is("csv")) return stored_ranking_csv(ranking);
  return tables.printed(stored_ranking_document(ranking, columns), format);
}

}  // namespace

void StoredRankingFlags::add_to(CLI::App& rank) {
  store.add(rank, "--store",
            "Rank the designs of a store of explore, by its own options or by those given here");
  rank.add_option("--constraint", constraints,
                  "With --store: keep only designs that meet this, such as 'sheaths<=2'; may "
                  "be repeated")
      ->allow_extra_args(false)
      ->needs(store.option);
  rank.add_option("--top", top, "With --store: number of best designs to list")
      ->check(CLI::Range(std::size_t{1}, std::size_t{100000}))
      ->needs(store.option);
}

StoredRanking stored_ranking_of(const CLI::App& rank, const StoredRankingFlags& flags,
                                const AsListed& as_listed) {
  require_nothing_else(rank);
  const std::string& file = flags.store.text;
  const StoreReader reader{std::filesystem::path(file)};
  const RankArguments arguments = stored_arguments(reader.description(), file);
  const Catalogue catalogue = shipped_catalogue();
  const ParsedExplore then(arguments, file);
  const ExploreOptions stored = stored_options(then, reader, file, catalogue);
  const ParsedExplore now(as_asked(arguments, asked_arguments(rank)), file);
  require_values(now.flags, stored, file);
  ExploreOptions asked = now.flags.read(stored.model, catalogue);
  asked.threads = rank.get_option("--threads")->as<int>();
  if (as_listed) {
    as_listed(ListedWith{asked.prices.has_value(), hand(asked.model.hardware).has_value()});
  }
  return stored_ranking(reader, stored, asked, catalogue);
}

int rank_stored(const CLI::App& rank, const StoredRankingFlags& flags, const TableFlags& tables,
                const FormatOption& format) {
  ListColumns columns;
  const StoredRanking ranking = stored_ranking_of(rank, flags, [&](const ListedWith& with) {
    columns = tables.read_columns(format, list_column_names(with));
    tables.require_width(format);
  });
  std::cout << printed(ranking, columns, tables, format);
  return ranking.report.top.empty() ? answer_is_no : done;
}

}  // namespace reeve::cli
