#include "search/exploration_part.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "core/error.hpp"
#include "core/notation.hpp"
#include "numerics/parallel.hpp"
#include "search/batches.hpp"
#include "search/evaluate/deciding_evaluation.hpp"
#include "search/evaluate/evaluation.hpp"
#include "search/routing_source.hpp"

namespace reeve::search {
namespace {

constexpr std::size_t evaluated_at_a_time = 16;
constexpr std::size_t named_as_best = 10;  // a line of a page

// Designs evaluated in full, many at a time.
class Evaluators {
 public:
  explicit Evaluators(const ExploreOptions& options) : workers_(options.threads) {
    for (std::size_t w = 0; w < workers_.count(); ++w) {
      evaluators_.emplace_back(options.model, options.grasps, options.score, options.prices);
      evaluators_.back().share_trees();
    }
  }

  // All values of designs of which there are those by which they were kept, and their routings.
  std::vector<Routing> complete(std::vector<RankedDesign>& listed) {
    std::vector<Routing> routings(listed.size());
    workers_.for_each_block(listed.size(), evaluated_at_a_time, [&](const IndexBlock& block) {
      for (std::size_t i = block.begin; i < block.end; ++i) {
        Design& design = listed[i].design;
        routings[i] = parse_routing(design.word);
        design.values = evaluators_[block.worker].evaluate(routings[i]);
      }
    });
    return routings;
  }

  std::vector<Design> evaluate(const std::vector<Routing>& routings) {
    std::vector<Design> designs(routings.size());
    workers_.for_each_block(routings.size(), evaluated_at_a_time, [&](const IndexBlock& block) {
      for (std::size_t i = block.begin; i < block.end; ++i) {
        designs[i] = {to_word(routings[i]), evaluators_[block.worker].evaluate(routings[i])};
      }
    });
    return designs;
  }

  std::uint64_t unconverged() const {
    std::uint64_t sum = 0;
    for (const DesignEvaluator& evaluator : evaluators_) sum += evaluator.unconverged();
    return sum;
  }

