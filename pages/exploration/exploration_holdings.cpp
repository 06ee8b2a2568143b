#include "pages/exploration/exploration_holdings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>

#include "core/notation.hpp"
#include "pages/exploration/exploration_answer.hpp"
#include "pages/shell/compressed.hpp"

namespace reeve::pages {
namespace {

constexpr std::size_t column_bytes = 2'000'000;
constexpr double part_filled = 0.97;  // filled share of these bytes, if not all designs fit
constexpr std::size_t probed = 5'000;

// Returns the named designs, the known routings, then the best in the order of the ranking, which
// the front begins.
std::vector<const Routing*> in_order_of_details(const ExploreReport& report, std::size_t best) {
  std::vector<const Routing*> routings;
  std::set<std::string> held;
  const auto add = [&](const Routing& routing) {
    if (held.insert(to_word(routing)).second) routings.push_back(&routing);
  };
  for (const ListedDesign* design : named_designs(report)) add(design->routing);
  for (const Routing& known : report.options.references) add(known);
  const std::vector<ListedDesign>& listed = listed_designs(report);
  for (std::size_t i = 0; i < std::min(best, listed.size()); ++i) add(listed[i].routing);
  return routings;
}

std::size_t details_of(const ExplorationView& view) {
  // After a stop, the user waits for the end.
  constexpr std::size_t in_a_hurry = 20;
  const std::size_t drawn = view.report.result.partial ? in_a_hurry : usual_schematics;
  return view.details.value_or(drawn / view.report.options.grasps.size());
}

// How many there could be, however many are asked for.
std::size_t designs_with_details(const ExploreReport& report) {
  std::set<std::string> others;
  for (const ListedDesign* design : named_designs(report)) {
    others.insert(design->ranked.design.word);
  }
  for (const Routing& known : report.options.references) others.insert(to_word(known));
  const std::vector<std::string_view> words(others.begin(), others.end());
  return listed_designs(report).size() + words.size() - listed_places(report, words).size();
}

HeldDesigns packed_designs(const ExploreReport& report, std::size_t most) {
  HeldDesigns held{page_designs(report, most), "", most};
  const std::vector<Objective> objectives = page_objectives(report);
  Json columns = design_columns(held.designs, objectives);
  if (report.uncertainty) {
    columns["bands"] = band_columns(held.designs, objectives, report.options.order.objectives);
  }
  held.packed = compressed(columns.dump());
  return held;
}

double share_of_room(const HeldDesigns& held) {
  return static_cast<double>(column_bytes) / static_cast<double>(held.packed.size());
}

// All, unless the first of them show that they are far too many: packing a long list only to see
// that takes longer than what is then held.
std::size_t room_for(const ExploreReport& report) {
  const std::size_t listed = listed_designs(report).size();
  if (listed <= 4 * probed) return listed;
  const HeldDesigns first = packed_designs(report, probed);
  const auto others = static_cast<double>(first.designs.size() - probed);
  const double room =
      std::max(0.0, part_filled * share_of_room(first) * (probed + others) - others);
  constexpr double clearly = 1.25;
  return clearly * room < static_cast<double>(listed) ? static_cast<std::size_t>(room) : listed;
}

// Why a known routing is not in the list, or one of the trade-off.
std::string standing(const ReferenceStanding& reference, const ExploreReport& report) {
  if (!reference.generated && report.result.partial)
    return "it was not reached before the exploration stopped";
  if (!reference.generated) return "these parts, or this shard, do not give it";
  if (reference.rejected_by) {
    return "it fails " + report.options.constraints[*reference.rejected_by].text;
  }
  return fmt::format("its rank is beyond the list, and {} designs dominate it",
                     reference.dominated_by);
}

}  // namespace

HeldDesigns held_designs(const ExploreReport& report) {
  std::size_t most = room_for(report);
  for (;;) {
    HeldDesigns held = packed_designs(report, most);
    if (held.packed.size() <= column_bytes) return held;
    most = static_cast<std::size_t>(part_filled * share_of_room(held) * static_cast<double>(most));
  }
}

DetailedDesigns detailed_designs(const ExplorationView& view) {
  DetailedDesigns designs{in_order_of_details(view.report, details_of(view)), {}};
  if (view.details || view.report.result.partial) return designs;
  const std::vector<const Routing*> more =
      in_order_of_details(view.report, details_of(view) + usual_first_schematics);
  designs.brief.assign(more.begin() + static_cast<std::ptrdiff_t>(designs.whole.size()),
                       more.end());
  return designs;
}

std::string held_text(const ExploreReport& report, std::size_t held) {
  const std::size_t listed = listed_designs(report).size();
  std::string text =
      fmt::format("{} of {} ranked designs are listed", listed, ranked_designs(report));
  if (held < listed) text += fmt::format("; this page holds the first {}", held);
  return text + fmt::format(". {} of them {} on the front.", report.front.size(),
                            report.front.size() == 1 ? "is" : "are");
}

std::string sample_text(std::ptrdiff_t others) {
  if (others == 0) return "";
  return fmt::format(" {} others, drawn at random, show the rest.", others);
}

Json standings_json(const ExploreReport& report) {
  Json json = Json::object();
  for (const ListedDesign* design : named_designs(report)) {
    json[design->ranked.design.word] = "Named in the answer; not among the listed designs.";
  }
  for (const ReferenceStanding& reference : report.result.references) {
    json[reference.design.word] = fmt::format("Known routing, not among the listed designs: {}.",
                                              standing(reference, report));
  }
  return json;
}

std::string details_text(const ExplorationView& view, const DesignDetails& details) {
  const std::size_t listed = listed_designs(view.report).size();
  const std::size_t all = designs_with_details(view.report);
  if (details.designs >= all) {
    return fmt::format(
        "All {} listed designs and known routings have schematics, tensions and contacts here.",
        all);
  }
  const bool full = details.designs < in_order_of_details(view.report, details_of(view)).size();
  const std::string brief =
      details.brief == 0
          ? ""
          : fmt::format(", and {} more their schematic in the first grasp", details.brief);
  return fmt::format(
      "{} of {} listed designs and known routings have schematics, tensions and contacts here{}: "
      "named designs and known routings first, then by rank. For the others the page gives "
      "the values and the command that shows the rest; {}.",
      details.designs, all, brief,
      full ? "there is no room for more of them, whatever --details says"
           : fmt::format("with --details {} it has all, as far as there is room", listed));
}

}  // namespace reeve::pages
