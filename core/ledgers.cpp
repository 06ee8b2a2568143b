#include "core/ledgers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace reeve::core {
namespace {

// Why a bar, or the plate that two bars are, is refused with more ties.
constexpr const char* four_ties =
    ": a rigid plate balances one force and two moments, which leave the tensions of four ties "
    "undetermined; three bars determine them, as in 1x-W1-2x+3x-W2-4x+W1-W3-W2+W3-M";

bool is_bar(std::size_t key) { return key >= static_cast<std::size_t>(max_blocks); }

std::string block_name(std::size_t key) {
  const auto first = is_bar(key) ? static_cast<std::size_t>(max_blocks) : 0;
  return fmt::format("{}{}", is_bar(key) ? 'W' : 'Y', key - first + 1);
}

using Keys = std::array<bool, block_keys>;

// Returns for each block those on which it hangs: the blocks that the tendons of its tails pass.
std::array<Keys, block_keys> hanging(const Routing& routing) {
  std::array<Keys, block_keys> on{};
  for (const Tendon& tendon : routing.tendons) {
    for (const Token& tail : tendon.walk) {
      if (!is_tail(tail.kind)) continue;
      for (const Token& token : tendon.walk) {
        if (is_of_block(token.kind) && !is_tail(token.kind)) {
          on[block_key(tail)][block_key(token)] = true;
        }
      }
    }
  }
  return on;
}

}  // namespace

void FingerLedger::refuse(const PlacedToken& placed, const char* what) const {
  word_.fail(placed.at,
             {.what = fmt::format("finger {} {}: it has two strands", placed.token.finger, what),
              .expected = "it passed once, or two tied ends: 1x and 1x (flexors), or 1x and 1e (an "
                          "extensor)",
              .form = InputForm::unknown});
}

void FingerLedger::pass(const PlacedWalk& walk) {
  for (const PlacedToken& placed : walk) {
    const Token& token = placed.token;
    if (!is_of_finger(token.kind)) continue;
    Entry& entry = entries_[token.finger];
    const bool passes = token.kind == TokenKind::finger;
    if (entry.passed || (passes && entry.ends > 0)) {
      refuse(placed, passes && entry.passed ? "is passed twice" : "is passed and tied");
    }
    highest_ = std::max<int>(highest_, token.finger);
    entry.passed = passes;
    if (passes) continue;
    if (token.tip == TipKind::back && ++entry.extensors == 2) refuse(placed, "has two extensors");
    if (++entry.ends == 3) refuse(placed, "has three tied ends");
    if (entry.ends == 2 && ++second_tendons_ > most_second_tendons) {
      word_.fail(placed.at, {.what = fmt::format("more than {} fingers have two tied ends",
                                                 most_second_tendons)});
    }
  }
}

void FingerLedger::require_no_gap() const {
  for (std::size_t f = 1; f < static_cast<std::size_t>(highest_); ++f) {
    if (entries_[f].passed || entries_[f].ends > 0) continue;
    word_.fail(
        {.what = fmt::format("finger {} is missing; fingers are numbered 1 to {} without a gap", f,
                             highest_)});
  }
}

void CarriageLedger::pass(const PlacedWalk& walk) {
  for (const PlacedToken& placed : walk) {
    if (!is_on_carriage(placed.token.kind)) continue;
    named_[placed.token.carriage] = true;
    highest_ = std::max<int>(highest_, placed.token.carriage);
  }
}

void CarriageLedger::require_no_gap() const {
  for (int motor = 1; motor < highest_; ++motor) {
    if (named_[static_cast<std::size_t>(motor)]) continue;
    const std::string number = motor == 1 ? "" : std::to_string(motor);
    word_.fail({.what = fmt::format("motor {} is missing (M{} or P{}); motors are numbered 1 to {} "
                                    "without a gap",
                                    motor, number, number, highest_)});
  }
}

void BlockLedger::pass(const PlacedWalk& walk) {
  for (const PlacedToken& placed : walk) {
    if (!is_of_block(placed.token.kind)) continue;
    Entry& entry = entries_[block_key(placed.token)];
    any_named_ = true;
    if (!std::exchange(entry.named, true)) entry.at = placed.at;
    if (is_tail(placed.token.kind)) {
      entry.tail = true;
    } else if (std::exchange(entry.pulled, true) && placed.token.kind == TokenKind::bar_arms) {
      word_.fail(placed.at, {.what = quoted_text(placed.at.text) + four_ties});
    }
  }
}

void BlockLedger::require_parts(std::size_t key) const {
  const Entry& entry = entries_[key];
  const std::string name = block_name(key);
  if (!entry.tail) {
    word_.fail(
        entry.at,
        {.what = is_bar(key)
                     ? fmt::format("bar {} has arms but nothing at its pivot: {} as the end of "
                                   "a walk, as in M-{}+1x-{}-2x",
                                   name, name, name, name)
                     : fmt::format("block {} has no tail, so nothing holds it against the "
                                   "strands that pass it: {} as the end of a walk, as in "
                                   "M-{}+1x-{}-2x",
                                   name, name, name, name)});
  }
  if (!entry.pulled) {
    word_.fail(entry.at,
               {.what = is_bar(key)
                            ? fmt::format("bar {} has a pivot but no arms: they are its neighbours "
                                          "inside a walk, as in 1x-{}-2x",
                                          name, name)
                            : fmt::format("block {} has a tail but nothing pulls the other way: "
                                          "neither a pass ({} inside a walk) nor a becket ({}k)",
                                          name, name, name)});
  }
}

void BlockLedger::require_no_ring(const Routing& routing) const {
  // Warshall's transitive closure.
  std::array<Keys, block_keys> on = hanging(routing);
  for (std::size_t via = 0; via < block_keys; ++via) {
    for (std::size_t from = 0; from < block_keys; ++from) {
      if (!on[from][via]) continue;
      for (std::size_t to = 0; to < block_keys; ++to) on[from][to] |= on[via][to];
    }
  }
  for (std::size_t key = 0; key < block_keys; ++key) {
    if (!on[key][key]) continue;
    word_.fail(
        entries_[key].at,
        {.what = fmt::format("{} {} hangs on itself: its tail is pulled by a tendon that {} "
                             "carries, directly or over other blocks",
                             is_bar(key) ? "bar" : "block", block_name(key), block_name(key))});
  }
}

void BlockLedger::require_whole(const Routing& routing) const {
  if (!any_named_) return;
  for (std::size_t key = 0; key < block_keys; ++key) {
    if (entries_[key].named) require_parts(key);
  }
  require_no_ring(routing);
}

}  // namespace reeve::core
