// Things that are numbered from 0 and made of choices, with what parts each has.
//
// A thing is one of a few kinds, one of several sorts of things one behind the other, a choice for
// each of two things (the first of which varies first), or a multiset of things, greatest number
// first (enumerate/checked.hpp). So the index of a thing is a number of mixed radix, as tree_index
// reads it, and without making any of them one can say
//   - how many of those below an index have which parts, and
//   - which is the next from an index on whose parts are within limits, since how many there are of
//     each class is known of every sort: what cannot meet the limits is passed over at once.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "search/limits/class_counts.hpp"

namespace reeve::search {

class NumberedParts {
 public:
  using Sort = std::size_t;
  // Sums of parts that are wanted of a thing together with what is beside it.
  using Goal = std::size_t;

  // Keeps the classes.
  explicit NumberedParts(const PartClasses& classes) : classes_(classes) {}

  Sort kinds(std::vector<PartClass> of_kinds);
  Sort one_after_the_other(std::vector<Sort> sorts);
  Sort both(Sort first, Sort second);
  Sort all_of(const std::vector<Sort>& sorts);  // the first varies first
  Sort multisets(Sort of, int many);
  Sort with(Sort sort, PartClass parts);
  // Trees, as they stand among others.
  Sort trees(Sort sort);

  std::uint64_t size(Sort sort) const { return nodes_[sort].size; }
  const ClassCounts& counts(Sort sort) const { return nodes_[sort].counts; }
  PartClass parts_of(Sort sort, std::uint64_t index) const;
  ClassCounts counts_before(Sort sort, std::uint64_t index) const;

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
  enum class Form : std::uint8_t { kinds, one_after_the_other, both, multisets, trees };
  struct Node {
    Form form{};
    std::vector<Sort> of;
    std::vector<PartClass> parts;  // class of each kind
    int many = 0;
    std::uint64_t size = 0;
    ClassCounts counts;
  };
  // A multiset of so many numbers below a limit.
  struct Choice {
    Sort of = 0;
    int many = 0;
    std::uint64_t below = 0;
  };

  Sort add(Node node, ClassCounts counts);
  PartClass parts_of(const Choice& choice, std::uint64_t index) const;
  ClassCounts counts_before(const Choice& choice, std::uint64_t index) const;
  ClassCounts counts_before_of_both(const Node& node, std::uint64_t index) const;

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
  std::vector<Node> nodes_;
  std::vector<ClassSet> goals_;
  std::unordered_map<ClassSet, Goal> goal_of_;
  std::map<std::tuple<Goal, Sort>, Goal> completed_;
  std::map<std::tuple<Goal, PartClass>, Goal> alone_;
};

}  // namespace reeve::search
