// Finds, for each amount of a measure (sheaths, blocks, pulleys, parts, cost), the best design that
// needs no more of it.
//
// The step at k is the first, in the order of the ranking, of the designs with at most k; of those
// that are equal in every ranked objective the one with least. A k at which no better one appears
// has no step. Candidates are the designs that no other one with as little of the measure matches
// or beats in every ranked objective: the Pareto front over the ranked objectives and the measure,
// of the designs with floating blocks and of those without.
//
//   loss      of an objective, relative to the first design of the ranking: (v1 - v) / |v1|, where
//             lower is better (v - v1) / |v1|; below 0 it is a gain
//   kept      1 - the greatest loss of any ranked objective, between 0 and 1
//   knee      the step that stands highest above the chord of the trade-off's ends, measure and
//   kept
//             each scaled to run from 0 to 1; none of fewer than three steps, or if none stands
//             above. (Distance to the chord: I. Das, Structural Optimization 18, 107-115, 1999; of
//             discrete points as the greatest y - x: V. Satopää et al., "Finding a 'Kneedle' in a
//             Haystack", ICDCS Workshops, 2011, without its smoothing.)
//   affordable  of the candidates none of whose losses is above `within` the one with least of the
//             measure, and of these the first in the order
//   with and without blocks  of the candidates with floating blocks, and of those without, the one
//             that is chosen in the same way; where none loses so little, the first in the order
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "search/rank/archive.hpp"
#include "search/rank/ranking.hpp"

namespace reeve::search {

struct TradeoffOptions {
  Objective by = Objective::sheaths;  // lower is better
  double within = 0.02;               // loss, as a part of the first design's value
};

struct TradeoffStep {
  double at_most = 0;  // limit on the measure; the design has this value
  Design design;
  double kept = 1;
};

// The best designs with and without floating blocks, for users who prefer no moving parts at the
// hand.
template <typename Each>
struct BlockChoice {
  Each without;
  Each with;
};

struct Tradeoff {
  TradeoffOptions options;
  std::vector<Objective> objectives;            // objectives of the ranking
  std::vector<TradeoffStep> steps;              // sorted by the measure, least first
  Design first;                                 // first of the ranking
  std::optional<Design> affordable;             // unless the first has as little of the measure
  std::optional<std::size_t> knee;              // a step
  std::optional<BlockChoice<Design>> choice{};  // only where there are designs of both kinds
};

// Returns the objectives of the front, and the score if it orders within fronts.
std::vector<Objective> ranked_by(const Order& order);

// Infinite if the first has 0 and this is worse.
double loss(Objective objective, const ObjectiveValues& values, const ObjectiveValues& first);

// True if a design loses no more than `within` in any ranked objective.
bool is_within(const ObjectiveValues& values, const Tradeoff& tradeoff);

// Takes candidates as TradeoffArchive keeps them, in any order.
Tradeoff tradeoff(std::vector<Design> candidates, const Design& first, const Order& order,
                  const TradeoffOptions& options);

// "sheaths", "blocks", "pulleys", "parts" or "cost".
const std::vector<std::string>& tradeoff_measures();

// "2%", "2.5 %": from 0 % to below 100 %. Throws InputError.
double parse_within(const std::string& text);

// The designs that can be a step of the trade-off out of a stream of any length.
//
// Exact: a design that another one with as little of the measure matches or beats in every ranked
// objective is no step, however long the trade-off. What is kept is one Pareto front, so that
// memory does not grow with the number of designs that are offered; it is kept beside the archive
// of the ranking, in which the best design with one sheath may be far beyond the end.
class TradeoffArchive {
 public:
  TradeoffArchive(const Order& order, Objective by);

  // May be asked from many threads.
  bool may_be_step(const ObjectiveValues& values) const {
    return front_of(values).may_rank(values);
  }

  void add(Design design);

  std::vector<Design> candidates();

 private:
  const Archive& front_of(const ObjectiveValues& values) const;

  Archive without_blocks_;
  Archive with_blocks_;
};

}  // namespace reeve::search
