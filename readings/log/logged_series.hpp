// A logger's time series as it stands in its file: one row for each sample, hundreds a second.
// Neighbouring samples share most of their noise, so they are no readings; steady_readings.hpp
// makes readings of them.
//
// A cell that is empty or says so (csv_number.hpp) is a missing value, and NaN here. Samples that
// cannot be read are errors that name line and column, all of them; nothing is dropped. Rows of
// zeros (intake/tare.hpp) are no samples: they are taken off those below, and cut the log.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "numerics/floors.hpp"
#include "readings/note.hpp"
#include "readings/reading_options.hpp"

namespace reeve::readings {

// A column of a log that has words: labels, which stay for a while, or what goes with the samples,
// such as a clock on the wall. A log that is cut where the latter change has no steady stretch.

class LogWords {
 public:
  // Of the next samples.
  void add(std::string_view word, std::size_t samples = 1);

  std::size_t size() const { return ids_.size(); }
  // Equal for equal words.
  std::uint32_t id(std::size_t sample) const { return ids_[sample]; }
  const std::string& word(std::size_t sample) const { return *words_[ids_[sample]]; }

  // Whether they label: no times of day, alone or behind a date, and on average each stays over as
  // many samples as the shortest reading has.
  bool are_labels() const;

 private:
  std::size_t changes() const;
  bool are_times_of_day() const;

  std::map<std::string, std::uint32_t, std::less<>> known_;
  std::vector<const std::string*> words_;  // by id
  std::vector<std::uint32_t> ids_;
};

struct LoggedSignal {
  std::string name;            // as docs write it; "" if the log has no such column
  std::vector<double> values;  // parallel to the samples; empty without a column
  std::string column = {};     // its name in the file

  bool is_logged() const { return !name.empty(); }
};

// What the log says of a sample in words; "" where it says nothing.
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
  std::vector<std::size_t> lines;     // of the samples
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
  std::vector<std::size_t> label;      // of each sample, in labels
  std::vector<std::size_t> zeroed_at;  // samples above which new zeros stand, ascending
  std::vector<DataNote> notes;

  std::size_t size() const { return time_s.size(); }
};

// Both throw InputError. `name` stands for the file in messages.
LoggedSeries read_logged_series(const std::filesystem::path& path,
                                const ReadingOptions& options = {});
LoggedSeries parse_logged_series(std::string text, const std::string& name,
                                 const ReadingOptions& options = {});

}  // namespace reeve::readings
