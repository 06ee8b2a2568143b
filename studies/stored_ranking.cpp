#include "studies/stored_ranking.hpp"

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

#include "core/error.hpp"
#include "search/exploration_part.hpp"

namespace reeve::studies {
namespace {

bool decides_by_score(const Order& order) {
  return order.by_score ||
         std::ranges::find(order.objectives, Objective::score) != order.objectives.end();
}

bool is_same_score(const Score& a, const Score& b) { return to_text(a) == to_text(b); }

bool is_same_order(const ExploreOptions& a, const ExploreOptions& b) {
  if (a.order.objectives != b.order.objectives || a.order.by_score != b.order.by_score)
    return false;
  return !decides_by_score(a.order) || is_same_score(a.score, b.score);
}

// True if `a` has this constraint of `b`; a bound on another score is another constraint.
bool has_too(const ExploreOptions& a, const Constraint& constraint, const ExploreOptions& b) {
  if (constraint.objective == Objective::score && !is_same_score(a.score, b.score)) return false;
  return std::ranges::any_of(
      a.constraints, [&](const Constraint& other) { return other.text == constraint.text; });
}

// All constraints of the store.
bool asks_again(const ExploreOptions& stored, const ExploreOptions& asked) {
  return std::ranges::all_of(stored.constraints, [&](const Constraint& constraint) {
    return has_too(asked, constraint, stored);
  });
}

// True if a design that is better in everything meets the constraint whenever the other one does.
bool admits_what_is_better(const Constraint& constraint, const Order& order) {
  const auto& ranked = order.objectives;
  if (std::ranges::find(ranked, constraint.objective) == ranked.end()) return false;
  const char side = row(constraint.objective).better == Better::higher ? '>' : '<';
  return constraint.comparison.front() == side;
}

// Takes designs with their values, as an exploration does after it has evaluated them.
class Ranker {
 public:
  explicit Ranker(const ExploreOptions& options) : options_(options), part_(options) {}

  // A step that others beat is not for the list.
  enum class Role : std::uint8_t { ranks, step };

  void add(Design design, std::uint64_t equals_left_out, Role role) {
    add_score(options_.score, design.values);
    ++kept_;
    if (const auto failed = first_failure(options_.constraints, design.values)) {
      ++part_.constraint_failures[failed - 1];
      ++failed_;
      return;
    }
    if (part_.tradeoff.may_be_step(design.values)) part_.tradeoff.add(design);
    if (role == Role::ranks && part_.archive.may_rank(design.values)) {
      part_.archive.add(std::move(design), equals_left_out);
    }
  }

  ExplorationPart& part() { return part_; }
  std::uint64_t kept() const { return kept_; }
  std::uint64_t failed() const { return failed_; }

 private:
  const ExploreOptions& options_;
  ExplorationPart part_;
  std::uint64_t kept_ = 0;
  std::uint64_t failed_ = 0;
};

// `is_exact`: the archives hold all that is wanted, and a step that is in none of them was beaten,
// or counted where it equals another design.
void add_kept(const StoreReader& store, bool same_order, bool is_exact, Ranker& ranker) {
  if (store.keep() == Keep::all) {
    store.for_each_design([&](const EvaluatedDesign& design) {
      ranker.add({design.word, design.values}, 0, Ranker::Role::ranks);
    });
    return;
  }
  // Steps of the trade-off may be in the archive too.
  std::set<std::string> words;
  store.for_each_archived([&](const ArchivedDesign& kept) {
    if (!words.insert(kept.design.word).second) return;
    ranker.add(kept.design, same_order ? kept.equals_left_out : 0, Ranker::Role::ranks);
  });
  store.for_each_step([&](const Design& step) {
    if (!words.insert(step.word).second) return;
    ranker.add(step, 0, is_exact ? Ranker::Role::step : Ranker::Role::ranks);
  });
}

// Designs that the store does not keep, though they may meet what is asked: all but those that fail
// its own constraints, where these are asked for again.
bool lacks_designs(const std::vector<StoredShard>& shards, std::uint64_t kept, bool same_failures) {
  std::uint64_t wanted = 0;
  for (const StoredShard& shard : shards) {
    wanted += shard.record.evaluated;
    if (!same_failures) continue;
    for (const std::uint64_t failures : shard.record.constraint_failures) wanted -= failures;
  }
  return kept < wanted;
}

// Words that are no routings, for whatever reason, are said to be of this file.
ExploreReport concluded(ExplorationPart part, const ExploreOptions& asked,
                        const Catalogue& catalogue, const std::filesystem::path& file) {
  try {
    return explore_report(asked, conclude(std::move(part), asked), {}, catalogue);
  } catch (const InputError& error) {
    throw error.at(file.string());
  }
}

}  // namespace

std::vector<Gap> gaps(const ExploreOptions& stored, const ExploreOptions& asked) {
  std::vector<Gap> gaps;
  if (!is_same_order(stored, asked)) gaps.push_back(Gap::other_order);
  const auto& now = asked.constraints;
  if (!asks_again(stored, asked)) gaps.push_back(Gap::constraint_dropped);
  if (!std::ranges::all_of(now, [&](const Constraint& constraint) {
        return has_too(stored, constraint, asked) ||
               admits_what_is_better(constraint, stored.order);
      })) {
    gaps.push_back(Gap::constraint_elsewhere);
  }
  if (asked.top > stored.top) gaps.push_back(Gap::more_than_kept);
  return gaps;
}

StoredRanking stored_ranking(const StoreReader& store, const ExploreOptions& stored,
                             ExploreOptions asked, const Catalogue& catalogue) {
  asked.references.clear();
  asked.sample = 0;
  StoredRanking ranking;
  if (store.keep() != Keep::all) ranking.gaps = gaps(stored, asked);
  Ranker ranker(asked);
  const std::vector<StoredShard> shards = store.shards();
  add_kept(store, is_same_order(stored, asked), ranking.gaps.empty(), ranker);
  if (!lacks_designs(shards, ranker.kept(), asks_again(stored, asked))) ranking.gaps.clear();
  ExplorationPart& part = ranker.part();
  for (const StoredShard& shard : shards) {
    part.total += shard.record.total;
    part.generated += shard.record.generated;
    part.evaluated += shard.record.evaluated;
    part.without_tensions.add(shard.record.without_tensions);
    part.unconverged += shard.record.unconverged;
    ranking.of_shards = shard.shard.count;
    ++ranking.shards;
  }
  ranking.partial = ranking.shards < ranking.of_shards || part.generated < part.total;
  ranking.kept = ranker.kept();
  ranking.failed = ranker.failed();
  ranking.report = concluded(std::move(part), asked, catalogue, store.file());
  return ranking;
}

}  // namespace reeve::studies
