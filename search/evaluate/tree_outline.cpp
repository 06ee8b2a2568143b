#include "search/evaluate/tree_outline.hpp"

#include <algorithm>

namespace reeve::search {

TreeSums& TreeSums::operator+=(const TreeSums& other) {
  jams |= other.jams;
  in_range &= other.in_range;
  motor += other.motor;
  strands.least = std::min(strands.least, other.strands.least);
  strands.most = std::max(strands.most, other.strands.most);
  strands.sum += other.strands.sum;
  strands.work += other.strands.work;
  return *this;
}

}  // namespace reeve::search
