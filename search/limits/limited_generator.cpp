#include "search/limits/limited_generator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/error.hpp"
#include "core/graph.hpp"
#include "search/enumerate/checked.hpp"

namespace reeve::search {
namespace {

void require_decided(const std::vector<Constraint>& constraints, const GeneratorOptions& options) {
  for (const Constraint& constraint : constraints) {
    if (counts_parts(constraint.objective)) continue;
    throw InputError({.what = "constraint",
                      .value = constraint.text,
                      .expected = "one on sheaths, pulleys, knots, blocks or parts, since others "
                                  "need each design's tensions: explore counts what they reject"});
  }
  const std::size_t decided = decided_by_parts(constraints, options);
  if (decided == constraints.size()) return;
  throw InputError({.what = "constraint",
                    .value = constraints[decided].text,
                    .expected = fmt::format("fewer constraints or smaller bounds: together they "
                                            "tell more than {} sums of parts apart",
                                            most_classes / 2)});
}

std::vector<std::uint64_t> verdicts(const GeneratorOptions& options,
                                    const std::vector<Constraint>& constraints) {
  LimitedGenerator limited(options, constraints);
  return limited.verdicts_before(limited.total());
}

PartSet parts_without_blocks(PartSet parts) {
  parts.blocks = 0;
  return parts;
}

// The tendons that blocks tie together, and the others.
struct TiedTendons {
  Routing tied;
  Routing others;
};

TiedTendons tied_tendons(const Routing& routing) {
  TiedTendons result;
  for (const Tendon& tendon : routing.tendons) {
    const bool is_tied = std::any_of(tendon.walk.begin(), tendon.walk.end(),
                                     [](const Token& token) { return is_of_block(token.kind); });
    (is_tied ? result.tied : result.others).tendons.push_back(tendon);
  }
  return result;
}

bool has_blocks(const Routing& routing) {
  const BlockCount count = block_count(routing);
  return count.blocks + count.bars > 0;
}

}  // namespace

LimitedCounts count_limited(const GeneratorOptions& options,
                            const std::vector<Constraint>& constraints) {
  if (options.identity == FingerIdentity::distinct) {
    throw InputError("constraints are counted for fingers that are not told apart");
  }
  require_decided(constraints, options);
  GeneratorOptions of_one = options;
  of_one.one_tendon = true;
  const std::vector<std::uint64_t> any = verdicts(options, constraints);
  LimitedCounts counts{any[within_limits], verdicts(of_one, constraints)[within_limits], {}};
  for (std::size_t c = 0; c < constraints.size(); ++c) counts.rejected.push_back(any[failing(c)]);
  return counts;
}

LimitedTrees::LimitedTrees(const PartClasses& classes, const GeneratorOptions& options)
    : classes_(classes),
      trees_(options),
      parts_(classes, trees_.grammar()),
      beside_(classes, parts_without_blocks(options.parts), options.fingers, false) {
  const NumberedParts::Goal whole = parts_.goal(classes.admitted_classes());
  std::uint64_t begin = 0;
  for (const TreeGenerator::Cell& cell : trees_.cells()) {
    const int others = options.fingers - cell.size.fingers;
    NumberedParts::Goal goal = whole;
    if (others > 0) {
      goal =
          parts_.goal(completed_sums(classes, beside_.counts(others), classes.admitted_classes()));
    }
    cells_.push_back({cell.of_sets, goal, others, begin});
    begin = plus(begin, times(cell.sets, cell.tendons));
  }
}

ClassCounts LimitedTrees::counts_before(std::uint64_t index) {
  ClassCounts sum = no_counts(classes_);
  for (std::size_t c = 0; c < cells_.size() && cells_[c].begin < index; ++c) {
    const LimitedCell& cell = cells_[c];
    const TreeGenerator::Cell& all = trees_.cells()[c];
    const std::uint64_t within = std::min(index - cell.begin, all.sets * all.tendons);
    const std::uint64_t set = within / all.tendons;
    const std::uint64_t rest = within % all.tendons;
    const ClassCounts sets = parts_.counts_before(cell.sets, set);
    add(sum, cell.others == 0 ? sets : product(classes_, sets, beside_.counts(cell.others)));
    if (rest == 0) continue;
    add(sum, shifted(classes_, beside_.counts_before(cell.others, rest),
                     parts_.parts_of(cell.sets, set)));
  }
  return sum;
}

void LimitedTrees::start_beside(std::uint64_t index) {
  const int others = cells_[cell_].others;
  alone_ = others == 0;
  if (!alone_) beside_.seek(others, set_->parts, index);
}

void LimitedTrees::seek(std::uint64_t index) {
  set_.reset();
  next_set_ = 0;
  Digits digits(index);
  for (cell_ = 0; cell_ < cells_.size(); ++cell_) {
    const TreeGenerator::Cell& all = trees_.cells()[cell_];
    if (digits.is_among(all.sets * all.tendons)) break;
  }
  if (cell_ == cells_.size()) return;
  const std::uint64_t rest = digits.take(trees_.cells()[cell_].tendons);
  next_set_ = digits.rest();
  if (rest == 0) return;
  set_ = NumberedParts::Found{next_set_, parts_.parts_of(cells_[cell_].sets, next_set_)};
  ++next_set_;
  start_beside(rest);
}

bool LimitedTrees::next_set() {
  for (; cell_ < cells_.size(); ++cell_, next_set_ = 0) {
    ++steps_;
    set_ = parts_.first(cells_[cell_].sets, next_set_, cells_[cell_].goal);
    if (!set_) continue;
    next_set_ = set_->index + 1;
    start_beside(0);
    return true;
  }
  return false;
}

bool LimitedTrees::next_beside(std::uint64_t& index) {
  if (!set_) return false;
  if (cells_[cell_].others > 0) return beside_.next(of_others_, index);
  of_others_.tendons.clear();
  index = 0;
  return std::exchange(alone_, false);
}

bool LimitedTrees::next(Routing& routing, std::uint64_t& place) {
  std::uint64_t beside = 0;
  while (!next_beside(beside)) {
    if (!next_set()) return false;
  }
  trees_.make(cell_, set_->index, of_others_, routing);
  place = cells_[cell_].begin + set_->index * trees_.cells()[cell_].tendons + beside;
  return true;
}

std::optional<std::uint64_t> LimitedTrees::place_of(const Routing& routing) {
  const auto [tied, others] = tied_tendons(routing);
  const BlockCount count = block_count(routing);
  const TreeSize size{finger_count(tied), count.blocks + count.bars};
  const std::vector<TreeGenerator::Cell>& cells = trees_.cells();
  const auto found =
      std::find_if(cells.begin(), cells.end(), [&](const auto& cell) { return cell.size == size; });
  if (found == cells.end()) return std::nullopt;
  std::optional<std::uint64_t> beside = 0;
  if (!others.tendons.empty()) beside = beside_.place_of(others);
  if (!beside) return std::nullopt;
  const auto c = static_cast<std::size_t>(found - cells.begin());
  const NumberedParts::Goal equivalent = parts_.goal(ClassSet().set(classes_.of(tied)));
  Routing made;
  for (auto set = parts_.first(cells_[c].sets, 0, equivalent); set;
       set = parts_.first(cells_[c].sets, set->index + 1, equivalent)) {
    trees_.make(c, set->index, others, made);
    if (made == routing) return cells_[c].begin + set->index * found->tendons + *beside;
  }
  return std::nullopt;
}

LimitedGenerator::LimitedGenerator(const GeneratorOptions& options,
                                   const std::vector<Constraint>& constraints)
    : fingers_(options.fingers),
      bars_(options.parts.bars),
      classes_(constraints, options),
      tendons_(classes_, options.parts, options.fingers, options.one_tendon),
      total_(RoutingGenerator(options).total()) {
  if (options.parts.blocks > 0) trees_ = std::make_unique<LimitedTrees>(classes_, options);
}

void LimitedGenerator::seek(std::uint64_t place) {
  const std::uint64_t before = tendons_.total(fingers_);
  tendons_.seek(fingers_, PartClasses::none, place);
  if (trees_) trees_->seek(place < before ? 0 : place - before);
}

bool LimitedGenerator::next(Routing& routing, std::uint64_t& place) {
  if (tendons_.next(routing, place)) return true;
  if (!trees_ || !trees_->next(routing, place)) return false;
  place += tendons_.total(fingers_);
  return true;
}

std::vector<std::uint64_t> LimitedGenerator::verdicts_before(std::uint64_t place) {
  const std::uint64_t before = tendons_.total(fingers_);
  ClassCounts counts = tendons_.counts_before(fingers_, place);
  if (trees_ && place > before) add(counts, trees_->counts_before(place - before));
  std::vector<std::uint64_t> verdicts(failing(classes_.constraints()), 0);
  for (std::size_t c = 0; c < counts.size(); ++c) {
    verdicts[classes_.verdict(static_cast<PartClass>(c))] += counts[c];
  }
  return verdicts;
}

std::optional<std::uint64_t> LimitedGenerator::place_of(const Routing& routing) {
  if (finger_count(routing) != fingers_ || second_tendon(expand(routing)) != nullptr) {
    return std::nullopt;
  }
  if (!has_blocks(routing)) return tendons_.place_of(routing);
  if (!trees_ || (block_count(routing).bars > 0 && !bars_)) return std::nullopt;
  const auto place = trees_->place_of(routing);
  return place ? std::optional(tendons_.total(fingers_) + *place) : std::nullopt;
}

}  // namespace reeve::search
