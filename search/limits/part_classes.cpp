#include "search/limits/part_classes.hpp"

#include <algorithm>
#include <cmath>

#include "search/evaluate/tendon_sums.hpp"

namespace reeve::search {
namespace {

constexpr Objective counting_objectives[] = {Objective::sheaths, Objective::pulleys,
                                             Objective::knots, Objective::blocks, Objective::parts};

// More than any routing has of anything that is counted: of a finger and what joins it to the next,
// or of a block and an end, four each.
double most_counted(const GeneratorOptions& generator) {
  return 4.0 * (2 * generator.fingers + 2 * generator.parts.blocks + 2);
}

// The least number that is above the bound, or above all that there can be.
std::size_t first_above(double bound, const GeneratorOptions& generator) {
  return static_cast<std::size_t>(std::clamp(std::floor(bound) + 1, 0.0, most_counted(generator)));
}

std::size_t counted(const PartCount& parts, Objective objective) {
  DesignOutcome outcome;
  outcome.parts = parts;
  return static_cast<std::size_t>(row(objective).compute(outcome));
}

std::size_t token_key(const Token& token) {
  return 2 * static_cast<std::size_t>(token.kind) + (token.tip == TipKind::bearing ? 1 : 0);
}

struct CountedSum {
  Objective objective{};
  std::size_t greatest = 0;
};

// Returns the sums that the first `many` constraints bound.
std::vector<CountedSum> sums_for(const std::vector<Constraint>& constraints, std::size_t many,
                                 const GeneratorOptions& generator) {
  std::vector<CountedSum> sums;
  for (std::size_t c = 0; c < many; ++c) {
    const std::size_t above = first_above(constraints[c].bound, generator);
    const auto same = std::find_if(sums.begin(), sums.end(), [&](const CountedSum& sum) {
      return sum.objective == constraints[c].objective;
    });
    if (same == sums.end()) {
      sums.push_back({constraints[c].objective, above});
    } else {
      same->greatest = std::max(same->greatest, above);
    }
  }
  return sums;
}

std::size_t classes_of(const std::vector<CountedSum>& sums) {
  std::size_t classes = 2;
  for (const CountedSum& sum : sums) classes *= sum.greatest + 1;
  return classes;
}

}  // namespace

bool counts_parts(Objective objective) {
  return std::find(std::begin(counting_objectives), std::end(counting_objectives), objective) !=
         std::end(counting_objectives);
}

std::size_t decided_by_parts(const std::vector<Constraint>& constraints,
                             const GeneratorOptions& generator) {
  std::size_t many = 0;
  while (many < constraints.size() && counts_parts(constraints[many].objective) &&
         classes_of(sums_for(constraints, many + 1, generator)) <= most_classes) {
    ++many;
  }
  return many;
}

PartClasses::PartClasses(const std::vector<Constraint>& constraints,
                         const GeneratorOptions& generator) {
  const std::size_t many = decided_by_parts(constraints, generator);
  constraints_.assign(constraints.begin(), constraints.begin() + static_cast<std::ptrdiff_t>(many));
  for (const CountedSum& sum : sums_for(constraints, many, generator)) {
    sums_of_.push_back({sum.objective, sum.greatest, count_});
    count_ *= sum.greatest + 1;
  }
  number_all();
}

void PartClasses::number_all() {
  add_up();
  for (std::size_t key = 0; key <= 2 * static_cast<std::size_t>(TokenKind::movable_pulley) + 1;
       ++key) {
    const Token token{static_cast<TokenKind>(key / 2),
                      key % 2 == 1 ? TipKind::bearing : TipKind::tube};
    of_tokens_.push_back(of(parts_of(token), is_on_carriage(token.kind)));
  }
  PartCount knot;
  knot.knots = 1;
  loop_ = of(knot, false);
  for (std::size_t whole = 0; whole < count_; ++whole) {
    verdicts_.push_back(evaluated(static_cast<PartClass>(whole)));
    if (verdicts_.back() == within_limits) admitted_.set(whole);
  }
}

void PartClasses::add_up() {
  for (std::size_t a = 0; a < count_; ++a) {
    for (std::size_t b = 0; b < count_; ++b) {
      std::size_t sum = (a | b) & mark_;
      for (const Sum& of : sums_of_) {
        const std::size_t size = of.greatest + 1;
        const std::size_t both = a / of.radix % size + b / of.radix % size;
        sum += std::min(both, of.greatest) * of.radix;
      }
      sums_.push_back(static_cast<PartClass>(sum));
    }
  }
}

PartClass PartClasses::of(const PartCount& parts, bool mark) const {
  std::size_t number = mark ? mark_ : 0;
  for (const Sum& sum : sums_of_) {
    number += std::min(counted(parts, sum.objective), sum.greatest) * sum.radix;
  }
  return static_cast<PartClass>(number);
}

PartClass PartClasses::of(const Token& token) const { return of_tokens_[token_key(token)]; }

PartClass PartClasses::of(const Tendon& tendon) const {
  PartClass sum = tendon.closed ? loop_ : none;
  for (const Token& token : tendon.walk) sum = plus(sum, of(token));
  return sum;
}

PartClass PartClasses::of(const Routing& routing) const {
  const std::vector<std::size_t> tree_of = trees(routing);
  std::vector<PartClass> of_trees(routing.tendons.size(), none);
  std::size_t many = 0;
  for (std::size_t t = 0; t < routing.tendons.size(); ++t) {
    PartClass& tree = of_trees[tree_of[t]];
    tree = plus(tree, of(routing.tendons[t]));
    many = std::max(many, tree_of[t] + 1);
  }
  PartClass sum = none;
  for (std::size_t t = 0; t < many; ++t) sum = plus(sum, of_tree(of_trees[t]));
  return sum;
}

std::size_t PartClasses::evaluated(PartClass whole) const {
  if ((whole & mark_) != 0) return not_actuated;
  ObjectiveValues values{};
  for (const Sum& sum : sums_of_) {
    value(values, sum.objective) = static_cast<double>(whole / sum.radix % (sum.greatest + 1));
  }
  const std::size_t failed = first_failure(constraints_, values);
  return failed == 0 ? within_limits : failing(failed - 1);
}

}  // namespace reeve::search
