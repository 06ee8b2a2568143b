// What a log's column `direction` says, beside how the carriage moves. A position may count the
// other way, and then motion and column differ throughout; but where within one run the column says
// one direction of both motions, it is wrong of one of them.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/grasp.hpp"
#include "readings/note.hpp"

namespace reeve::readings {

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

}  // namespace reeve::readings
