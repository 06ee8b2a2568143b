// The routings of a set of parts within limits on their parts, at their places in the whole
// enumeration (enumerate/generator.hpp). Also counts the routings beyond the limits between two
// places.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "search/enumerate/generator.hpp"
#include "search/enumerate/tree_generator.hpp"
#include "search/evaluate/objectives.hpp"
#include "search/limits/limited_tendons.hpp"
#include "search/limits/numbered_parts.hpp"

namespace reeve::search {

// The routings with floating blocks whose parts are within limits, in the order and at the places
// of all of them (enumerate/tree_generator.hpp), for identical fingers.
//
// Sets of trees that leave the tendons beside them no way to stay within the limits are passed over
// by their numbers (numbered_parts.hpp); beside the others only such tendons are tried.
class LimitedTrees {
 public:
  // Keeps the classes.
  LimitedTrees(const PartClasses& classes, const GeneratorOptions& options);

  std::uint64_t total() const { return trees_.total(); }
  ClassCounts counts_before(std::uint64_t index);

  // The next call of next() gives the first routing from this index on that is within the limits.
  void seek(std::uint64_t index);
  // False when all have been given. Keeps the memory of `routing`.
  bool next(Routing& routing, std::uint64_t& place);

  // Returns the place of a canonical routing with blocks, whatever its parts, if it is in the
  // enumeration. Searches the routings whose trees have as many parts.
  std::optional<std::uint64_t> place_of(const Routing& routing);

  std::uint64_t steps() const { return steps_ + beside_.steps(); }

  void stop_with(const StopCheck& check) { beside_.stop_with(check); }

 private:
  struct LimitedCell {
    NumberedParts::Sort sets = 0;
    NumberedParts::Goal goal = 0;  // limit on the sets
    int others = 0;                // number of fingers beside the trees
    std::uint64_t begin = 0;       // index of its first routing
  };

  bool next_set();
  void start_beside(std::uint64_t index);
  bool next_beside(std::uint64_t& index);

  const PartClasses& classes_;
  TreeGenerator trees_;
  NumberedParts parts_;
  LimitedTendons beside_;
  std::vector<LimitedCell> cells_;  // parallel to the generator's cells

  std::size_t cell_ = 0;
  std::uint64_t next_set_ = 0;
  std::optional<NumberedParts::Found> set_;  // the set being listed
  bool alone_ = false;                       // true if its trees have all fingers and it is unread
  Routing of_others_;
  std::uint64_t steps_ = 0;
};

class LimitedGenerator {
 public:
  // Takes as many of the first constraints as parts decide. Fingers must be identical.
  LimitedGenerator(const GeneratorOptions& options, const std::vector<Constraint>& constraints);
  // Not copied: members point at each other.
  LimitedGenerator(const LimitedGenerator&) = delete;
  LimitedGenerator& operator=(const LimitedGenerator&) = delete;

  std::uint64_t total() const { return total_; }

  // The next call of next() gives the first that is within the limits from this place on.
  void seek(std::uint64_t place);
  // False when all have been given. Keeps the memory of `routing`.
  bool next(Routing& routing, std::uint64_t& place);

  // Gives no tendons without blocks that begin in an unwanted way. False if it cannot.
  bool leave_out_unwanted(const Hardware& hardware, IsWanted is_wanted) {
    return tendons_.leave_out_unwanted(hardware, std::move(is_wanted));
  }

  // Counts the routings at places below this one by verdict (part_classes.hpp): within the limits,
  // not actuated, and for each constraint those that it is the first to reject.
  std::vector<std::uint64_t> verdicts_before(std::uint64_t place);
  std::size_t verdict(const Routing& routing) const {
    return classes_.verdict(classes_.of(routing));
  }

  // Returns the place of a canonical routing, whatever its parts, if it is in the enumeration.
  std::optional<std::uint64_t> place_of(const Routing& routing);

  // Returns the number of tendons and sets of trees examined, given or not.
  std::uint64_t steps() const { return tendons_.steps() + (trees_ ? trees_->steps() : 0); }

  void stop_with(const StopCheck& check) {
    tendons_.stop_with(check);
    if (trees_) trees_->stop_with(check);
  }

 private:
  int fingers_;
  bool bars_;
  PartClasses classes_;
  LimitedTendons tendons_;
  std::unique_ptr<LimitedTrees> trees_;
  std::uint64_t total_ = 0;
};

// Numbers of routings that hang on the motor and meet constraints on their parts. Computed by
// formula from the classes of parts (part_classes.hpp) of tendons and trees.
struct LimitedCounts {
  std::uint64_t meeting = 0;     // all constraints
  std::uint64_t one_tendon = 0;  // … with a single tendon, or tree of tendons
  // Parallel to the constraints: those that each is the first to reject.
  std::vector<std::uint64_t> rejected;
};

// Throws InputError of a constraint that parts do not decide, of more sums of parts than classes
// hold, and where fingers are told apart.
LimitedCounts count_limited(const GeneratorOptions& options,
                            const std::vector<Constraint>& constraints);

}  // namespace reeve::search
