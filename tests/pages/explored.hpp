// Explorations to make pages of: small real ones, and one that is as large as a list can be.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "core/canonical.hpp"
#include "core/notation.hpp"
#include "pages/exploration/exploration_page.hpp"
#include "search/explore.hpp"
#include "studies/shown_routing.hpp"

namespace reeve::testing {

inline ExploreOptions small_options(int fingers = 2) {
  ExploreOptions options;
  options.generator.fingers = fingers;
  options.generator.parts = full_parts();
  options.grasps = single_grasps(fingers);
  options.threads = 1;
  for (const char* known : {"M-1-T-2-F", "F-1-P-2-F", "1-P-2-P-1"}) {
    const Routing routing = canonical(parse_routing(known), options.generator.identity);
    if (finger_count(routing) == fingers) options.references.push_back(routing);
  }
  return options;
}

inline ExploreReport explored(const ExploreOptions& options) {
  ExploreReport report = explore_report(options, explore(options), {}, Catalogue{});
  for (std::size_t i = 0; i < report.reference_names.size(); ++i) {
    report.reference_names[i] = fmt::format("K{}", i + 1);
  }
  return report;
}

inline ExplorationView view(const ExploreReport& report) {
  return {report, "reeve explore", "",
          [&report](const Routing& routing) {
            return solved_routing(routing, report.options.model, report.options.grasps,
                                  Direction::pull, Catalogue{});
          },
          std::nullopt};
}

// Five fingers in the order, with the tips and the joins of this number: another for each number
// below 120 * 32 * 27.
inline Routing numbered_routing(std::size_t number) {
  std::array<int, 5> order{1, 2, 3, 4, 5};
  for (std::size_t i = 0; i < number % 120; ++i) std::next_permutation(order.begin(), order.end());
  std::size_t tips = number / 120 % 32;
  std::size_t joins = number / 120 / 32;
  constexpr std::array kinds{TokenKind::tube_join, TokenKind::bearing_join,
                             TokenKind::movable_pulley};
  Tendon tendon{{motor_end()}};
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i > 0) tendon.walk.push_back(plain(kinds[joins % 3]));
    if (i > 0) joins /= 3;
    tendon.walk.push_back(finger(order[i], tips % 2 == 0 ? TipKind::tube : TipKind::bearing));
    tips /= 2;
  }
  tendon.walk.push_back(fixed_end());
  return {{tendon}};
}

// `count` designs, of which every hundredth is on the front; no two values are alike.
inline ExploreReport large(std::size_t count) {
  ExploreReport report;
  report.options = small_options(5);
  report.options.top = count;
  report.result.total = report.result.generated = report.result.evaluated = count;
  for (std::size_t i = 0; i < count; ++i) {
    ListedDesign design;
    const auto at = static_cast<double>(i) / static_cast<double>(count);
    design.ranked.rank = i + 1;
    design.ranked.front = i < count / 100 ? 1 : 2;
    design.routing = numbered_routing(i);
    design.ranked.design.word = to_word(design.routing);
    for (std::size_t k = 0; k < objective_count; ++k) {
      const auto wave = static_cast<double>((i * (7919 + 2 * k)) % count);
      design.ranked.design.values[k] = k == 0 ? at : wave / static_cast<double>(count);
    }
    design.distribution = RankDistribution{at, 1 + at, 2 * at, 3 + at};
    report.top.push_back(design);
    if (design.ranked.front == 1) report.front.push_back(design);
  }
  return report;
}

}  // namespace reeve::testing
