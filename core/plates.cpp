#include "core/plates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace reeve::core {
namespace {

using Numbers = std::array<std::uint8_t, max_blocks + 1>;

bool is_arms(const PlacedToken& placed) { return placed.token.kind == TokenKind::bar_arms; }

template <typename Visit>
void for_each_third_tie(std::vector<PlacedWalk>& walks, Visit visit) {
  for (PlacedWalk& walk : walks) {
    if (walk.size() == 1) continue;  // refused later
    // A token that is added at the back leaves the front where it is.
    if (is_arms(walk.back())) visit(walk, walk.size() - 1);
    if (is_arms(walk.front())) visit(walk, std::size_t{0});
  }
}

// Returns the number of the second bar of each plate, and 0 for what is no plate.
Numbers second_bars(const Word& word, std::vector<PlacedWalk>& walks) {
  std::array<bool, max_blocks + 1> taken{};
  for (const PlacedWalk& walk : walks) {
    for (const PlacedToken& placed : walk) {
      if (is_of_bar(placed.token.kind)) taken[placed.token.block] = true;
    }
  }
  Numbers second{};
  for_each_third_tie(walks, [&](const PlacedWalk& walk, std::size_t i) {
    const PlacedToken& tie = walk[i];
    const auto free = std::find(taken.begin() + 1, taken.end(), false);
    if (free == taken.end()) {
      word.fail(tie.at, {.what = fmt::format("{}: a plate counts as two bars, and there are more "
                                             "than {}",
                                             quoted_text(tie.at.text), max_blocks)});
    }
    *free = true;
    second[tie.token.block] = static_cast<std::uint8_t>(free - taken.begin());
  });
  return second;
}

// A tendon from the arms of a plate to its third tie pulls the plate against itself.
void require_own_tendon(const Word& word, const PlacedWalk& walk, const PlacedToken& tie,
                        std::uint8_t second) {
  const bool has_arms = std::any_of(walk.begin() + 1, walk.end() - 1, [&](const PlacedToken& in) {
    return is_arms(in) && in.token.block == second;
  });
  if (!has_arms) return;
  const int number = tie.token.block;
  word.fail(tie.at,
            {.what = fmt::format("{} lies on a tendon at the arms of bar W{}, which pulls "
                                 "the plate against itself: the third tie needs a tendon "
                                 "of its own, as in M-W{}+1x-W{}-2x+3x-W{}k",
                                 quoted_text(tie.at.text), number, number, number, number)});
}

}  // namespace

void replace_plates(const Word& word, std::vector<PlacedWalk>& walks) {
  const Numbers second = second_bars(word, walks);
  std::array<bool, max_blocks + 1> has_arms{};
  for (PlacedWalk& walk : walks) {
    for (std::size_t i = 1; i + 1 < walk.size(); ++i) {
      if (!is_arms(walk[i])) continue;
      std::uint8_t& number = walk[i].token.block;
      has_arms[number] = true;
      if (second[number] != 0) number = second[number];
    }
  }
  for_each_third_tie(walks, [&](PlacedWalk& walk, std::size_t i) {
    const PlacedToken tie = walk[i];
    const std::uint8_t number = tie.token.block;
    require_own_tendon(word, walk, tie, second[number]);
    if (!has_arms[number]) {
      word.fail(tie.at, {.what = fmt::format("{} is the third tie of a plate without the other "
                                             "two: they are the neighbours of W{} inside a walk, "
                                             "as in 1x-W{}-2x",
                                             quoted_text(tie.at.text), number, number)});
    }
    const PlacedToken pivot{block(TokenKind::bar_pivot, second[number]), tie.at};
    if (i > 0) {
      walk.push_back(pivot);
    } else {
      walk[0].token = reversed(tie.token);
      walk.insert(walk.begin(), pivot);
    }
  });
}

}  // namespace reeve::core
