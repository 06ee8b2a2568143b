// Distances to constraints that no design meets together.
//
// For each constraint, the nearest values on both sides of its bound are found, twice: among all
// designs that fail it, and among those that fail only it. Loosening this constraint would admit
// the latter.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "search/evaluate/objectives.hpp"

namespace reeve::search {

// The least value not below the bound, and the greatest not above it, that do not meet it.
struct Nearest {
  std::optional<double> above;
  std::optional<double> below;

  void add(double value, double bound);
  void add(const Nearest& other);
};

struct ConstraintReach {
  bool met = false;  // met by a design that fails another constraint
  Nearest of_all;
  Nearest of_those_that_meet_the_others;
};

class ConstraintReaches {
 public:
  explicit ConstraintReaches(std::size_t constraints) : reaches_(constraints) {}
  explicit ConstraintReaches(std::vector<ConstraintReach> reaches) : reaches_(std::move(reaches)) {}

  // A design that fails at least one of them.
  void add(const std::vector<Constraint>& constraints, const ObjectiveValues& values);
  void add(const ConstraintReaches& others);

  const std::vector<ConstraintReach>& list() const { return reaches_; }

 private:
  std::vector<ConstraintReach> reaches_;  // parallel to the constraints
};

}  // namespace reeve::search
