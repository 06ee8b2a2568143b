#include "search/limits/listed_shapes.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace reeve::search {
namespace {

// Some thousandths of a second of steps, or a thousandth of all.
std::uint64_t between_milestones(std::uint64_t count) {
  constexpr std::uint64_t least = 1 << 14;
  constexpr std::uint64_t most_milestones = 1024;
  return std::max(least, count / most_milestones + 1);
}

}  // namespace

ListedShapes::ListedShapes(const PartClasses& classes, const PartSet& parts,
                           const std::vector<std::uint64_t>& counts, std::uint64_t longest_list)
    : classes_(classes),
      parts_(parts),
      counts_(counts),
      lists_(counts.size()),
      walks_(counts.size()) {
  for (std::size_t size = 1; size < counts.size(); ++size) {
    ShapeCursor cursor;
    if (counts[size] > longest_list || !cursor.start(parts_, static_cast<int>(size))) continue;
    List& list = lists_[size];
    do {
      list.tendons.push_back(cursor.shape());
      list.parts.push_back(parts_of(cursor.shape()));
    } while (cursor.next(parts_));
  }
}

const ListedShapes::List* ListedShapes::list(int size) const {
  const List& list = lists_[static_cast<std::size_t>(size)];
  return list.tendons.empty() ? nullptr : &list;
}

bool ListedShapes::start(ListedShape& shape, int size) const {
  if (count(size) == 0) return false;
  shape.size = size;
  shape.index = 0;
  if (const List* const listed = list(size)) {
    shape.parts = listed->parts.front();
  } else {
    shape.cursor.start(parts_, size);
    shape.parts = parts_of(shape.cursor.shape());
  }
  return true;
}

ListedShapes::Walk& ListedShapes::walk(int size) {
  Walk& walk = walks_[static_cast<std::size_t>(size)];
  if (walk.milestones.empty()) {
    walk.counts = no_counts(classes_);
    walk.milestones.push_back({{}, walk.counts});
    walk.milestones.front().cursor.start(parts_, size);
  }
  return walk;
}

void ListedShapes::leave_milestone(Walk& walk, const ShapeCursor& cursor,
                                   const ClassCounts& counts) {
  const std::uint64_t distance = between_milestones(count(cursor.fingers()));
  if (cursor.index() < walk.milestones.back().cursor.index() + distance) return;
  walk.milestones.push_back({cursor, counts});
}

// False behind the last shape.
bool ListedShapes::step(Passed& passed) {
  check_.step();
  ++passed.counts[parts_of(passed.cursor.shape())];
  ++steps_;
  return passed.cursor.next(parts_);
}

// On to the next one, with the tally of those that were passed.
bool ListedShapes::next_beyond(ListedShape& shape, std::size_t tokens, const ClassCounts& passed) {
  const std::uint64_t many = std::accumulate(passed.begin(), passed.end(), std::uint64_t{0});
  const std::uint64_t index = shape.index + many;
  Walk& walk = this->walk(shape.size);
  const bool is_next = walk.next == shape.index;
  if (is_next) {
    add(walk.counts, passed);
    walk.next = index;
  }
  if (index == count(shape.size)) return false;
  shape.cursor.next_beyond(parts_, tokens, many);
  shape.index = index;
  shape.parts = parts_of(shape.cursor.shape());
  if (is_next) leave_milestone(walk, shape.cursor, walk.counts);
  return true;
}

bool ListedShapes::next(ListedShape& shape) {
  if (shape.index + 1 == count(shape.size)) return false;
  if (is_listed(shape.size)) {
    advance_to(shape, shape.index + 1);
    return true;
  }
  if (classes_.count() == 1) {
    // Nobody asks how many of which were passed of shapes that are all alike.
    ++shape.index;
    return shape.cursor.next(parts_);
  }
  one_.assign(classes_.count(), 0);
  one_[shape.parts] = 1;
  return next_beyond(shape, shape.cursor.shape().walk.size(), one_);
}

void ListedShapes::advance_to(ListedShape& shape, std::uint64_t index) {
  if (shape.index == index) return;
  if (const List* const listed = list(shape.size)) {
    shape.index = index;
    shape.parts = listed->parts[index];
    return;
  }
  const std::vector<Passed>& milestones = walk(shape.size).milestones;
  const auto beyond = std::upper_bound(
      milestones.begin(), milestones.end(), index,
      [](std::uint64_t i, const Passed& passed) { return i < passed.cursor.index(); });
  const Passed& last = *std::prev(beyond);
  if (last.cursor.index() > shape.index) shape.cursor = last.cursor;
  for (; shape.cursor.index() < index; ++steps_) {
    check_.step();
    shape.cursor.next(parts_);
  }
  shape.index = index;
  shape.parts = parts_of(shape.cursor.shape());
}

const Tendon& ListedShapes::tendon(const ListedShape& shape) const {
  const List* const listed = list(shape.size);
  return listed != nullptr ? listed->tendons[shape.index] : shape.cursor.shape();
}

ClassCounts ListedShapes::counts_before(int size, std::uint64_t index) {
  if (const List* const listed = list(size)) {
    ClassCounts counts = no_counts(classes_);
    for (std::uint64_t i = 0; i < index; ++i) ++counts[listed->parts[i]];
    return counts;
  }
  if (index == 0) return no_counts(classes_);
  Walk& walk = this->walk(size);
  const auto beyond = std::upper_bound(
      walk.milestones.begin(), walk.milestones.end(), index,
      [](std::uint64_t i, const Passed& passed) { return i < passed.cursor.index(); });
  Passed passed = *std::prev(beyond);
  for (std::uint64_t i = passed.cursor.index(); i < index; ++i) {
    if (step(passed)) leave_milestone(walk, passed.cursor, passed.counts);
  }
  if (index > walk.next) {
    walk.next = index;
    walk.counts = passed.counts;
  }
  return passed.counts;
}

}  // namespace reeve::search
