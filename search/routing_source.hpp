// Source of the routings of an exploration: all routings of a range that hang on the motor.
//
// If the first constraints bound only parts, the source gives just the routings that meet them, in
// the same order and at the same places. Rejected routings are then counted, not made.
//
// A constraint behind one that needs tensions does not prune: only tensions tell which of the two
// is the first to reject a design.
//
// Likewise, what begins in a way in which nothing can be kept is counted, not made, where there are
// no floating blocks and fingers are identical.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "search/enumerate/generator.hpp"
#include "search/explore.hpp"
#include "search/limits/limited_tendons.hpp"
#include "search/stop_check.hpp"

namespace reeve::search {

// Returns how many of the first constraints prune the generation, whatever the friction. Returns 0
// for distinct fingers, several motors and joins beside ends: all routings are then made.
std::size_t pruning_constraints(const ExploreOptions& options);

class RoutingSource {
 public:
  RoutingSource(const ExploreOptions& options, bool prunes);

  std::uint64_t total() const { return generator_.total(); }

  // If `*stop` becomes true, all calls throw WayStopped; seek() again afterwards. nullptr: never.
  void stop_with(const std::atomic<bool>* stop);

  // The next call of next() gives the first from `begin` on.
  void seek(std::uint64_t begin, std::uint64_t end);
  // False behind the last before the end. Keeps the memory of `routing`.
  bool next(Routing& routing, std::uint64_t& place);

  // Gives no tendons without blocks that begin in an unwanted way. False if it cannot.
  bool leave_out_unwanted(const Hardware& hardware, IsWanted is_wanted);

  // True if it gives fewer than all actuated routings.
  bool leaves_out() const { return prunes_ || leaves_out_unwanted_; }

  // Routings before a place. Quick behind places passed already; elsewhere as slow as a seek.
  // Counted by verdict (limits/part_classes.hpp) on the pruning constraints.
  std::vector<std::uint64_t> verdicts_before(std::uint64_t place) {
    return generator_.verdicts_before(place);
  }

  struct LeftOutPlace {
    std::uint64_t place = 0;
    std::size_t constraint = 0;
  };
  // Returns the place of a canonical routing that a constraint leaves out. Returns nothing if it is
  // given or not in the enumeration.
  std::optional<LeftOutPlace> place_left_out(const Routing& routing);

 private:
  bool prunes_;
  bool is_limited_;  // true if the generator passes over what hangs on no motor
  bool leaves_out_unwanted_ = false;
  RoutingGenerator generator_;
  std::uint64_t end_ = 0;
  StopCheck check_;
};

}  // namespace reeve::search
