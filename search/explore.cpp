#include "search/explore.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>

#include "core/error.hpp"
#include "core/notation.hpp"
#include "numerics/parallel.hpp"
#include "search/decide/ladder_archive.hpp"
#include "search/judge/archive.hpp"
#include "search/judge/evaluation.hpp"
#include "search/judge/pareto.hpp"
#include "search/sample.hpp"

namespace reeve::search {
namespace {

// Large enough that the threads wait for the slowest but rarely, small enough for a cache and for
// Ctrl-C; a grain is some tenths of a millisecond.
constexpr std::size_t batch_size = 16384;
constexpr std::size_t grain = 64;
constexpr std::size_t named_as_best = 10;  // a line of a page

// What became of one routing of a batch.
struct Slot {
  Routing routing;
  std::uint64_t place = 0;  // in the whole enumeration
  ObjectiveValues values{};
  std::size_t failed_constraint = 0;  // its number, from 1; 0: none
  bool may_rank = false;
  bool may_be_rung = false;
  bool sampled = false;
};

class Exploration {
 public:
  explicit Exploration(const ExploreOptions& options)
      : options_(options),
        generator_(options.generator),
        range_(shard_range(generator_.total(), options.shard.index, options.shard.count)),
        workers_(options.threads),
        archive_(options.order, options.top),
        ladder_(options.order, options.ladder.by),
        sample_(options.sample),
        constraint_failures_(options.constraints.size(), 0),
        deciding_(extent_for(deciding_objectives(options), options.score)) {
    for (std::size_t w = 0; w < workers_.count(); ++w) {
      evaluators_.emplace_back(options.model, options.grasps, options.score, options.prices);
    }
    // What there is none of need not be worked out later.
    if (!evaluators_[0].has_hand()) deciding_.hand = true;
    for (const Routing& routing : options.references) {
      references_.push_back(
          {{to_word(routing), evaluators_[0].evaluate(routing)}, 0, 0, 0, false, std::nullopt});
      reference_goodness_.push_back(
          goodness(references_.back().design.values, options.order.objectives));
    }
    reaches_.assign(workers_.count(), ConstraintReaches(options.constraints.size()));
    dominators_.assign(workers_.count(), std::vector<std::uint64_t>(references_.size(), 0));
    slots_.resize(batch_size);
  }

  ExploreResult run(const Supervision& supervision) {
    const auto start = std::chrono::steady_clock::now();
    generator_.seek(range_.begin);
    bool stopped = false;
    while (generated_ < total() && !stopped) {
      const std::size_t actuated = fill_batch();
      workers_.for_each_block(actuated, grain,
                              [this](const IndexBlock& block) { evaluate(block); });
      collect(actuated);
      if (supervision.report) supervision.report({generated_, total()});
      stopped = supervision.stop != nullptr && supervision.stop->load();
    }
    ExploreResult result = conclude();
    const auto elapsed = std::chrono::steady_clock::now() - start;
    result.seconds = std::chrono::duration<double>(elapsed).count();
    return result;
  }

 private:
  std::uint64_t total() const { return range_.end - range_.begin; }

  std::size_t fill_batch() {
    std::size_t filled = 0;
    while (filled < batch_size && generated_ < total()) {
      Routing& routing = slots_[filled].routing;
      generator_.next(routing);
      slots_[filled].place = range_.begin + generated_;
      ++generated_;
      if (is_actuated(routing)) {
        ++filled;
      } else {
        ++not_actuated_;
      }
    }
    return filled;
  }

  void evaluate(const IndexBlock& block) {
    DesignEvaluator& evaluator = evaluators_[block.worker];
    for (std::size_t i = block.begin; i < block.end; ++i) {
      Slot& slot = slots_[i];
      slot.values = evaluator.evaluate(slot.routing, deciding_);
      slot.failed_constraint = first_failure(slot.values);
      if (slot.failed_constraint > 0) reaches_[block.worker].add(options_.constraints, slot.values);
      slot.may_rank = slot.failed_constraint == 0 && archive_.may_rank(slot.values);
      slot.may_be_rung = slot.failed_constraint == 0 && ladder_.may_be_rung(slot.values);
      slot.sampled = slot.failed_constraint == 0 && sample_.would_enter(slot.place);
      // What decides nothing here only what is kept needs.
      const bool kept = slot.may_rank || slot.may_be_rung;
      if (kept && deciding_ != Extent{}) slot.values = evaluator.evaluate(slot.routing);
      compare_with_references(slot, block.worker);
    }
  }

  void note_generated(ReferenceStanding& reference, const Slot& slot) const {
    reference.generated = true;
    if (slot.failed_constraint > 0) {
      reference.rejected_by = slot.failed_constraint - 1;
    }
  }

  std::size_t first_failure(const ObjectiveValues& values) const {
    const auto failed =
        std::find_if(options_.constraints.begin(), options_.constraints.end(),
                     [&](const Constraint& constraint) { return !constraint.admits(values); });
    if (failed == options_.constraints.end()) return 0;
    return static_cast<std::size_t>(failed - options_.constraints.begin()) + 1;
  }

  void compare_with_references(const Slot& slot, std::size_t worker) {
    if (references_.empty()) return;
    for (std::size_t r = 0; r < references_.size(); ++r) {
      // Each routing is generated once, so no two workers write here.
      if (slot.routing == options_.references[r]) note_generated(references_[r], slot);
    }
    if (slot.failed_constraint > 0) return;
    const Goodness candidate = goodness(slot.values, options_.order.objectives);
    for (std::size_t r = 0; r < references_.size(); ++r) {
      if (dominates(candidate, reference_goodness_[r])) ++dominators_[worker][r];
    }
  }

