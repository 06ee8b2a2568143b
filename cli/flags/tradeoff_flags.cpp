#include "cli/flags/tradeoff_flags.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "catalog/price_file.hpp"
#include "cli/inputs.hpp"
#include "core/error.hpp"

namespace reeve::cli {
namespace {

[[noreturn]] void fail_without_prices(const std::string& option, const std::string& value) {
  throw InputError({.what = option,
                    .value = value,
                    .expected = "--cost FILE.toml with it, which says what parts cost"});
}

bool counts_cost(const Score& score) {
  return std::ranges::any_of(
      score.terms, [](const ScoreTerm& term) { return term.objective == Objective::cost; });
}

}  // namespace

void TradeoffFlags::add_to(CLI::App& command) {
  by.add(command, "--tradeoff", "Best design for each number of these (cost if --cost is given)")
      ->check(one_of(tradeoff_measures()));
  add_with_default(command, "--within", within,
                   "Name the design with fewest of --tradeoff that loses at most this in any "
                   "ranked objective");
  prices.add_to(command, "makes cost an objective");
}

TradeoffOptions TradeoffFlags::read() const {
  const bool priced = prices.is_given();
  const std::string measure = priced && !by.is_given() ? "cost" : by.text;
  if (measure == "cost" && !priced) fail_without_prices("--tradeoff", measure);
  return {parse_objective(measure, "--tradeoff"),
          for_name("--", [&] { return parse_within(within); })};
}

void PricesOption::add_to(CLI::App& command, const std::string& what) {
  add(command, "--cost", "TOML file of prices, such as catalog/prices/example.toml; " + what);
}

std::optional<PartPrices> PricesOption::read() const {
  if (!is_given()) return std::nullopt;
  if (text.empty()) throw InputError({.what = "--cost", .value = "", .expected = "a TOML file"});
  return read_price_file(text);
}

void TradeoffFlags::require_prices(const Order& order, const Score& score,
                                   const std::vector<Constraint>& constraints) const {
  if (prices.is_given()) return;
  const auto& objectives = order.objectives;
  if (std::ranges::find(objectives, Objective::cost) != objectives.end()) {
    fail_without_prices("--objectives", "cost");
  }
  if (counts_cost(score)) fail_without_prices("--score", "cost");
  for (const Constraint& constraint : constraints) {
    if (constraint.objective == Objective::cost) {
      fail_without_prices("--constraint", constraint.text);
    }
  }
}

void SweepFlags::add_to(CLI::App& command, const std::string& designs) {
  add(command, "--sweep",
      "Vary one coefficient, such as mu=0.02..0.3 or sheath_angle=3..9, and show " + designs);
}

std::optional<CoefficientRange> SweepFlags::read() const {
  if (!is_given()) return std::nullopt;
  return for_name("--", [&] { return parse_sweep(text); });
}

void require_sweep(const std::optional<CoefficientRange>& over, const UncertaintyOptions& evaluated,
                   bool draws, const LookAtNetworks& look) {
  if (!over) return;
  for_name("--", [&] { validate(SweepOptions{evaluated, draws, *over}); });
  ValueUse use = value_use(evaluated.nominal.hardware, over->coefficient);
  look(use);
  require_taken(fmt::format("--sweep {}", row(over->coefficient).name), use);
}

}  // namespace reeve::cli
