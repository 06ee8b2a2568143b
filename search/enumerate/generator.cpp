#include "search/enumerate/generator.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "core/graph.hpp"
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

void look_at(const GeneratorOptions& options, ValueUse& use) {
  constexpr std::uint64_t at_least = 1000;
  RoutingGenerator generator(options);
  Routing routing;
  Network network;
  for (std::uint64_t i = 0; i < (use.is_taken() ? at_least : looked_at); ++i) {
    if (!generator.next(routing)) return;
    if (!is_actuated(routing)) continue;
    expand(routing, network);
    use.look_at(network);
  }
  use.suppose_taken();
}

RoutingGenerator::RoutingGenerator(const GeneratorOptions& options, PartClasses classes)
    : fingers_(options.fingers),
      bars_(options.parts.bars),
      classes_(std::move(classes)),
      tendons_(options, classes_),
      total_(tendons_.total(fingers_)) {
  if (options.parts.blocks > 0) {
    trees_.emplace(options, classes_);
    total_ = plus(total_, trees_->total());
  }
  if (options.parts.motors == 1) return;
  const RoutingCounts counts = count_routings(options.parts, options.fingers, options.identity);
  total_ = options.one_tendon ? counts.one_tendon : counts.all;
  carriages_.emplace(options.parts.motors, options.identity);
}

void RoutingGenerator::stop_with(const StopCheck& check) {
  tendons_.shapes().stop_with(check);
  if (trees_) trees_->stop_with(check);
  check_ = check;
}

bool RoutingGenerator::next(Routing& routing, std::uint64_t& place) {
  if (!is_placed_) seek(0);
  if (!carriages_) return next_of_one_motor(routing, place);
  place = place_;
  return next_of_motors(routing);
}

bool RoutingGenerator::next_of_one_motor(Routing& routing, std::uint64_t& place) {
  if (tendons_.next(routing, place)) return true;
  if (!trees_ || !trees_->next(routing, place)) return false;
  place += tendons_.total(fingers_);
  return true;
}

bool RoutingGenerator::next_of_motors(Routing& routing) {
  std::uint64_t of_one_motor = 0;
  while (!carriages_->next(routing)) {
    if (!next_of_one_motor(of_one_motor_, of_one_motor)) return false;
    carriages_->start(of_one_motor_);
  }
  ++place_;
  return true;
}

void RoutingGenerator::seek(std::uint64_t place) {
  const bool is_placed = std::exchange(is_placed_, true);
  if (!carriages_) return seek_of_one_motor(place);
  if (!is_placed || place < place_) {
    seek_of_one_motor(0);
    carriages_->start({});
    place_ = 0;
  }
  Routing passed;
  while (place_ < place && next_of_motors(passed)) check_.step();
}

void RoutingGenerator::seek_of_one_motor(std::uint64_t place) {
  tendons_.seek(fingers_, PartClasses::none, place);
  if (!trees_) return;
  const std::uint64_t before = tendons_.total(fingers_);
  trees_->seek(place < before ? 0 : place - before);
}

std::vector<std::uint64_t> RoutingGenerator::verdicts_before(std::uint64_t place) {
  const std::uint64_t before = tendons_.total(fingers_);
  ClassCounts counts = tendons_.shapes().counts_before(fingers_, place);
  if (trees_ && place > before) add(counts, trees_->counts_before(place - before));
  std::vector<std::uint64_t> verdicts(failing(classes_.constraints()), 0);
  for (std::size_t c = 0; c < counts.size(); ++c) {
    verdicts[classes_.verdict(static_cast<PartClass>(c))] += counts[c];
  }
  return verdicts;
}

std::optional<std::uint64_t> RoutingGenerator::place_of(const Routing& routing) {
  if (finger_count(routing) != fingers_ || second_tendon(expand(routing)) != nullptr) {
    return std::nullopt;
  }
  const BlockCount count = block_count(routing);
  if (count.blocks + count.bars == 0) return tendons_.shapes().place_of(routing);
  if (!trees_ || (count.bars > 0 && !bars_)) return std::nullopt;
  const auto index = trees_->index_of(routing);
  return index ? std::optional(tendons_.total(fingers_) + *index) : std::nullopt;
}

ShardRange shard_range(std::uint64_t total, std::uint64_t i, std::uint64_t n) {
  const auto cut = [&](std::uint64_t part) {
    return static_cast<std::uint64_t>(Wide{total} * part / n);
  };
  return {cut(i - 1), cut(i)};
}

}  // namespace reeve::search
