#include "search/batches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/notation.hpp"
#include "numerics/parallel.hpp"
#include "search/evaluate/deciding_evaluation.hpp"
#include "search/evaluate/evaluation.hpp"
#include "search/exploration_part.hpp"
#include "search/foreseen_designs.hpp"
#include "search/limits/part_classes.hpp"
#include "search/rank/pareto.hpp"
#include "search/routing_source.hpp"

namespace reeve::search {
namespace {

// Counts the routings that the source leaves out (routing_source.hpp) as generated and evaluated,
// or rejected for their parts.
class LeftOutRoutings {
 public:
  // Counts routings of `range`. The first `counted` places of the range are in the part already.
  // Keeps a reference to the source.
  LeftOutRoutings(const ExploreOptions& options, RoutingSource& source, ShardRange range,
                  std::uint64_t counted);

  // Continues with another range.
  void go_on_with(ShardRange range, std::uint64_t counted);

  // Adds the left-out routings among the first `generated` that were not added before. Of those
  // within the limits `given` were not left out.
  void add_to(ExplorationPart& part, std::uint64_t generated, std::uint64_t given);

 private:
  RoutingSource& source_;
  ShardRange range_;
  std::vector<std::uint64_t> before_;  // verdicts at places counted already
  std::vector<std::optional<RoutingSource::LeftOutPlace>> references_;
};

LeftOutRoutings::LeftOutRoutings(const ExploreOptions& options, RoutingSource& source,
                                 ShardRange range, std::uint64_t counted)
    : source_(source) {
  for (const Routing& routing : options.references) {
    references_.push_back(source.place_left_out(routing));
  }
  go_on_with(range, counted);
}

void LeftOutRoutings::go_on_with(ShardRange range, std::uint64_t counted) {
  range_ = range;
  before_ = source_.verdicts_before(range.begin + counted);
}

void LeftOutRoutings::add_to(ExplorationPart& part, std::uint64_t generated, std::uint64_t given) {
  std::vector<std::uint64_t> until = source_.verdicts_before(range_.begin + generated);
  part.evaluated += until[within_limits] - before_[within_limits] - given;
  for (std::size_t c = 0; failing(c) < until.size(); ++c) {
    const std::uint64_t rejected = until[failing(c)] - before_[failing(c)];
    part.constraint_failures[c] += rejected;
    part.evaluated += rejected;
  }
  before_ = std::move(until);
  for (std::size_t r = 0; r < references_.size(); ++r) {
    const auto& left = references_[r];
    if (!left || left->place < range_.begin || left->place >= range_.begin + generated) continue;
    part.references[r].generated = true;
    part.references[r].rejected_by = left->constraint;
  }
}

// Counts what is known of the references among all searched routings: whether each was generated,
// which constraint rejected it, and how many designs dominate it.
class ReferenceTally {
 public:
  explicit ReferenceTally(const ExploreOptions& options) : options_(options) {
    DesignEvaluator evaluator(options.model, options.grasps, options.score, options.prices);
    for (const Routing& routing : options.references) {
      goodness_.push_back(goodness(evaluator.evaluate(routing), options.order.objectives));
    }
  }

  // `values` has at least those of the order; `failed_constraint` is a number from 1, 0 for none.
  void count(const Routing& routing, const ObjectiveValues& values, std::size_t failed_constraint,
             std::vector<ReferenceCount>& references) const {
    for (std::size_t r = 0; r < goodness_.size(); ++r) {
      if (routing != options_.references[r]) continue;
      references[r].generated = true;
      if (failed_constraint > 0) references[r].rejected_by = failed_constraint - 1;
    }
    if (failed_constraint > 0 || goodness_.empty()) return;
    const Goodness candidate = goodness(values, options_.order.objectives);
    for (std::size_t r = 0; r < goodness_.size(); ++r) {
      if (dominates(candidate, goodness_[r])) ++references[r].dominated_by;
    }
  }

  // True if all values between the two estimates give the same count.
  bool agree(const Estimate& estimate) const {
    const Goodness best = goodness(estimate.at_best, options_.order.objectives);
    const Goodness worst = goodness(estimate.at_worst, options_.order.objectives);
    return std::all_of(goodness_.begin(), goodness_.end(), [&](const Goodness& reference) {
      return dominates(best, reference) == dominates(worst, reference);
    });
  }

