// Those routings of a set of parts that are within limits on their parts, at the places that they
// have among all (enumerate/generator.hpp), and how many lie beyond the limits between two places.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "search/enumerate/generator.hpp"
#include "search/limits/limited_tendons.hpp"
#include "search/limits/limited_trees.hpp"

namespace reeve::search {

class LimitedGenerator {
 public:
  // For as many of the first constraints as parts decide; fingers must be identical.
  LimitedGenerator(const GeneratorOptions& options, const std::vector<Constraint>& constraints);
  // Its parts point at each other.
  LimitedGenerator(const LimitedGenerator&) = delete;
  LimitedGenerator& operator=(const LimitedGenerator&) = delete;

  std::uint64_t total() const { return total_; }

  // The next call of next() gives the first that is within the limits from this place on.
  void seek(std::uint64_t place);
  // False when all have been given. Keeps the memory of `routing`.
  bool next(Routing& routing, std::uint64_t& place);

  // Of the routings at places below this one, by their verdicts (part_classes.hpp): within the
  // limits, not actuated, and for each constraint those that it is the first to reject.
  std::vector<std::uint64_t> verdicts_before(std::uint64_t place);
  std::size_t verdict(const Routing& routing) const {
    return classes_.verdict(classes_.of(routing));
  }

  // Of a canonical routing, whatever its parts, if it is among all.
  std::optional<std::uint64_t> place_of(const Routing& routing);

  // Tendons and sets of trees that were looked at, given or not.
  std::uint64_t steps() const { return tendons_.steps() + (trees_ ? trees_->steps() : 0); }

  void stop_with(const StopCheck& check) {
    tendons_.stop_with(check);
    if (trees_) trees_->stop_with(check);
  }

 private:
  int fingers_;
  PartClasses classes_;
  LimitedTendons tendons_;
  std::unique_ptr<LimitedTrees> trees_;
  std::uint64_t total_ = 0;
};

}  // namespace reeve::search
