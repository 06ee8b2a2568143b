#include "search/limits/listed_shapes.hpp"

namespace reeve::search {

ListedShapes::ListedShapes(const PartClasses& classes, const PartSet& parts,
                           const std::vector<std::uint64_t>& counts, std::uint64_t longest_list)
    : classes_(classes), parts_(parts), counts_(counts), lists_(counts.size()) {
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

bool ListedShapes::next(ListedShape& shape) const {
  if (shape.index + 1 == count(shape.size)) return false;
  advance_to(shape, shape.index + 1);
  return true;
}

void ListedShapes::advance_to(ListedShape& shape, std::uint64_t index) const {
  if (const List* const listed = list(shape.size)) {
    shape.index = index;
    shape.parts = listed->parts[index];
    return;
  }
  for (; shape.index < index; ++shape.index) shape.cursor.next(parts_);
  shape.parts = parts_of(shape.cursor.shape());
}

const Tendon& ListedShapes::tendon(const ListedShape& shape) const {
  const List* const listed = list(shape.size);
  return listed != nullptr ? listed->tendons[shape.index] : shape.cursor.shape();
}

ClassCounts ListedShapes::counts_from(int size, std::uint64_t index) const {
  ClassCounts counts = no_counts(classes_);
  ListedShape shape;
  if (index >= count(size)) return counts;
  start(shape, size);
  advance_to(shape, index);
  do {
    ++counts[shape.parts];
  } while (next(shape));
  return counts;
}

}  // namespace reeve::search