  void collect(std::size_t filled) {
    evaluated_ += filled;
    for (std::size_t i = 0; i < filled; ++i) {
      const Slot& slot = slots_[i];
      if (slot.failed_constraint > 0) ++constraint_failures_[slot.failed_constraint - 1];
      if (slot.may_rank) archive_.add({to_word(slot.routing), slot.values});
      if (slot.may_be_rung) ladder_.add({to_word(slot.routing), slot.values});
      if (slot.sampled) sample_.add(slot.place, slot.routing);
    }
  }

  ExploreResult conclude() {
    ExploreResult result;
    result.total = total();
    result.generated = generated_;
    result.partial = generated_ < total();
    result.evaluated = evaluated_;
    result.rejected.push_back({std::nullopt, not_actuated_});
    for (std::size_t c = 0; c < options_.constraints.size(); ++c) {
      result.rejected.push_back({c, constraint_failures_[c]});
    }
    const Archive::Content content = archive_.content();
    result.front_equals_left_out = content.front_equals_left_out;
    for (const RankedDesign& ranked : content.ranked) {
      if (ranked.front == 1) result.front.push_back(ranked);
      if (ranked.rank <= options_.top) result.top.push_back(ranked);
    }
    // Both are the beginning of one ranking.
    const std::vector<RankedDesign>& listed =
        result.front.size() > result.top.size() ? result.front : result.top;
    result.best = best_by_objective(listed, named_as_best);
    for (const RankedDesign& ranked : listed) {
      result.routings.push_back(parse_routing(ranked.design.word));
    }
    if (content.ranked.empty()) {
      if (!result.partial) result.unmet = unmet();
    } else {
      result.ladder = ladder(ladder_.candidates(), content.ranked.front().design, options_.order,
                             options_.ladder);
    }
    result.sample = sampled();
    place_references(content.ranked);
    result.references = references_;
    for (const DesignEvaluator& evaluator : evaluators_) {
      result.unconverged += evaluator.unconverged();
    }
    return result;
  }

  // Nothing where nothing was evaluated, so that no constraint is to blame.
  std::vector<ConstraintReach> unmet() const {
    if (evaluated_ == 0) return {};
    ConstraintReaches all(options_.constraints.size());
    for (const ConstraintReaches& reaches : reaches_) all.add(reaches);
    return all.list();
  }

  // Most of what was sampled on the way is not in the sample, so what decides nothing waits.
  std::vector<Design> sampled() {
    std::vector<Design> designs;
    for (const Routing& routing : sample_.routings()) {
      designs.push_back({to_word(routing), evaluators_[0].evaluate(routing)});
    }
    return designs;
  }

  // Beyond the first `top` and the front the archive has gaps, so only ranks in these are ranks.
  void place_references(const std::vector<RankedDesign>& ranked) {
    for (std::size_t r = 0; r < references_.size(); ++r) {
      for (const auto& counts : dominators_) references_[r].dominated_by += counts[r];
      for (const RankedDesign& entry : ranked) {
        if (entry.design.word != references_[r].design.word) continue;
        if (entry.rank > options_.top && entry.front > 1) continue;
        references_[r].rank = entry.rank;
        references_[r].front = entry.front;
      }
    }
  }

  static std::vector<Objective> deciding_objectives(const ExploreOptions& options) {
    std::vector<Objective> objectives = options.order.objectives;
    if (options.order.by_score) objectives.push_back(Objective::score);
    for (const Constraint& constraint : options.constraints) {
      objectives.push_back(constraint.objective);
    }
    return objectives;
  }

  const ExploreOptions& options_;
  RoutingGenerator generator_;
  ShardRange range_;
  Workers workers_;
  Archive archive_;
  LadderArchive ladder_;
  DesignSample sample_;
  std::vector<std::uint64_t> constraint_failures_;
  Extent deciding_;
  std::vector<DesignEvaluator> evaluators_;
  std::vector<ConstraintReaches> reaches_;  // of each worker
  std::vector<ReferenceStanding> references_;
  std::vector<Goodness> reference_goodness_;
  std::vector<std::vector<std::uint64_t>> dominators_;  // [worker][reference]
  std::vector<Slot> slots_;
  std::uint64_t generated_ = 0;
  std::uint64_t not_actuated_ = 0;
  std::uint64_t evaluated_ = 0;
};

}  // namespace

Shard parse_shard(const std::string& text) {
  Shard shard{0, 0};
  const char* end = text.data() + text.size();
  const auto index = std::from_chars(text.data(), end, shard.index);
  if (index.ec == std::errc{} && index.ptr != end && *index.ptr == '/') {
    const auto count = std::from_chars(index.ptr + 1, end, shard.count);
    if (count.ec == std::errc{} && count.ptr == end && shard.index >= 1 &&
        shard.index <= shard.count) {
      return shard;
    }
  }
  throw InputError(
      {.what = "shard", .value = text, .expected = "i/N with 1 <= i <= N, such as 2/8"});
}

ExploreResult explore(const ExploreOptions& options, const Supervision& supervision) {
  if (options.top == 0)
    throw InputError({.what = "top 0", .expected = "at least one design to keep"});
  return Exploration(options).run(supervision);
}

}  // namespace reeve::search
