#include "search/limits/numbered_parts.hpp"

#include <utility>

#include "search/enumerate/checked.hpp"

namespace reeve::search {
namespace {

std::uint64_t as_number(int many) { return static_cast<std::uint64_t>(many); }

}  // namespace

NumberedParts::Sort NumberedParts::add(Node node, ClassCounts counts) {
  node.size = sum_of(counts);
  node.counts = std::move(counts);
  nodes_.push_back(std::move(node));
  return nodes_.size() - 1;
}

NumberedParts::Sort NumberedParts::kinds(std::vector<PartClass> of_kinds) {
  ClassCounts counts = each_of(classes_, of_kinds);
  return add({Form::kinds, {}, std::move(of_kinds), 0, 0, {}}, std::move(counts));
}

NumberedParts::Sort NumberedParts::one_after_the_other(std::vector<Sort> sorts) {
  ClassCounts counts = no_counts(classes_);
  for (const Sort sort : sorts) search::add(counts, nodes_[sort].counts);
  return add({Form::one_after_the_other, std::move(sorts), {}, 0, 0, {}}, std::move(counts));
}

NumberedParts::Sort NumberedParts::both(Sort first, Sort second) {
  return add({Form::both, {first, second}, {}, 0, 0, {}},
             product(classes_, nodes_[first].counts, nodes_[second].counts));
}

NumberedParts::Sort NumberedParts::all_of(const std::vector<Sort>& sorts) {
  Sort together = sorts.back();
  for (std::size_t i = sorts.size() - 1; i-- > 0;) together = both(sorts[i], together);
  return together;
}

NumberedParts::Sort NumberedParts::multisets(Sort of, int many) {
  return add({Form::multisets, {of}, {}, many, 0, {}},
             search::multisets(classes_, nodes_[of].counts, many));
}

NumberedParts::Sort NumberedParts::with(Sort sort, PartClass parts) {
  return both(sort, kinds({parts}));
}

NumberedParts::Sort NumberedParts::trees(Sort sort) {
  return add({Form::trees, {sort}, {}, 0, 0, {}}, of_trees(classes_, nodes_[sort].counts));
}

PartClass NumberedParts::parts_of(const Choice& choice, std::uint64_t index) const {
  if (choice.many == 0) return PartClasses::none;
  const std::uint64_t greatest = greatest_of_multiset(choice.below, as_number(choice.many), index);
  return classes_.plus(parts_of(choice.of, greatest),
                       parts_of(Choice{choice.of, choice.many - 1, greatest + 1}, index));
}

PartClass NumberedParts::parts_of(Sort sort, std::uint64_t index) const {
  const Node& node = nodes_[sort];
  switch (node.form) {
    case Form::kinds:
      return node.parts[index];
    case Form::one_after_the_other: {
      Digits digits(index);
      std::size_t i = 0;
      while (!digits.is_among(size(node.of[i]))) ++i;
      return parts_of(node.of[i], digits.rest());
    }
    case Form::both: {
      const std::uint64_t firsts = size(node.of[0]);
      return classes_.plus(parts_of(node.of[0], index % firsts),
                           parts_of(node.of[1], index / firsts));
    }
    case Form::multisets:
      return parts_of(Choice{node.of[0], node.many, size(node.of[0])}, index);
    case Form::trees:
      return classes_.of_tree(parts_of(node.of[0], index));
  }
  return PartClasses::none;
}

ClassCounts NumberedParts::counts_before(const Choice& choice, std::uint64_t index) const {
  if (choice.many == 0 || index == 0) return no_counts(classes_);
  const std::uint64_t greatest = greatest_of_multiset(choice.below, as_number(choice.many), index);
  ClassCounts counts = search::multisets(classes_, counts_before(choice.of, greatest), choice.many);
  search::add(
      counts,
      shifted(classes_, counts_before(Choice{choice.of, choice.many - 1, greatest + 1}, index),
              parts_of(choice.of, greatest)));
  return counts;
}

ClassCounts NumberedParts::counts_before_of_both(const Node& node, std::uint64_t index) const {
  const std::uint64_t firsts = size(node.of[0]);
  const std::uint64_t second = index / firsts;
  ClassCounts sum = product(classes_, counts(node.of[0]), counts_before(node.of[1], second));
  if (index % firsts > 0) {
    search::add(sum, shifted(classes_, counts_before(node.of[0], index % firsts),
                             parts_of(node.of[1], second)));
  }
  return sum;
}

ClassCounts NumberedParts::counts_before(Sort sort, std::uint64_t index) const {
  const Node& node = nodes_[sort];
  if (index == 0) return no_counts(classes_);
  if (index >= node.size) return node.counts;
  switch (node.form) {
    case Form::kinds:
      return each_of(classes_,
                     {node.parts.begin(), node.parts.begin() + static_cast<std::ptrdiff_t>(index)});
    case Form::one_after_the_other: {
      Digits digits(index);
      ClassCounts counts = no_counts(classes_);
      std::size_t i = 0;
      for (; !digits.is_among(size(node.of[i])); ++i)
        search::add(counts, nodes_[node.of[i]].counts);
      search::add(counts, counts_before(node.of[i], digits.rest()));
      return counts;
    }
    case Form::both:
      return counts_before_of_both(node, index);
    case Form::multisets:
      return counts_before(Choice{node.of[0], node.many, size(node.of[0])}, index);
    case Form::trees:
      return of_trees(classes_, counts_before(node.of[0], index));
  }
  return {};
}

}  // namespace reeve::search