 private:
  Workers workers_;
  std::vector<DesignEvaluator> evaluators_;
};

// Parallel to the designs.
std::vector<ReferenceStanding> standings(std::vector<Design> designs,
                                         const std::vector<ReferenceCount>& counts,
                                         const std::vector<RankedDesign>& listed) {
  std::vector<ReferenceStanding> standings;
  std::unordered_multimap<std::string_view, std::size_t> places;
  standings.reserve(designs.size());
  for (std::size_t r = 0; r < designs.size(); ++r) {
    standings.push_back({std::move(designs[r]), counts[r].dominated_by, 0, 0, counts[r].generated,
                         counts[r].rejected_by});
    places.emplace(standings.back().design.word, r);
  }
  for (const RankedDesign& ranked : listed) {
    const auto [begin, end] = places.equal_range(ranked.design.word);
    for (auto found = begin; found != end; ++found) {
      standings[found->second].rank = ranked.rank;
      standings[found->second].front = ranked.front;
    }
  }
  return standings;
}

std::vector<Rejection> rejections(const ExplorationPart& part) {
  const std::uint64_t actuated = part.evaluated + part.without_tensions.count;
  std::vector<Rejection> rejected{{std::nullopt, part.generated - actuated}};
  for (std::size_t c = 0; c < part.constraint_failures.size(); ++c) {
    rejected.push_back({c, part.constraint_failures[c]});
  }
  return rejected;
}

// Returns nothing if no routing was evaluated, so that no constraint is to blame.
std::vector<ConstraintReach> infeasible(const ExplorationPart& part) {
  const bool is_whole = part.generated == part.total;
  return is_whole && part.evaluated > 0 ? part.reaches.list() : std::vector<ConstraintReach>{};
}

// Number of designs that the first constraints reject for their parts alone.
std::uint64_t pruned_designs(const ExplorationPart& part, const ExploreOptions& options) {
  const auto begin = part.constraint_failures.begin();
  const auto many = static_cast<std::ptrdiff_t>(pruning_constraints(options));
  return std::accumulate(begin, begin + many, std::uint64_t{0});
}

// Throws InputError on a word that is no routing of this exploration.
Routing generated_routing(const std::string& word, const ExploreOptions& options) {
  Routing routing = parse_routing(word);
  if (finger_count(routing) == options.generator.fingers && is_actuated(routing)) return routing;
  throw InputError({.what = "routing",
                    .value = word,
                    .expected = fmt::format("one of {} fingers that the motor pulls",
                                            options.generator.fingers)});
}

// Empty if there is no such design.
std::string why_without_tensions(const WithoutTensions& designs, const ExploreOptions& options) {
  if (designs.count == 0) return "";
  try {
    DecidingEvaluator(options.model, options.grasps, options.score, options.prices,
                      deciding_objectives(options))
        .evaluate(generated_routing(designs.example, options));
  } catch (const OutOfRange& error) {
    return error.what();
  }
  return "";
}

// The first `top` and the front: beyond these the archive has gaps, so that no rank there is one.
std::vector<RankedDesign> listed_of(std::vector<RankedDesign> ranked, std::size_t top) {
  const auto end = std::find_if(ranked.begin(), ranked.end(), [&](const RankedDesign& design) {
    return design.front > 1 && design.rank > top;
  });
  ranked.erase(end, ranked.end());
  return ranked;
}

// These were evaluated before, as far as they count among the solves.
void complete_tradeoff(Tradeoff& tradeoff, const ExploreOptions& options) {
  DesignEvaluator evaluator(options.model, options.grasps, options.score, options.prices);
  const auto complete = [&](Design& design) {
    design.values = evaluator.evaluate(parse_routing(design.word));
  };
  for (TradeoffStep& step : tradeoff.steps) complete(step.design);
  if (tradeoff.affordable) complete(*tradeoff.affordable);
  if (tradeoff.choice) {
    complete(tradeoff.choice->without);
    complete(tradeoff.choice->with);
  }
}

// Both are the beginning of one ranking.
void place_listed(ExploreResult& result, std::vector<RankedDesign> listed,
                  std::vector<Routing> routings, std::size_t top) {
  const auto behind_front = std::find_if(listed.begin(), listed.end(),
                                         [](const RankedDesign& each) { return each.front > 1; });
  const auto behind_top =
      listed.begin() + static_cast<std::ptrdiff_t>(std::min(top, listed.size()));
  result.best = best_by_objective(listed, named_as_best);
  result.routings = std::move(routings);
  if (behind_top == listed.end()) {
    result.front.assign(listed.begin(), behind_front);
    result.top = std::move(listed);
  } else {
    result.top.assign(listed.begin(), behind_top);
    result.front = std::move(listed);
  }
}

// Unknown reaches are empty.
std::vector<ConstraintReach> recorded_reaches(const ExplorationPart& part) {
  std::vector<ConstraintReach> reaches = part.reaches.list();
  reaches.resize(part.constraint_failures.size());
  return reaches;
}

std::vector<Routing> generated_routings(const std::vector<std::string>& words,
                                        const ExploreOptions& options) {
  std::vector<Routing> routings;
  for (const std::string& word : words) routings.push_back(generated_routing(word, options));
  return routings;
}

ExplorationPart counted_part(const ShardRecord& record, const ExploreOptions& options) {
  ExplorationPart part(options);
  static_cast<ExplorationCounts&>(part) = static_cast<const ExplorationCounts&>(record);
  if (pruning_constraints(options) == 0) part.reaches = ConstraintReaches(record.reaches);
  for (const SampledWord& sampled : record.sample) {
    part.sample.add(sampled.place, generated_routing(sampled.word, options));
  }
  return part;
}

// Adds records to a part; holds its own options, workers and evaluators.
class RecordAbsorber {
 public:
  RecordAbsorber(ExploreOptions options, bool with_all_values)
      : options_(std::move(options)), workers_(options_.threads) {
    for (std::size_t w = 0; w < workers_.count(); ++w) {
      deciding_.emplace_back(options_.model, options_.grasps, options_.score, options_.prices,
                             deciding_objectives(options_));
      if (!with_all_values) continue;
      in_full_.emplace_back(options_.model, options_.grasps, options_.score, options_.prices);
      in_full_.back().share_trees();
    }
  }

  void absorb(ExplorationPart& whole, const ShardRecord& record) {
    ExplorationPart part = counted_part(record, options_);
    std::vector<std::string> archived;
    for (const ArchivedWord& kept : record.archive) archived.push_back(kept.word);
    add(
        archived, [&](const ObjectiveValues& v) { return whole.archive.may_rank(v); },
        [&](Design design, std::size_t i) {
          part.archive.add(std::move(design), record.archive[i].equals_left_out);
        });
    add(
        record.steps, [&](const ObjectiveValues& v) { return whole.tradeoff.may_be_step(v); },
        [&](Design design, std::size_t) { part.tradeoff.add(std::move(design)); });
    whole.absorb(part);
  }

 private:
  template <typename Wanted, typename Add>
  void add(const std::vector<std::string>& words, const Wanted& wanted, const Add& add_design) {
    const std::vector<Routing> routings = generated_routings(words, options_);
    std::vector<std::optional<Design>> designs(words.size());
    workers_.for_each_block(words.size(), evaluated_at_a_time, [&](const IndexBlock& block) {
      for (std::size_t i = block.begin; i < block.end; ++i) {
        const ObjectiveValues values = deciding_[block.worker].evaluate(routings[i]);
        if (!wanted(values)) continue;
        designs[i] = {words[i],
                      in_full_.empty() ? values : in_full_[block.worker].evaluate(routings[i])};
      }
    });
    for (std::size_t i = 0; i < designs.size(); ++i) {
      if (designs[i]) add_design(std::move(*designs[i]), i);
    }
  }

