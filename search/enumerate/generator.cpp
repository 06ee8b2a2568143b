#include "search/enumerate/generator.hpp"

#include <algorithm>
#include <cstdlib>

#include "core/mechanics.hpp"
#include "search/enumerate/checked.hpp"
#include "search/enumerate/field_parts.hpp"

namespace reeve::search {
namespace {

// About two seconds; all that are explored unasked.
constexpr std::uint64_t looked_at = most_of_identical_fingers;

// Segments that are no strand have numbers in walk order, and only blocks make those at the hand.
bool may_touch(const ContactHardware& contact, const PartSet& parts) {
  const Segment a = parse_segment(contact.segment);
  const Segment b = parse_segment(contact.other_segment);
  const bool is_at_hand = a.kind == SegmentKind::hand || b.kind == SegmentKind::hand;
  if (is_at_hand && parts.blocks == 0) return false;
  if (a.kind == SegmentKind::strand || a.kind != b.kind) return true;
  return std::abs(a.number - b.number) == 1;
}

}  // namespace

std::vector<std::string> impossible_contacts(const Hardware& hardware,
                                             const GeneratorOptions& options) {
  const MechanicsBuilder builder(hardware);
  std::vector<std::string> missing = builder.unmatched_contacts({});
  RoutingGenerator generator(options);
  Routing routing;
  Network network;
  for (std::uint64_t i = 0; i < looked_at && !missing.empty() && generator.next(routing); ++i) {
    if (!is_actuated(routing)) continue;
    expand(routing, network);
    const std::vector<std::string> here = builder.unmatched_contacts(network);
    std::erase_if(missing, [&](const std::string& contact) {
      return std::find(here.begin(), here.end(), contact) == here.end();
    });
  }
  if (generator.total() <= looked_at) return missing;
  std::erase_if(missing, [&](const std::string& contact) {
    return std::any_of(hardware.contacts.begin(), hardware.contacts.end(),
                       [&](const ContactHardware& named) {
                         return named.segment + "-" + named.other_segment == contact &&
                                may_touch(named, options.parts);
                       });
  });
  return missing;
}

RoutingGenerator::RoutingGenerator(const GeneratorOptions& options)
    : tendons_(options), total_(tendons_.total()) {
  if (options.parts.blocks == 0) return;
  trees_.emplace(options);
  total_ = plus(total_, trees_->total());
}

void RoutingGenerator::seek(std::uint64_t index) {
  tendons_.seek(index);
  if (!trees_) return;
  const std::uint64_t before = tendons_.total();
  trees_->seek(index < before ? 0 : index - before);
}

ShardRange shard_range(std::uint64_t total, std::uint64_t i, std::uint64_t n) {
  const auto cut = [&](std::uint64_t part) {
    return static_cast<std::uint64_t>(Wide{total} * part / n);
  };
  return {cut(i - 1), cut(i)};
}

}  // namespace reeve::search
