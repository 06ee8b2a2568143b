#include "search/limits/limited_generator.hpp"

#include <algorithm>

namespace reeve::search {
namespace {

bool has_blocks(const Routing& routing) {
  const BlockCount count = block_count(routing);
  return count.blocks + count.bars > 0;
}

}  // namespace

LimitedGenerator::LimitedGenerator(const GeneratorOptions& options,
                                   const std::vector<Constraint>& constraints)
    : fingers_(options.fingers),
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
  if (finger_count(routing) != fingers_) return std::nullopt;
  if (!has_blocks(routing)) return tendons_.place_of(routing);
  if (!trees_) return std::nullopt;
  const auto place = trees_->place_of(routing);
  return place ? std::optional(tendons_.total(fingers_) + *place) : std::nullopt;
}

}  // namespace reeve::search