  ExploreOptions options_;
  Workers workers_;
  std::vector<DecidingEvaluator> deciding_;  // one for each thread
  std::vector<DesignEvaluator> in_full_;     // likewise, or none
};

}  // namespace

void WithoutTensions::add(const WithoutTensions& other) {
  const auto comes_before = [](const std::string& a, const std::string& b) {
    return a.size() != b.size() ? a.size() < b.size() : a < b;
  };
  if (other.count == 0) return;
  if (count == 0 || comes_before(other.example, example)) example = other.example;
  count += other.count;
}

ExplorationPart::ExplorationPart(const ExploreOptions& options)
    : ExplorationCounts{.constraint_failures =
                            std::vector<std::uint64_t>(options.constraints.size(), 0),
                        .references = std::vector<ReferenceCount>(options.references.size())},
      reaches(pruning_constraints(options) > 0 ? 0 : options.constraints.size()),
      archive(options.order, options.top),
      tradeoff(options.order, options.tradeoff.by),
      sample(options.sample) {}

void ExplorationPart::absorb(ExplorationPart& other) {
  total += other.total;
  generated += other.generated;
  evaluated += other.evaluated;
  without_tensions.add(other.without_tensions);
  unconverged += other.unconverged;
  seconds += other.seconds;
  visited += other.visited;
  for (std::size_t c = 0; c < constraint_failures.size(); ++c) {
    constraint_failures[c] += other.constraint_failures[c];
  }
  reaches.add(other.reaches);
  for (std::size_t r = 0; r < references.size(); ++r) {
    ReferenceCount& mine = references[r];
    const ReferenceCount& theirs = other.references[r];
    mine.dominated_by += theirs.dominated_by;
    mine.generated = mine.generated || theirs.generated;
    if (theirs.rejected_by) mine.rejected_by = theirs.rejected_by;
  }
  for (ArchivedDesign& member : other.archive.members()) {
    archive.add(std::move(member.design), member.equals_left_out);
  }
  for (Design& design : other.tradeoff.candidates()) tradeoff.add(std::move(design));
  for (SampledRouting& sampled : other.sample.members()) {
    sample.add(sampled.place, sampled.routing);
  }
}

ShardRecord record_of(ExplorationPart& part) {
  ShardRecord record{
      static_cast<const ExplorationCounts&>(part), recorded_reaches(part), {}, {}, {}};
  for (ArchivedDesign& member : part.archive.members()) {
    record.archive.push_back({std::move(member.design.word), member.equals_left_out});
  }
  for (Design& design : part.tradeoff.candidates()) record.steps.push_back(std::move(design.word));
  for (const SampledRouting& sampled : part.sample.members()) {
    record.sample.push_back({sampled.place, to_word(sampled.routing)});
  }
  return record;
}

ExplorationPart part_of(const ShardRecord& record, const ExploreOptions& options) {
  ExplorationPart part(options);
  RecordAbsorber(options, true).absorb(part, record);
  return part;
}

RecordAbsorbing record_absorbing(const ExploreOptions& options, bool with_all_values) {
  return
      [absorber = std::make_shared<RecordAbsorber>(options, with_all_values)](
          ExplorationPart& whole, const ShardRecord& record) { absorber->absorb(whole, record); };
}

ExploreResult conclude(ExplorationPart part, const ExploreOptions& options) {
  ExploreResult result;
  result.total = part.total;
  result.generated = part.generated;
  result.partial = part.generated < part.total;
  result.evaluated = part.evaluated;
  result.without_tensions = part.without_tensions;
  result.why_without_tensions = why_without_tensions(part.without_tensions, options);
  result.seconds = part.seconds;
  result.rejected = rejections(part);
  result.pruned = pruned_designs(part, options);
  if (options.keeps_record) result.record = record_of(part);
  Archive::Content content = std::move(part.archive).content();
  result.front_equals_left_out = content.front_equals_left_out;
  Evaluators evaluators(options);
  std::vector<RankedDesign> listed = listed_of(std::move(content.ranked), options.top);
  std::vector<Routing> routings = evaluators.complete(listed);
  if (listed.empty()) {
    result.infeasible = infeasible(part);
  } else {
    result.tradeoff = tradeoff(part.tradeoff.candidates(), listed.front().design, options.order,
                               options.tradeoff);
    complete_tradeoff(result.tradeoff, options);
  }
  result.references = standings(evaluators.evaluate(options.references), part.references, listed);
  place_listed(result, std::move(listed), std::move(routings), options.top);
  result.sample = evaluators.evaluate(part.sample.routings());
  result.unconverged = part.unconverged + evaluators.unconverged();
  return result;
}

ExploreResult conclude(const std::vector<ShardRecord>& shards, const ExploreOptions& options,
                       const Supervision& supervision) {
  RecordAbsorber absorber(options, true);
  ExplorationPart whole(options);
  for (const ShardRecord& shard : shards) {
    try {
      absorber.absorb(whole, shard);
    } catch (const InputError& error) {
      // Words that are no routings are said to be of the file.
      throw shard.origin.empty() ? error : error.at(shard.origin);
    }
  }
  const bool told = find_reaches(whole, options, supervision);
  ExploreResult result = conclude(std::move(whole), options);
  result.partial |= !told;
  return result;
}

}  // namespace reeve::search
