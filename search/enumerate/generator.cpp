#include "search/enumerate/generator.hpp"

#include <algorithm>
#include <cstdlib>

#include "core/idle_values.hpp"
#include "core/mechanics.hpp"
#include "search/enumerate/checked.hpp"
#include "search/enumerate/counting.hpp"
#include "search/enumerate/field_parts.hpp"

namespace reeve::search {
namespace {

// About two seconds; all that are explored unasked.
constexpr std::uint64_t looked_at = most_of_identical_fingers;

// Segments that are no strand have numbers in walk order, and only blocks make those at the hand.
bool may_touch(const ContactHardware& contact, const PartSet& parts) {
  const auto [a, b] = parse_contact(contact);
  const bool is_at_hand = a.kind == SegmentKind::hand || b.kind == SegmentKind::hand;
  if (is_at_hand && parts.blocks == 0) return false;
  if (a.kind == SegmentKind::strand || a.kind != b.kind) return true;
  return std::abs(a.number - b.number) == 1;
}

}  // namespace

std::vector<std::string> impossible_values(const Hardware& hardware,
                                           const GeneratorOptions& options) {
  IdleValues idle(hardware, options.fingers);
  if (idle.empty()) return {};
  RoutingGenerator generator(options);
  Routing routing;
  Network network;
  for (std::uint64_t i = 0; i < looked_at && !idle.empty() && generator.next(routing); ++i) {
    if (!is_actuated(routing)) continue;
    expand(routing, network);
    idle.look_at(network);
  }
  std::vector<std::string> keys = idle.keys();
  if (generator.total() <= looked_at) return keys;
  std::erase_if(keys, [&](const std::string& key) {
    return std::none_of(
        hardware.contacts.begin(), hardware.contacts.end(), [&](const ContactHardware& named) {
          return "contact." + name_of(named) == key && !may_touch(named, options.parts);
        });
  });
  return keys;
}

RoutingGenerator::RoutingGenerator(const GeneratorOptions& options)
    : tendons_(options), total_(tendons_.total()) {
  if (options.parts.blocks > 0) {
    trees_.emplace(options);
    total_ = plus(total_, trees_->total());
  }
  if (options.parts.motors == 1) return;
  const RoutingCounts counts = count_routings(options.parts, options.fingers, options.identity);
  total_ = options.one_tendon ? counts.one_tendon : counts.all;
  carriages_.emplace(options.parts.motors, options.identity);
}

bool RoutingGenerator::next_of_motors(Routing& routing) {
  while (!carriages_->next(routing)) {
    if (!next_of_one_motor(of_one_motor_)) return false;
    carriages_->start(of_one_motor_);
  }
  ++place_;
  return true;
}

void RoutingGenerator::seek(std::uint64_t index) {
  if (!carriages_) return seek_of_one_motor(index);
  if (index < place_) {
    seek_of_one_motor(0);
    carriages_->start({});
    place_ = 0;
  }
  Routing passed;
  while (place_ < index && next_of_motors(passed)) check_.step();
}

void RoutingGenerator::seek_of_one_motor(std::uint64_t index) {
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
