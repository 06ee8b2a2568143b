#include "search/enumerate/possible_contacts.hpp"

#include <algorithm>
#include <cstdlib>

#include "core/mechanics.hpp"
#include "search/enumerate/generator.hpp"

namespace reeve::search {
namespace {

// About a second.
constexpr int looked_at = 1'000'000;

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
  for (int i = 0; i < looked_at && !missing.empty() && generator.next(routing); ++i) {
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

}  // namespace reeve::search