 private:
  const ExploreOptions& options_;
  std::vector<Goodness> goodness_;  // one for each reference
};

// Batches are large enough that threads rarely wait for the slowest one. They are small enough for
// a cache, for Ctrl-C, and to lose little on an interrupt. A grain takes some tenths of a
// millisecond.
constexpr std::size_t batch_size = 2048;
constexpr std::size_t grain = 64;
// It is worth some tenths of a second to know beforehand what will be left out.
constexpr std::uint64_t long_search = 1'000'000;

// A routing of a batch and its evaluation.
struct BatchSlot {
  Routing routing;
  std::string word;                   // set if it may be kept
  std::uint64_t place = 0;            // place in the whole enumeration
  ObjectiveValues values{};           // values of the deciding objectives
  ObjectiveValues all_values{};       // every value, for a store
  std::size_t failed_constraint = 0;  // constraint number, from 1; 0: none
  bool has_tensions = true;
  bool may_rank = false;
  bool may_be_step = false;
  bool sampled = false;
  bool done = false;
  std::uint64_t unconverged = 0;
};

struct Batch {
  std::vector<BatchSlot> slots;
  std::size_t actuated = 0;     // number of slots in use
  std::uint64_t generated = 0;  // number of routings up to the last slot
};

class Exploration {
 public:
  Exploration(const ExploreOptions& options, const Checkpoint& checkpoint,
              EvaluatedDesigns evaluated)
      : options_(options),
        checkpoint_(checkpoint),
        tells_reaches_(evaluated == EvaluatedDesigns::all || pruning_constraints(options) == 0),
        source_(options, !tells_reaches_ && !checkpoint.design),
        range_(shard_range(source_.total(), options.shard.index, options.shard.count)),
        workers_(options.threads),
        references_(options),
        part_(checkpoint.before ? part_of(*checkpoint.before, options) : ExplorationPart(options)) {
    for (std::size_t w = 0; w < workers_.count(); ++w) {
      evaluators_.emplace_back(options.model, options.grasps, options.score, options.prices,
                               deciding_objectives(options));
    }
    if (evaluated == EvaluatedDesigns::all) {
      part_.reaches = ConstraintReaches(options.constraints.size());
    }
    if (keeps_) {
      for (std::size_t w = 0; w < workers_.count(); ++w) {
        whole_.emplace_back(options.model, options.grasps, options.score, options.prices);
      }
    }
    batch_.slots.resize(batch_size);
    next_.slots.resize(batch_size);
    if (checkpoint.before && part_.total != range_.end - range_.begin) {
      throw InputError(fmt::format("what was kept is of {} routings, and there are {}", part_.total,
                                   range_.end - range_.begin));
    }
    part_.total = range_.end - range_.begin;
    leaves_out_unwanted_ = parts_decide_ && !checkpoint.design &&
                           (options.constraints.empty() || !tells_reaches_) && leave_out_unwanted();
    generated_ = part_.generated;
    seconds_before_ = part_.seconds;
  }

  ExplorationPart run(const Supervision& supervision) {
    stop_ = supervision.stop;
    if (leaves_out_unwanted_ && part_.total > long_search) foresee();
    const std::uint64_t before = generated_;
    bool stopped = !find_beginning();
    if (!stopped) fill(next_);
    while (generated_ < part_.total && !stopped) {
      std::swap(batch_, next_);
      evaluate_and_fill_next();
      generated_ = batch_.generated;
      collect();
      if (supervision.report) supervision.report({generated_, part_.total, before});
      stopped = must_stop();
      if (checkpoint_.save && !stopped && checkpoint_.is_due()) save();
    }
    source_.stop_with(nullptr);
    if (foreseen_ && generated_ < part_.total) foreseen_->add_to(part_);
    add_up();
    // A shard without routings is saved, too, but once.
    if (checkpoint_.save && (generated_ > before || !checkpoint_.before)) checkpoint_.save(part_);
    return std::move(part_);
  }

  // One of the pieces that it is given one after the other (batches.hpp).
  ExplorationPart run_through(const ShardRange& piece, const Supervision& supervision) {
    if (!seen_) seen_.emplace(options_);
    range_ = piece;
    generated_ = 0;
    start_ = std::chrono::steady_clock::now();
    part_ = ExplorationPart(options_);
    part_.total = piece.end - piece.begin;
    ExplorationPart part = run(supervision);
    seen_->absorb(part);
    seen_->thin_out();
    return part;
  }

 private:
  // The evaluator is one of its own, since routings are made while others are evaluated.
  bool leave_out_unwanted() {
    auto evaluator =
        std::make_shared<DecidingEvaluator>(options_.model, options_.grasps, options_.score,
                                            options_.prices, deciding_objectives(options_));
    if (!evaluator->estimates_beginnings()) return false;
    return source_.leave_out_unwanted(
        possible_hardware(options_.model),
        [this, evaluator](const RoutingBeginning& beginning, const ShardRange& places) {
          ++part_.visited.beginnings;
          const std::optional<Estimate> bound = evaluator->estimate(beginning);
          return !bound || !is_far(*bound) || part_.sample.may_have_one(places);
        });
  }

