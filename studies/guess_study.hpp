// Proposes what `import` would make of a logger's file of unknown columns. The report has a guessed
// mapping, the log as it would be read by it, and all that is missing.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "core/error.hpp"
#include "readings/log/guessed_columns.hpp"
#include "readings/log/logged_series.hpp"
#include "studies/import_study.hpp"

namespace reeve::studies {

struct GuessReport {
  std::string file;
  LogGuess guess;
  std::optional<LoggedSeries> series;  // none if the log cannot be read by that mapping
  std::vector<InputFault> faults;      // why not, or what is wrong with the labels
  ImportLabels given;
  // These members are true for what neither the log nor the user says.
  bool lacks_routing = false;
  bool lacks_run = false;
  bool lacks_held = false;
  bool lacks_motion = false;
  bool lacks_motor_tension = false;

  // True if no more than a routing is missing.
  bool can_be_read() const { return series && faults.empty(); }
  bool can_be_imported() const { return can_be_read() && !lacks_routing; }
};

// Throws InputError if the file cannot be read at all.
GuessReport guess_study(const std::filesystem::path& path, const ReadingOptions& options,
                        const ImportLabels& given, const RoutingResolver& resolve);

}  // namespace reeve::studies
