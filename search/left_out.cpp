#include "search/left_out.hpp"

namespace reeve::search {

LeftOut::LeftOut(const ExploreOptions& options, RoutingSource& source, ShardRange range,
                 std::uint64_t counted)
    : source_(source) {
  for (const Routing& routing : options.references) {
    references_.push_back(source.place_left_out(routing));
  }
  go_on_with(range, counted);
}

void LeftOut::go_on_with(ShardRange range, std::uint64_t counted) {
  range_ = range;
  before_ = source_.left_out_before(range.begin + counted);
}

void LeftOut::add_to(ExplorationPart& part, std::uint64_t generated) {
  const std::vector<std::uint64_t> until = source_.left_out_before(range_.begin + generated);
  for (std::size_t c = 0; c < until.size(); ++c) {
    part.constraint_failures[c] += until[c] - before_[c];
    part.evaluated += until[c] - before_[c];
  }
  before_ = until;
  for (std::size_t r = 0; r < references_.size(); ++r) {
    const auto& left = references_[r];
    if (!left || left->place < range_.begin || left->place >= range_.begin + generated) continue;
    part.references[r].generated = true;
    part.references[r].rejected_by = left->constraint;
  }
}

}  // namespace reeve::search