  // A record, a piece and a shard hold what is best among their own designs.
  bool is_alone() const {
    return options_.shard.count == 1 && !options_.keeps_record && !keeps_ && !seen_;
  }

  void foresee() {
    part_.sample.foresee({range_.begin + generated_, range_.end}, workers_, stop_);
    if (!is_alone()) return;
    foreseen_.emplace(options_, stop_);
    part_.visited += foreseen_->visited();
  }

  void save() {
    add_up();
    checkpoint_.save(part_);
  }

  bool must_stop() const { return stop_ != nullptr && stop_->load(); }

  // False if it was stopped on the way, which may be long.
  bool find_beginning() {
    filled_ = generated_;
    source_.stop_with(stop_);
    try {
      if (left_out_) {
        left_out_->go_on_with(range_, generated_);
      } else if (source_.leaves_out()) {
        left_out_.emplace(options_, source_, range_, generated_);
      }
      source_.seek(range_.begin + generated_, range_.end);
    } catch (const WayStopped&) {
      left_out_.reset();
      return false;
    }
    return true;
  }

  void fill(Batch& batch) {
    batch.actuated = 0;
    try {
      fill_on(batch);
    } catch (const WayStopped&) {
      // The batch keeps the slots filled so far.
    }
    batch.generated = filled_;
  }

  void fill_on(Batch& batch) {
    while (batch.actuated < batch.slots.size() && filled_ < part_.total) {
      BatchSlot& slot = batch.slots[batch.actuated];
      if (!source_.next(slot.routing, slot.place)) {
        filled_ = part_.total;
        break;
      }
      slot.done = false;
      filled_ = slot.place + 1 - range_.begin;
      ++batch.actuated;
    }
  }

  // Generating is a task among those of evaluating, the first: it is in series with itself alone.
  void evaluate_and_fill_next() {
    workers_.for_each_block(batch_.actuated + grain, grain, [this](const IndexBlock& block) {
      for (std::size_t i = block.begin; i < block.end; ++i) {
        if (i == 0) fill(next_);
        if (i >= grain && may_go_on(i)) evaluate(batch_.slots[i - grain], block.worker);
      }
    });
  }

  // True until a stop. The first designs are always evaluated; after a stop, the rest of the batch
  // is not.
  bool may_go_on(std::size_t i) const { return i < 2 * grain || !must_stop(); }

  void evaluate(BatchSlot& slot, std::size_t worker) {
    DecidingEvaluator& evaluator = evaluators_[worker];
    const std::size_t before = evaluator.unconverged();
    try {
      slot.has_tensions = true;
      judge(slot, far_values(slot.routing, evaluator), worker);
    } catch (const OutOfRange&) {
      slot.has_tensions = false;
      leave_out(slot, evaluator);
    }
    slot.unconverged = evaluator.unconverged() - before;
    slot.done = true;
  }

  // Constraints on parts need no tensions, so they reject what they would reject unmade.
  void leave_out(BatchSlot& slot, DecidingEvaluator& evaluator) const {
    slot.values = evaluator.part_values(slot.routing);
    const auto first = options_.constraints.begin();
    slot.failed_constraint =
        first_failure({first, first + static_cast<std::ptrdiff_t>(deciding_parts_)}, slot.values);
    slot.may_rank = slot.may_be_step = slot.sampled = false;
    slot.word = to_word(slot.routing);
  }

  void judge(BatchSlot& slot, const std::optional<ObjectiveValues>& far, std::size_t worker) {
    slot.values = far ? *far : evaluators_[worker].evaluate(slot.routing);
    slot.failed_constraint = first_failure(options_.constraints, slot.values);
    const bool may_be_kept = !far && slot.failed_constraint == 0;
    slot.may_rank = may_be_kept && part_.archive.may_rank(slot.values);
    slot.may_be_step = may_be_kept && part_.tradeoff.may_be_step(slot.values);
    slot.sampled = slot.failed_constraint == 0 && part_.sample.would_enter(slot.place);
    if (seen_) hold_against_seen(slot);
    if (slot.may_rank || slot.may_be_step || checkpoint_.design) {
      slot.word = to_word(slot.routing);
      // A reader of the store may ask for any value.
      if (keeps_) slot.all_values = whole_[worker].evaluate(slot.routing);
    }
  }

  // Returns the values at best if they suffice. Otherwise returns nothing.
  std::optional<ObjectiveValues> far_values(const Routing& routing,
                                            DecidingEvaluator& evaluator) const {
    if (!parts_decide_) return std::nullopt;
    const std::optional<Estimate> estimate = evaluator.estimate(routing);
    return estimate && is_far(*estimate) ? std::optional(estimate->at_best) : std::nullopt;
  }

  // True if no such design can be kept, and all count alike.
  bool is_far(const Estimate& estimate) const {
    return !may_be_kept(estimate.at_best) && references_.agree(estimate);
  }

