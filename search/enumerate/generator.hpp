// Every routing that a set of parts allows, one after the other, each once, by canonical word.
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
#include <vector>

#include "core/hardware.hpp"
#include "search/enumerate/generator_options.hpp"
#include "search/enumerate/numbering.hpp"
#include "search/enumerate/tendon_generator.hpp"
#include "search/enumerate/tree_generator.hpp"

namespace reeve::search {

class RoutingGenerator {
 public:
  // Throws InputError on impossible parts or numbers of fingers.
  explicit RoutingGenerator(const GeneratorOptions& options);

  std::uint64_t total() const { return total_; }

  // The next call of next() gives the routing of this index, from 0.
  void seek(std::uint64_t index);

  // False when all have been given. Keeps the memory of `routing`.
  bool next(Routing& routing) {
    return carriages_ ? next_of_motors(routing) : next_of_one_motor(routing);
  }

  void stop_with(const StopCheck& check) {
    tendons_.stop_with(check);
    check_ = check;
  }

 private:
  bool next_of_one_motor(Routing& routing) {
    return tendons_.next(routing) || (trees_ && trees_->next(routing));
  }
  bool next_of_motors(Routing& routing);
  void seek_of_one_motor(std::uint64_t index);

  TendonGenerator tendons_;
  std::optional<TreeGenerator> trees_;
  std::uint64_t total_ = 0;

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

}  // namespace reeve::search
