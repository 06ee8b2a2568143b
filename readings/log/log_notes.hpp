// Notes on a log's contradictions and gaps.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/grasp.hpp"
#include "readings/log/steady_reading.hpp"

namespace reeve::readings {

// Compares a log's column `direction` with the motion of the carriage. A position may count the
// other way: motion and column then differ throughout. If within one run the column has one
// direction for both motions, it is wrong for one of them.
class SaidDirections {
 public:
  // Adds a stretch that begins at that line, unless one of the directions is unknown.
  void add(const std::string& run, std::optional<Direction> said, std::optional<Direction> moved,
           std::size_t line);
  // Names the stretches that do not move as is said.
  std::optional<DataNote> note() const;

 private:
  struct Lines {
    std::vector<std::size_t> as_said;
    std::vector<std::size_t> otherwise;
  };

  std::map<std::pair<std::string, Direction>, Lines> lines_;
};

// Returns a note if a log's position or speed counts the other way. Friction adds to the motor
// tension while the carriage pulls, and takes from it while it releases.
//
// Criterion: the median motor tension of pulling readings is below that of releasing ones by more
// than the tolerance and three standard errors of the two medians, with the scatter of the loads.
// If a controller holds the motor tension, no note results. A single strand is no good witness: if
// a finger is held, it may carry less while the carriage releases.
std::optional<DataNote> reversed_motion(const std::vector<SteadyReading>& readings,
                                        double tolerance);

// Returns a note for each tension that readings do not have, since the log has it too seldom, with
// the share that is missing: a mean is made of a channel that at least half of a reading's samples
// have (steady_reading.hpp). A channel that has no value there at all is off, and no matter of
// this.
std::vector<DataNote> sparse_channels(const LoggedSeries& series,
                                      const std::vector<SteadyReading>& readings);

}  // namespace reeve::readings
