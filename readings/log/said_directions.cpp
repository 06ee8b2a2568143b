#include "readings/log/said_directions.hpp"

#include <algorithm>

namespace reeve::readings {

void SaidDirections::add(const std::string& run, std::optional<Direction> said,
                         std::optional<Direction> moved, std::size_t line) {
  if (!said || !moved) return;
  Lines& lines = lines_[{run, *said}];
  (*said == *moved ? lines.as_said : lines.otherwise).push_back(line);
}

std::optional<DataNote> SaidDirections::note() const {
  DataNote result{NoteKind::against_motion,
                  "the column 'direction' says one direction while the carriage moves one way and "
                  "the other, in one run: readings have what the column says, and where it is not "
                  "the motion it is wrong here, or, if the position counts the other way, "
                  "everywhere else",
                  {}};
  for (const auto& [key, lines] : lines_) {
    if (lines.as_said.empty()) continue;
    result.lines.insert(result.lines.end(), lines.otherwise.begin(), lines.otherwise.end());
  }
  if (result.lines.empty()) return std::nullopt;
  std::sort(result.lines.begin(), result.lines.end());
  return result;
}

}  // namespace reeve::readings
