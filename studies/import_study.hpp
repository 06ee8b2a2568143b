// A logger's time series made into steady readings, and what the log leaves open filled in.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "readings/log/logged_series.hpp"
#include "readings/log/steady_readings.hpp"
#include "readings/measured_data.hpp"

namespace reeve::studies {

// Labels of the whole log, each for a column that the log lacks.
struct ImportLabels {
  std::optional<std::string> run = {};
  std::optional<std::string> routing = {};
  std::optional<std::string> held = {};
  std::string start = {};  // of the names of these labels in messages, such as "--"
};

struct ImportReport {
  LoggedSeries series;
  SteadyOptions options;
  ImportLabels given;
  std::vector<LogLabels> labels;  // as those of the series, with nothing left open
  SteadyReadings steady;
};

// The run is 1 where nothing says another. Throws InputError: a label that no reading could have,
// or one that is given and logged.
ImportReport import_study(LoggedSeries series, const ImportLabels& given,
                          const SteadyOptions& options, const RoutingResolver& resolve);

// Throws what import_study would throw of the labels.
void require_labels(const LoggedSeries& series, const ImportLabels& given,
                    const RoutingResolver& resolve);

}  // namespace reeve::studies
