// Where an exploration has its routings from: all of a range that hang on the motor, or, where the
// first of its constraints bound nothing but parts, those of them that meet these, in the same
// order and at the same places. What such constraints reject is then counted, not made.
//
// A constraint behind one that needs tensions takes no part: which of both is the first to reject a
// design is known only when the tensions are.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "search/explore.hpp"
#include "search/limits/limited_generator.hpp"
#include "search/stop_check.hpp"

namespace reeve::search {

// How many of the first constraints keep routings from being made, whatever the friction. None
// where fingers are told apart.
std::size_t pruning_constraints(const ExploreOptions& options);

class RoutingSource {
 public:
  RoutingSource(const ExploreOptions& options, bool prunes);

  std::uint64_t total() const { return all_.total(); }

  // Whether all ways from step to step are to end: what is asked for then throws WayStopped, and
  // has to be sought again. Nothing: never.
  void stop_with(const std::atomic<bool>* stop);

  // The next call of next() gives the first from `begin` on.
  void seek(std::uint64_t begin, std::uint64_t end);
  // False behind the last before the end. Keeps the memory of `routing`.
  bool next(Routing& routing, std::uint64_t& place);

  // Of the routings before this place that are not given, how many each of the pruning constraints
  // is the first to reject. Quick behind what was gone through; elsewhere as long as a seek.
  std::vector<std::uint64_t> left_out_before(std::uint64_t place);

  struct LeftOutPlace {
    std::uint64_t place = 0;
    std::size_t constraint = 0;
  };
  // Where it is not given for a constraint, if it is among all. Canonical.
  std::optional<LeftOutPlace> place_left_out(const Routing& routing);

 private:
  RoutingGenerator all_;
  bool prunes_;
  std::optional<LimitedGenerator> limited_;
  std::uint64_t place_ = 0;
  std::uint64_t end_ = 0;
  StopCheck check_;
};

}  // namespace reeve::search
