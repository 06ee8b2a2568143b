#include "diagnosis/data/checks/letters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "core/motor_sides.hpp"

namespace reeve::diagnosis {

std::vector<DataNote> notes_on_letters(const MeasuredData& data, bool lettered) {
  std::vector<DataNote> notes;
  if (!lettered) return notes;
  for (const MeasuredRouting& routing : data.routings) {
    const Network& network = routing.network;
    if (letters_match_strands(network)) continue;
    std::string key;
    for (const MotorSide& side : motor_sides(network)) {
      const auto measured = std::find(routing.segments.begin(), routing.segments.end(),
                                      std::optional(side.motor_side));
      if (measured == routing.segments.end()) continue;
      key += fmt::format("{}{} is beside {}", key.empty() ? "" : ", ",
                         segment_name(network.segments[side.motor_side]),
                         segment_name(network.segments[side.hand]));
    }
    if (key.empty()) continue;
    notes.push_back({NoteKind::letters,
                     fmt::format("letters run in walk order: in {} {}. Where a, b, c, d were meant "
                                 "beside T1, T2, T3, T4, name the columns at_T1_N and so on",
                                 routing.word, key),
                     {}});
  }
  return notes;
}

}  // namespace reeve::diagnosis
