// What an exploration says of the routings that its source leaves out (routing_source.hpp): they
// count as what was made and rejected for its parts.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "search/exploration_part.hpp"
#include "search/routing_source.hpp"

namespace reeve::search {

class LeftOut {
 public:
  // Of the routings of `range`; those before `counted`, of its first, are in the part already.
  // Keeps the source.
  LeftOut(const ExploreOptions& options, RoutingSource& source, ShardRange range,
          std::uint64_t counted);

  // Another range.
  void go_on_with(ShardRange range, std::uint64_t counted);

  // Those among the first `generated` that were not added before.
  void add_to(ExplorationPart& part, std::uint64_t generated);

 private:
  RoutingSource& source_;
  ShardRange range_;
  std::vector<std::uint64_t> before_;  // of each constraint, at places counted already
  std::vector<std::optional<RoutingSource::LeftOutPlace>> references_;
};

}  // namespace reeve::search
