#include "search/limits/numbered_parts.hpp"

#include <utility>

#include "search/enumerate/checked.hpp"

namespace reeve::search {
namespace {

std::uint64_t as_number(int many) { return static_cast<std::uint64_t>(many); }

}  // namespace

PartClass NumberedParts::of_kind(const Grammar::Kind& kind) const {
  PartClass sum = PartClasses::none;
  for (const Token& token : kind) sum = classes_.plus(sum, classes_.of(token));
  return sum;
}

PartClass NumberedParts::added(const Grammar::Node& part) const {
  if (part.form == Form::loop) return classes_.of_loop();
  const bool hangs = part.form == Form::hung || part.form == Form::riser;
  return hangs ? classes_.of(part.token) : PartClasses::none;
}

const ClassCounts& NumberedParts::counts(Sort sort) {
  if (counts_.size() < grammar_.sorts()) counts_.resize(grammar_.sorts());
  if (counts_[sort].empty()) counts_[sort] = counted(grammar_.node(sort));
  return counts_[sort];
}

ClassCounts NumberedParts::counted(const Grammar::Node& node) {
  ClassCounts sum = no_counts(classes_);
  switch (node.form) {
    case Form::kinds:
      for (const Grammar::Kind& kind : node.kinds) ++sum[of_kind(kind)];
      return sum;
    case Form::choice:
      for (const Sort sort : node.of) add(sum, counts(sort));
      return sum;
    case Form::both:
    case Form::sides:
      return product(classes_, counts(node.of[0]), counts(node.of[1]));
    case Form::multiset:
      return multisets(classes_, counts(node.of[0]), node.many);
    case Form::tree:
      return of_trees(classes_, counts(node.of[0]));
    default:
      return shifted(classes_, counts(node.of[0]), added(node));
  }
}

PartClass NumberedParts::parts_of(const Choice& choice, std::uint64_t index) const {
  if (choice.many == 0) return PartClasses::none;
  const std::uint64_t greatest = greatest_of_multiset(choice.below, as_number(choice.many), index);
  return classes_.plus(parts_of(choice.of, greatest),
                       parts_of(Choice{choice.of, choice.many - 1, greatest + 1}, index));
}

PartClass NumberedParts::parts_of(Sort sort, std::uint64_t index) const {
  const Grammar::Node& node = grammar_.node(sort);
  switch (node.form) {
    case Form::kinds:
      return of_kind(node.kinds[index]);
    case Form::choice: {
      const Grammar::Thing chosen = grammar_.chosen({sort, index});
      return parts_of(chosen.sort, chosen.index);
    }
    case Form::both:
    case Form::sides: {
      const auto [first, second] = grammar_.split({sort, index});
      return classes_.plus(parts_of(first.sort, first.index), parts_of(second.sort, second.index));
    }
    case Form::multiset:
      return parts_of(choice(node), index);
    case Form::tree:
      return classes_.of_tree(parts_of(node.of[0], index));
    default:
      return classes_.plus(parts_of(node.of[0], index), added(node));
  }
}

ClassCounts NumberedParts::counts_before(const Choice& choice, std::uint64_t index) {
  if (choice.many == 0 || index == 0) return no_counts(classes_);
  const std::uint64_t greatest = greatest_of_multiset(choice.below, as_number(choice.many), index);
  ClassCounts counts = multisets(classes_, counts_before(choice.of, greatest), choice.many);
  add(counts,
      shifted(classes_, counts_before(Choice{choice.of, choice.many - 1, greatest + 1}, index),
              parts_of(choice.of, greatest)));
  return counts;
}

ClassCounts NumberedParts::counts_before_of_both(const Grammar::Node& node, std::uint64_t index) {
  const std::uint64_t firsts = size(node.of[0]);
  const std::uint64_t second = index / firsts;
  ClassCounts sum = product(classes_, counts(node.of[0]), counts_before(node.of[1], second));
  if (index % firsts > 0) {
    add(sum,
        shifted(classes_, counts_before(node.of[0], index % firsts), parts_of(node.of[1], second)));
  }
  return sum;
}

ClassCounts NumberedParts::counts_before_of_several(const Grammar::Node& node,
                                                    std::uint64_t index) {
  Digits digits(index);
  ClassCounts sum = no_counts(classes_);
  for (const Sort sort : node.of) {
    if (digits.is_among(size(sort))) {
      add(sum, counts_before(sort, digits.rest()));
      break;
    }
    add(sum, counts(sort));
  }
  return sum;
}

ClassCounts NumberedParts::counts_before(Sort sort, std::uint64_t index) {
  const Grammar::Node& node = grammar_.node(sort);
  if (index == 0) return no_counts(classes_);
  if (index >= size(sort)) return counts(sort);
  switch (node.form) {
    case Form::kinds: {
      ClassCounts sum = no_counts(classes_);
      for (std::uint64_t i = 0; i < index; ++i) ++sum[of_kind(node.kinds[i])];
      return sum;
    }
    case Form::choice:
      return counts_before_of_several(node, index);
    case Form::both:
    case Form::sides:
      return counts_before_of_both(node, index);
    case Form::multiset:
      return counts_before(choice(node), index);
    case Form::tree:
      return of_trees(classes_, counts_before(node.of[0], index));
    default:
      return shifted(classes_, counts_before(node.of[0], index), added(node));
  }
}

}  // namespace reeve::search
