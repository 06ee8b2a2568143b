// The main job: generate every routing of a set of parts, evaluate it, keep the best.
//
// Memory does not grow with the number of designs (archive.hpp), and the result, but for the time
// it took, is the same for any number of threads: batches of routings are generated in order,
// evaluated slot by slot, and offered to the archive in order.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "causes/model.hpp"
#include "core/grasp.hpp"
#include "core/part_prices.hpp"
#include "search/checkpoint.hpp"
#include "search/enumerate/field_parts.hpp"
#include "search/enumerate/generator.hpp"
#include "search/evaluate/score.hpp"
#include "search/rank/infeasible.hpp"
#include "search/rank/ranking.hpp"
#include "search/rank/tradeoff.hpp"
#include "search/shard_record.hpp"

namespace reeve::search {

struct Shard {
  std::uint64_t index = 1;  // 1 to count
  std::uint64_t count = 1;
};

// "i/N", 1 <= i <= N. Throws InputError.
Shard parse_shard(const std::string& text);

struct ExploreOptions {
  GeneratorOptions generator;
  Shard shard;
  Model model;
  GraspSet grasps;
  Order order;
  Score score = authors_score();
  std::vector<Constraint> constraints;
  std::size_t top = 1000;           // at least 1
  std::size_t sample = 2000;        // designs drawn at random, to show what the best stand out from
  int threads = 0;                  // 0: all
  std::vector<Routing> references;  // canonical routings whose place among the others is wanted
  std::optional<PartPrices> prices;
  TradeoffOptions tradeoff;
  bool keeps_record = false;  // true if the result has a record of the shard
  // The parts used in real hands that were left out, since they would make too many routings.
  std::optional<LeftOutParts> left_out{};
};

struct Progress {
  std::uint64_t done = 0;  // routings generated
  std::uint64_t total = 0;
  std::uint64_t before = 0;  // routings done by an earlier run
};

// Progress and cancellation callbacks of an exploration. All may be empty.
struct Supervision {
  std::function<void(const Progress&)> report;
  const std::atomic<bool>* stop = nullptr;
};

struct Rejection {
  // Index of the failed constraint. None: not all tendons hang on the motor.
  std::optional<std::size_t> constraint;
  std::uint64_t count = 0;
};

// Work of one run: the same for any number of threads, less where more is known beforehand.
struct Visited {
  std::uint64_t designs = 0;     // designs looked at one by one; the others are counted
  std::uint64_t beginnings = 0;  // partial designs whose bound was compared with what is kept

  Visited& operator+=(const Visited& other) {
    designs += other.designs;
    beginnings += other.beginnings;
    return *this;
  }
};

struct ReferenceStanding {
  Design design;                   // evaluated whether or not it was generated
  std::uint64_t dominated_by = 0;  // designs that dominate it
  std::size_t rank = 0;  // 0: not generated, rejected, or beyond the designs that are kept
  int front = 0;
  bool generated = false;                  // among the routings of these parts and this shard
  std::optional<std::size_t> rejected_by;  // the constraint that it fails
};

struct ExploreResult {
  std::uint64_t total = 0;      // routings in this shard
  std::uint64_t generated = 0;  // less than total if stopped
  std::vector<Rejection> rejected;
  std::uint64_t evaluated = 0;  // actuated, and with tensions
  WithoutTensions without_tensions;
  std::string why_without_tensions{};  // reason, for the example
  // Evaluated designs that constraints on parts alone reject. They are counted, not made, unless
  // all designs are kept (routing_source.hpp).
  std::uint64_t pruned = 0;
  // Set if one run searched all routings, which no other shard or process shared.
  std::optional<Visited> visited{};
  bool made_all = false;  // true if the pruned designs were made, too
  bool partial = false;
  double seconds = 0;
  std::vector<RankedDesign> front;
  std::vector<RankedDesign> top;
  std::vector<Routing> routings;  // routings of the longer list, front or top, in its order
  std::vector<BestDesigns> best;  // best of top and front for each objective, a few words each
  std::vector<Design> sample;     // random sample of the designs that meet all constraints
  std::uint64_t front_equals_left_out = 0;
  // Tension solves (evaluation.hpp), but for designs that constraints on parts alone reject.
  std::uint64_t unconverged = 0;
  std::vector<ReferenceStanding> references;
  Tradeoff tradeoff;  // without steps where there is no design
  // Parallel to the constraints, if nothing meets all of them; of a shard with constraints on parts
  // alone not known.
  std::vector<ConstraintReach> infeasible;
  std::optional<ShardRecord> record;  // if it was asked for
};

// Searches the routings of the shard from the checkpoint on, and returns the part kept of all of
// them.
using Searcher =
    std::function<ExplorationPart(const ExploreOptions&, const Supervision&, const Checkpoint&)>;

// Goes on where what is kept ends, to the same result as if it had not been stopped there. Without
// a search this process goes through them alone.
ExploreResult explore(const ExploreOptions& options, const Supervision& supervision = {},
                      const Checkpoint& checkpoint = {}, const Searcher& search = {});

}  // namespace reeve::search
