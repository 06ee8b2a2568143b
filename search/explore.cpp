#include "search/explore.hpp"

#include <charconv>
#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "search/batches.hpp"
#include "search/exploration_part.hpp"
#include "search/routing_source.hpp"

namespace reeve::search {

std::vector<Objective> deciding_objectives(const ExploreOptions& options) {
  std::vector<Objective> objectives = within_front_objectives(options.order);
  objectives.push_back(options.tradeoff.by);
  for (const Objective objective : options.order.objectives) objectives.push_back(objective);
  for (const Constraint& constraint : options.constraints) {
    objectives.push_back(constraint.objective);
  }
  return objectives;
}

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

bool find_reaches(ExplorationPart& part, const ExploreOptions& options,
                  const Supervision& supervision) {
  const bool are_known = pruning_constraints(options) == 0;
  const bool is_whole = part.generated == part.total;
  if (are_known || !is_whole || part.evaluated == 0 || !part.archive.members().empty()) return true;
  const ExplorationPart all = search_batches(options, {}, EvaluatedDesigns::all, supervision);
  if (all.generated < all.total) return false;
  part.reaches = all.reaches;
  return true;
}

ExploreResult explore(const ExploreOptions& options, const Supervision& supervision,
                      const Checkpoint& checkpoint, const Searcher& search) {
  if (options.top == 0)
    throw InputError({.what = "top 0", .expected = "at least one design to keep"});
  const auto start = std::chrono::steady_clock::now();
  ExplorationPart part =
      search ? search(options, supervision, checkpoint)
             : search_batches(options, checkpoint, EvaluatedDesigns::that_may_be_kept, supervision);
  const bool told = options.shard.count > 1 || find_reaches(part, options, supervision);
  const Visited visited = part.visited;
  ExploreResult result = conclude(std::move(part), options);
  result.partial |= !told;
  const bool is_one_run = !search && !checkpoint.before && options.shard.count == 1;
  if (is_one_run) result.visited = visited;
  result.made_all = static_cast<bool>(checkpoint.design);
  const auto elapsed = std::chrono::steady_clock::now() - start;
  result.seconds = std::chrono::duration<double>(elapsed).count();
  if (checkpoint.before) result.seconds += checkpoint.before->seconds;
  if (result.record) result.record->seconds = result.seconds;
  return result;
}

}  // namespace reeve::search
