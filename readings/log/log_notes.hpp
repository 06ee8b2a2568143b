// What a log says of itself that does not go together, or is less than it seems.
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

// What a log's column `direction` says, beside how the carriage moves. A position may count the
// other way, and then motion and column differ throughout; but where within one run the column says
// one direction of both motions, it is wrong of one of them.
class SaidDirections {
 public:
  // Of a stretch that begins at that line; nothing is added where either is unknown.
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

// Whether a log's position or speed counts the other way: friction adds to the motor tension while
// the carriage pulls, and takes from it while it releases.
//
// That is said where the median motor tension of pulling readings is below that of releasing ones
// by more than the tolerance and three standard errors of the two medians, loads that differ
// included. A controller that holds the motor tension makes it say nothing. (Nor is a single strand
// as good a witness: where a finger is held, one may carry less while the carriage releases.)
std::optional<DataNote> reversed_motion(const std::vector<SteadyReading>& readings,
                                        double tolerance);

// Returns a note for each tension that readings do not have, since the log has it too seldom, with
// the share that is missing: a mean is made of a channel that at least half of a reading's samples
// have (steady_reading.hpp). A channel that has no value there at all is off, and no matter of
// this.
std::vector<DataNote> sparse_channels(const LoggedSeries& series,
                                      const std::vector<SteadyReading>& readings);

}  // namespace reeve::readings
