#include "search/left_out.hpp"

namespace reeve::search {

LeftOut::LeftOut(const ExploreOptions& options, RoutingSource& source, ShardRange range,
                 std::uint64_t counted)
    : source_(source), range_(range), counted_(counted) {
  for (const Routing& routing : options.references) {
    references_.push_back(source.place_left_out(routing));
  }
}

void LeftOut::go_on_with(ShardRange range) {
  range_ = range;
  counted_ = 0;
}

void LeftOut::add_to(ExplorationPart& part, std::uint64_t generated) {
  const std::vector<std::uint64_t> rejected =
      source_.left_out(range_.begin + counted_, range_.begin + generated);
  counted_ = generated;
  for (std::size_t c = 0; c < rejected.size(); ++c) {
    part.constraint_failures[c] += rejected[c];
    part.evaluated += rejected[c];
  }
  for (std::size_t r = 0; r < references_.size(); ++r) {
    const auto& left = references_[r];
    if (!left || left->place < range_.begin || left->place >= range_.begin + generated) continue;
    part.references[r].generated = true;
    part.references[r].rejected_by = left->constraint;
  }
}

}  // namespace reeve::search
