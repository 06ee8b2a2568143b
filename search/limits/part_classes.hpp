// Classes of routings by the sums of parts that constraints bound, no finer than these need.
//
// An objective that counts parts is a sum over tokens and loops, each of which adds 0 or more. A
// class holds such sums, each up to the least whole number c above all bounds on it. Greater sums
// meet and fail the same constraints. Classes therefore add up as sums do,
//   min(a + b, c) = min(min(a, c) + min(b, c), c),
// and the class of a routing follows from the classes of its pieces. A class also has a mark. For a
// tendon or tree it says that it hangs on the motor; for a routing, that one of its trees does not.
#pragma once

#include <bitset>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/performance.hpp"
#include "core/routing.hpp"
#include "search/enumerate/generator_options.hpp"
#include "search/evaluate/objectives.hpp"

namespace reeve::search {

using PartClass = std::uint16_t;
inline constexpr std::size_t most_classes = 256;
using ClassSet = std::bitset<most_classes>;

// Verdicts on a routing. failing(c): constraint c, from 0, is the first that it fails.
inline constexpr std::size_t within_limits = 0;
inline constexpr std::size_t not_actuated = 1;
constexpr std::size_t failing(std::size_t c) { return c + 2; }

// True if the objective is a number of parts that adds up over tendons.
bool counts_parts(Objective objective);

// Returns how many of the first constraints parts alone decide, as far as classes last. Constraints
// behind one that parts do not decide cannot tell whether they are the first to fail.
std::size_t decided_by_parts(const std::vector<Constraint>& constraints,
                             const GeneratorOptions& generator);

class PartClasses {
 public:
  // All routings are alike, actuated or not, and within the limits.
  PartClasses() : count_(1), mark_(0) { number_all(); }
  // Takes as many of the first constraints as parts decide.
  PartClasses(const std::vector<Constraint>& constraints, const GeneratorOptions& generator);

  std::size_t constraints() const { return constraints_.size(); }
  std::size_t count() const { return count_; }

  static constexpr PartClass none = 0;
  PartClass plus(PartClass a, PartClass b) const {
    return sums_[std::size_t{a} * count_ + std::size_t{b}];
  }
  // Class of a tendon's part. The mark says that it is on the carriage.
  PartClass of(const Token& token) const;
  PartClass of_loop() const { return loop_; }
  PartClass of(const Tendon& tendon) const;
  // Class of a tree among others. The mark says that it does not hang on the motor.
  PartClass of_tree(PartClass tree) const { return static_cast<PartClass>(tree ^ mark_); }
  // Class of a routing without blocks, or of one tree of a routing with blocks.
  PartClass of(const Routing& routing) const;

  // Returns within_limits, not_actuated or failing(c) for a whole routing.
  std::size_t verdict(PartClass whole) const { return verdicts_[whole]; }
  const ClassSet& admitted_classes() const { return admitted_; }

 private:
  struct Sum {
    Objective objective{};
    std::size_t greatest = 0;
    std::size_t radix = 1;  // weight of the sum in a class number
  };

  PartClass of(const PartCount& parts, bool mark) const;
  std::size_t evaluated(PartClass whole) const;
  void number_all();
  void add_up();

  std::vector<Constraint> constraints_;
  std::vector<Sum> sums_of_;
  std::size_t count_ = 2;
  unsigned mark_ = 1;            // the last bit of a class, unless all are alike
  std::vector<PartClass> sums_;  // [a * count + b]
  std::vector<PartClass> of_tokens_;
  PartClass loop_ = none;
  std::vector<std::size_t> verdicts_;
  ClassSet admitted_;
};

}  // namespace reeve::search
