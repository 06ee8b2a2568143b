// A logger's time series as it stands in its file: one row for each sample, hundreds a second.
// Neighbouring samples share most of their noise, so they are no readings; steady_readings.hpp
// makes readings of them.
//
// A cell that is empty or says so (is_missing) is a missing value, and NaN here. Samples that
// cannot be read are errors that name line and column, all of them; nothing is dropped. Rows of
// zeros (rows.hpp) are no samples: they are taken off those below, and cut the log.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "readings/note.hpp"
#include "readings/reading_options.hpp"

namespace reeve::readings {

struct LoggedSignal {
  std::string name;            // name in the docs; "" if the log has no such column
  std::vector<double> values;  // parallel to the samples; empty without a column
  std::string column = {};     // its name in the file

  bool is_logged() const { return !name.empty(); }
};

// The log's labels of a sample; "" if it has none.
struct LogLabels {
  std::string run;
  std::string routing;
  std::string held;
  std::string direction;

  friend auto operator<=>(const LogLabels&, const LogLabels&) = default;
};

struct LoggedSeries {
  std::string file;
  bool simulated = false;             // a comment line says so
  std::vector<std::string> comments;  // above the header
  std::vector<std::size_t> lines;     // line of each sample
  std::vector<double> time_s;
  LoggedSignal position_mm;
  LoggedSignal speed_mm_s;
  LoggedSignal motor_tension_N;
  std::vector<LoggedSignal> tensions_N;  // at least one
  std::vector<LoggedSignal> others;
  bool has_runs = false;  // columns of labels
  bool has_routings = false;
  bool has_held = false;
  std::vector<LogLabels> labels;       // two may be alike: columns of other words part them
  std::vector<std::size_t> label;      // [sample]: index into labels
  std::vector<std::size_t> zeroed_at;  // samples above which new zeros stand, ascending
  std::vector<DataNote> notes;

  std::size_t size() const { return time_s.size(); }
  // The motor tension, if it is logged, and the tensions.
  std::vector<const LoggedSignal*> sensors() const;
};

// Both throw InputError. `name` stands for the file in messages.
LoggedSeries read_logged_series(const std::filesystem::path& path,
                                const ReadingOptions& options = {});
LoggedSeries parse_logged_series(std::string text, const std::string& name,
                                 const ReadingOptions& options = {});

}  // namespace reeve::readings
