#include <utility>

#include "search/enumerate/checked.hpp"
#include "search/limits/numbered_parts.hpp"

namespace reeve::search {

NumberedParts::Goal NumberedParts::goal(const ClassSet& wanted) {
  const auto [known, is_new] = goal_of_.try_emplace(wanted, goals_.size());
  if (is_new) goals_.push_back(wanted);
  return known->second;
}

NumberedParts::Goal NumberedParts::completed_by(Sort sort, Goal of) {
  const auto known = completed_.find({of, sort});
  if (known != completed_.end()) return known->second;
  const ClassSet set = completed_sums(classes_, counts(sort), goals_[of]);
  return completed_[{of, sort}] = goal(set);
}

NumberedParts::Goal NumberedParts::of_trees_alone(PartClass beside, Goal of) {
  const auto known = alone_.find({of, beside});
  if (known != alone_.end()) return known->second;
  ClassSet set;
  for (std::size_t c = 0; c < classes_.count(); ++c) {
    const PartClass tree = classes_.of_tree(static_cast<PartClass>(c));
    if (goals_[of].test(classes_.plus(tree, beside))) set.set(c);
  }
  return alone_[{of, beside}] = goal(set);
}

bool NumberedParts::can_meet(Sort sort, PartClass beside, Goal of) {
  return goals_[completed_by(sort, of)].test(beside);
}

std::optional<NumberedParts::Found> NumberedParts::first_of_kinds(Sort sort, std::uint64_t from,
                                                                  PartClass beside, Goal of) {
  const std::vector<Grammar::Kind>& kinds = grammar_.node(sort).kinds;
  for (std::uint64_t i = from; i < kinds.size(); ++i) {
    const PartClass parts = of_kind(kinds[i]);
    if (goals_[of].test(classes_.plus(parts, beside))) return Found{i, parts};
  }
  return std::nullopt;
}

std::optional<NumberedParts::Found> NumberedParts::first_of_several(Sort sort, std::uint64_t from,
                                                                    PartClass beside, Goal of) {
  std::uint64_t before = 0;
  for (const Sort part : grammar_.node(sort).of) {
    const std::uint64_t end = before + size(part);
    if (from < end) {
      if (auto found = first(part, from > before ? from - before : 0, beside, of)) {
        found->index += before;
        return found;
      }
    }
    before = end;
  }
  return std::nullopt;
}

// The second, which varies last, must leave something for the first.
std::optional<NumberedParts::Found> NumberedParts::first_of_both(Sort sort, std::uint64_t from,
                                                                 PartClass beside, Goal of) {
  const Sort one = grammar_.node(sort).of[0];
  const Sort other = grammar_.node(sort).of[1];
  const std::uint64_t firsts = size(one);
  std::uint64_t second = from / firsts;
  if (from % firsts > 0) {
    const PartClass parts = parts_of(other, second);
    if (const auto found = first(one, from % firsts, classes_.plus(parts, beside), of)) {
      return Found{second * firsts + found->index, classes_.plus(found->parts, parts)};
    }
    ++second;
  }
  const auto last = first(other, second, beside, completed_by(one, of));
  if (!last) return std::nullopt;
  const auto found = first(one, 0, classes_.plus(last->parts, beside), of);
  return Found{last->index * firsts + found->index, classes_.plus(found->parts, last->parts)};
}

// The greatest leaves numbers up to itself to the others, of which there may be none that do.
std::optional<NumberedParts::Found> NumberedParts::first_of_choice(const Choice& choice,
                                                                   std::uint64_t from,
                                                                   PartClass beside, Goal of) {
  if (choice.many == 0) {
    if (from > 0 || !goals_[of].test(beside)) return std::nullopt;
    return Found{0, PartClasses::none};
  }
  const auto many = static_cast<std::uint64_t>(choice.many);
  if (from >= multichoose(choice.below, many)) return std::nullopt;
  Goal of_greatest = of;
  for (int i = 1; i < choice.many; ++i) of_greatest = completed_by(choice.of, of_greatest);
  std::uint64_t rest = from;
  std::uint64_t at = greatest_of_multiset(choice.below, many, rest);
  while (true) {
    const auto greatest = first(choice.of, at, beside, of_greatest);
    if (!greatest || greatest->index >= choice.below) return std::nullopt;
    if (greatest->index > at) rest = 0;
    at = greatest->index;
    const auto others = first_of_choice({choice.of, choice.many - 1, at + 1}, rest,
                                        classes_.plus(greatest->parts, beside), of);
    if (others) {
      return Found{multichoose(at, many) + others->index,
                   classes_.plus(others->parts, greatest->parts)};
    }
    ++at;
    rest = 0;
  }
}

std::optional<NumberedParts::Found> NumberedParts::first(Sort sort, std::uint64_t from,
                                                         PartClass beside, Goal of) {
  if (from >= size(sort) || !can_meet(sort, beside, of)) return std::nullopt;
  const Grammar::Node& node = grammar_.node(sort);
  std::optional<Found> found;
  switch (node.form) {
    case Form::kinds:
      return first_of_kinds(sort, from, beside, of);
    case Form::choice:
      return first_of_several(sort, from, beside, of);
    case Form::both:
    case Form::sides:
      return first_of_both(sort, from, beside, of);
    case Form::multiset:
      return first_of_choice(choice(node), from, beside, of);
    case Form::tree:
      found = first(node.of[0], from, PartClasses::none, of_trees_alone(beside, of));
      if (found) found->parts = classes_.of_tree(found->parts);
      return found;
    default:
      found = first(node.of[0], from, classes_.plus(beside, added(node)), of);
      if (found) found->parts = classes_.plus(found->parts, added(node));
      return found;
  }
}

}  // namespace reeve::search
