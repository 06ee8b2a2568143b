// The parts of the things of a grammar (enumerate/grammar.hpp), for identical fingers.
//
// How many things of each class there are is known of every sort. So without making any of them one
// can say
//   - how many of those below an index have which parts, and
//   - which is the next from an index on whose parts are within limits: what cannot meet the limits
//     is passed over at once.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "search/enumerate/grammar.hpp"
#include "search/limits/class_counts.hpp"

namespace reeve::search {

class NumberedParts {
 public:
  using Sort = Grammar::Sort;
  // Sums of parts that are wanted of a thing together with what is beside it.
  using Goal = std::size_t;

  // Keeps both.
  NumberedParts(const PartClasses& classes, const Grammar& grammar)
      : classes_(classes), grammar_(grammar) {}

  const ClassCounts& counts(Sort sort);
  PartClass parts_of(Sort sort, std::uint64_t index) const;
  ClassCounts counts_before(Sort sort, std::uint64_t index);

  Goal goal(const ClassSet& wanted);
  struct Found {
    std::uint64_t index = 0;
    PartClass parts = PartClasses::none;
  };
  // The first from this index on that meets the goal.
  std::optional<Found> first(Sort sort, std::uint64_t from, Goal goal) {
    return first(sort, from, PartClasses::none, goal);
  }

 private:
  using Form = Grammar::Form;
  // A multiset of so many numbers below a limit.
  struct Choice {
    Sort of = 0;
    int many = 0;
    std::uint64_t below = 0;
  };

  std::uint64_t size(Sort sort) const { return grammar_.size(sort); }
  Choice choice(const Grammar::Node& node) const {
    return {node.of[0], node.many, size(node.of[0])};
  }
  PartClass of_kind(const Grammar::Kind& kind) const;
  // Returns the class that a part adds to the thing that it is made of.
  PartClass added(const Grammar::Node& part) const;
  ClassCounts counted(const Grammar::Node& node);
  PartClass parts_of(const Choice& choice, std::uint64_t index) const;
  ClassCounts counts_before(const Choice& choice, std::uint64_t index);
  ClassCounts counts_before_of_several(const Grammar::Node& node, std::uint64_t index);
  ClassCounts counts_before_of_both(const Grammar::Node& node, std::uint64_t index);

  std::optional<Found> first(Sort sort, std::uint64_t from, PartClass beside, Goal goal);
  std::optional<Found> first_of_kinds(Sort sort, std::uint64_t from, PartClass beside, Goal goal);
  std::optional<Found> first_of_several(Sort sort, std::uint64_t from, PartClass beside, Goal goal);
  std::optional<Found> first_of_both(Sort sort, std::uint64_t from, PartClass beside, Goal goal);
  std::optional<Found> first_of_choice(const Choice& choice, std::uint64_t from, PartClass beside,
                                       Goal goal);
  // Returns the sums that something of this sort completes to the goal.
  Goal completed_by(Sort sort, Goal goal);
  // Returns the goal for trees by themselves that stand beside these parts.
  Goal of_trees_alone(PartClass beside, Goal goal);
  bool can_meet(Sort sort, PartClass beside, Goal goal);

  const PartClasses& classes_;
  const Grammar& grammar_;
  std::vector<ClassCounts> counts_;  // [sort], as far as they were asked for
  std::vector<ClassSet> goals_;
  std::unordered_map<ClassSet, Goal> goal_of_;
  std::map<std::tuple<Goal, Sort>, Goal> completed_;
  std::map<std::tuple<Goal, PartClass>, Goal> alone_;
};

}  // namespace reeve::search
