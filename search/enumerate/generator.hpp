// The routings that a set of parts allows, all or those within limits on their parts, one after the
// other, each once, by canonical word, and at their places among all. Also counts the routings
// beyond the limits between two places.
//
// Those without floating blocks come first, in canonical order (tendon_generator.hpp), then those
// with one, with two, … (tree_generator.hpp). Routings of several motors follow in the order of the
// routings of one that they are if all carriages are taken for one (numbering.hpp).
//
// `seek` starts at any index by reckoning how many lie before it, so that shards partition the
// whole without talking to each other. With several motors it goes there step by step.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/hardware.hpp"
#include "core/value_use.hpp"
#include "search/enumerate/generator_options.hpp"
#include "search/enumerate/numbering.hpp"
#include "search/enumerate/tendon_generator.hpp"
#include "search/enumerate/tree_generator.hpp"
#include "search/limits/part_classes.hpp"

namespace reeve::search {

class RoutingGenerator {
 public:
  // Classes that set limits are for identical fingers and one motor. Throws InputError on
  // impossible parts or numbers of fingers.
  explicit RoutingGenerator(const GeneratorOptions& options, PartClasses classes = {});
  // Not copied: members point at each other.
  RoutingGenerator(const RoutingGenerator&) = delete;
  RoutingGenerator& operator=(const RoutingGenerator&) = delete;

  std::uint64_t total() const { return total_; }

  // The next call of next() gives the first that is within the limits from this place on.
  void seek(std::uint64_t place);

  // False when all have been given. Keeps the memory of `routing`.
  bool next(Routing& routing, std::uint64_t& place);
  bool next(Routing& routing) {
    std::uint64_t place = 0;
    return next(routing, place);
  }

  // Gives no tendons without blocks that begin in an unwanted way. False if it cannot.
  bool leave_out_unwanted(const Hardware& hardware, IsWanted is_wanted) {
    return tendons_.shapes().leave_out_unwanted(hardware, std::move(is_wanted));
  }

  // Counts the routings at places below this one by verdict (part_classes.hpp): within the limits,
  // not actuated, and for each constraint those that it is the first to reject.
  std::vector<std::uint64_t> verdicts_before(std::uint64_t place);
  std::size_t verdict(const Routing& routing) const {
    return classes_.verdict(classes_.of(routing));
  }

  // Returns the place of a canonical routing of identical fingers and one motor, whatever its
  // parts, if it is in the enumeration. seek() again afterwards.
  std::optional<std::uint64_t> place_of(const Routing& routing);

  // Returns the number of tendons and sets of trees examined, given or not.
  std::uint64_t steps() { return tendons_.shapes().steps() + (trees_ ? trees_->steps() : 0); }

  void stop_with(const StopCheck& check);

 private:
  bool next_of_one_motor(Routing& routing, std::uint64_t& place);
  bool next_of_motors(Routing& routing);
  void seek_of_one_motor(std::uint64_t place);

  int fingers_;
  bool bars_;
  PartClasses classes_;
  TendonGenerator tendons_;
  std::optional<TreeGenerator> trees_;
  std::uint64_t total_ = 0;
  bool is_placed_ = false;  // false before the first seek

  std::optional<CarriageNumbering> carriages_;  // set for several motors
  Routing of_one_motor_;                        // the routing that gets motor numbers
  std::uint64_t place_ = 0;                     // place of the next routing of several motors
  StopCheck check_;
};

// The i-th of n parts of 0 … total, i from 1: all parts together are exactly the whole.
ShardRange shard_range(std::uint64_t total, std::uint64_t i, std::uint64_t n);

// Returns the keys of the hardware's values that act at no contact of any of the routings
// (core/idle_values.hpp). Of a large enumeration the first are looked at; what is idle in them
// counts as possible, unless it is of a contact whose segments cannot touch in any routing.
std::vector<std::string> impossible_values(const Hardware& hardware,
                                           const GeneratorOptions& options);

// Shows the first routings to `use`, and more of them as long as no contact takes its value.
void look_at(const GeneratorOptions& options, ValueUse& use);

}  // namespace reeve::search
