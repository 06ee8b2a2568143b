// Options of `explore` and `rank` for the step from a ranking to a decision: the trade-off, the
// acceptable loss, the prices of parts, and designs over one coefficient.
#pragma once

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

#include "cli/outputs.hpp"
#include "core/part_prices.hpp"
#include "search/evaluate/objectives.hpp"
#include "search/evaluate/score.hpp"
#include "search/rank/ranking.hpp"
#include "search/rank/tradeoff.hpp"
#include "search/uncertainty/sweep.hpp"

namespace reeve::cli {

// --cost
struct PricesOption : TextOption {
  void add_to(CLI::App& command, const std::string& what);
  // Nothing if none are given. Throws InputError.
  std::optional<PartPrices> read() const;
};

struct TradeoffFlags {
  TextOption by{"sheaths"};
  std::string within = "2%";
  PricesOption prices;

  void add_to(CLI::App& command);
  // The measure is the cost if prices are given and no measure is.
  TradeoffOptions read() const;
  std::optional<PartPrices> read_prices() const { return prices.read(); }
  // Throws InputError if what was asked for counts the cost, and there are no prices.
  void require_prices(const Order& order, const Score& score,
                      const std::vector<Constraint>& constraints) const;
};

struct SweepFlags : TextOption {
  void add_to(CLI::App& command, const std::string& designs);
  // Nothing if it is not given. Throws InputError.
  std::optional<CoefficientRange> read() const;
};

// Throws InputError where what is swept cannot be so, or acts on no contact. Does nothing without a
// range.
void require_sweep(const std::optional<CoefficientRange>& over, const UncertaintyOptions& evaluated,
                   bool draws, const LookAtNetworks& look);

}  // namespace reeve::cli