  bool may_be_kept(const ObjectiveValues& values) const {
    return part_.may_keep(values) && (!seen_ || seen_->may_keep(values)) &&
           (!foreseen_ || foreseen_->may_keep(values));
  }

  void hold_against_seen(BatchSlot& slot) const {
    slot.may_rank = slot.may_rank && seen_->archive.may_rank(slot.values);
    slot.may_be_step = slot.may_be_step && seen_->tradeoff.may_be_step(slot.values);
    slot.sampled = slot.sampled && seen_->sample.would_enter(slot.place);
  }

  // True if a pruned search would not make this routing; it then counts for nothing.
  bool fails_by_parts(const BatchSlot& slot) const {
    return slot.failed_constraint > 0 && slot.failed_constraint <= deciding_parts_;
  }

  // Blocks are not worked off in their order: what was done behind the first that was not does not
  // count.
  void collect() {
    for (std::size_t i = 0; i < batch_.actuated; ++i) {
      const BatchSlot& slot = batch_.slots[i];
      if (!slot.done) {
        generated_ = slot.place - range_.begin;
        return;
      }
      if (!fails_by_parts(slot)) part_.unconverged += slot.unconverged;
      ++given_;
      ++part_.visited.designs;
      if (!slot.has_tensions && slot.failed_constraint == 0) {
        part_.without_tensions.add({1, slot.word});
        continue;
      }
      ++part_.evaluated;
      if (slot.has_tensions) count(slot);
      if (slot.failed_constraint > 0) ++part_.constraint_failures[slot.failed_constraint - 1];
      const ObjectiveValues& values = keeps_ ? slot.all_values : slot.values;
      if (slot.may_rank) part_.archive.add({slot.word, values});
      if (slot.may_be_step) part_.tradeoff.add({slot.word, values});
      if (slot.sampled) part_.sample.add(slot.place, slot.routing);
    }
  }

  void count(const BatchSlot& slot) {
    references_.count(slot.routing, slot.values, slot.failed_constraint, part_.references);
    if (slot.failed_constraint > 0 && tells_reaches_) {
      part_.reaches.add(options_.constraints, slot.values);
    }
    if (checkpoint_.design) checkpoint_.design({slot.place, slot.word, slot.all_values});
  }

  // May be called at any time between batches.
  void add_up() {
    part_.generated = generated_;
    if (left_out_) left_out_->add_to(part_, generated_, std::exchange(given_, 0));
    const auto elapsed = std::chrono::steady_clock::now() - start_;
    part_.seconds = seconds_before_ + std::chrono::duration<double>(elapsed).count();
  }

  const ExploreOptions& options_;
  const Checkpoint& checkpoint_;
  const std::size_t deciding_parts_ = decided_by_parts(options_.constraints, options_.generator);
  const bool parts_decide_ = deciding_parts_ == options_.constraints.size();
  const bool tells_reaches_;
  const bool keeps_ = checkpoint_.save || checkpoint_.design;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  double seconds_before_ = 0;
  RoutingSource source_;
  ShardRange range_;
  std::optional<LeftOutRoutings> left_out_;
  Workers workers_;
  ReferenceTally references_;
  ExplorationPart part_;
  std::optional<ExplorationPart> seen_;  // kept designs of the pieces before
  bool leaves_out_unwanted_ = false;
  std::optional<ForeseenDesigns> foreseen_;
  const std::atomic<bool>* stop_ = nullptr;
  std::vector<DecidingEvaluator> evaluators_;
  std::vector<DesignEvaluator> whole_;  // one for each worker, for a store
  Batch batch_;                         // the batch being evaluated
  Batch next_;                          // the batch being generated meanwhile
  std::uint64_t filled_ = 0;            // routings generated
  std::uint64_t generated_ = 0;         // … up to the last that was evaluated
  std::uint64_t given_ = 0;             // evaluated since what is left out was counted
};

// An exploration that owns the options that it refers to.
struct OwnExploration {
  explicit OwnExploration(const ExploreOptions& asked) : options(asked) {}

  ExploreOptions options;
  Checkpoint nothing_kept;
  Exploration exploration{options, nothing_kept, EvaluatedDesigns::that_may_be_kept};
};

}  // namespace

PieceSearch piece_search(const ExploreOptions& options) {
  return [own = std::make_shared<OwnExploration>(options)](const ShardRange& piece,
                                                           const Supervision& supervision) {
    return own->exploration.run_through(piece, supervision);
  };
}

ExplorationPart search_batches(const ExploreOptions& options, const Checkpoint& checkpoint,
                               EvaluatedDesigns evaluated, const Supervision& supervision) {
  return Exploration(options, checkpoint, evaluated).run(supervision);
}

}  // namespace reeve::search
