// Notes on the data for whoever reads the results. Data are never changed silently.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "numerics/floors.hpp"

namespace reeve::readings {

enum class NoteKind : std::uint8_t {
  time_series,             // samples of a logger in place of readings (recognise_series.hpp)
  duplicate,               // copies of a row of the same run
  duplicate_across_runs,   // … of another run
  equal_by_chance,         // rows equal in every tension, as coarse sensors make them
  motor_side_above_motor,  // a motor-side segment carries more than the whole carriage
  units,                   // tensions that no sheath or no hand explains
  covariate,               // a column that the model does not know
  comment,                 // comment lines below the header, which may be rows switched off
  column_names,            // names and units of columns, if not as the docs write them
  passed_over,             // rows and columns that have no readings
  tare,                    // zeros that were taken off
  known_noise,             // scatter of readings that the user gave
  assumed,                 // facts that the file leaves open
  not_as_pulled,           // tensions that no pulling carriage gives
  letters,                 // letters of segments that another source may use otherwise
  outlier,                 // cells far from all others of their kind
  below_zero,              // tensions that a slack strand or a drifted zero gives
  inverted,                // channels that read the more below zero, the more is pulled
  jams,                    // grasps in which the carriage is blocked (comparison.hpp)
  not_compared,            // values that there is nothing to compare with (comparison.hpp)
  clock,                   // time series: the clock is set back (steady_readings.hpp)
  no_direction,            // time series: the motion may be a pull or a release
  no_motion,               // time series: nothing says when the carriage moves
  runs_of_groups,          // runs of one name in several groups
  outlier_forecast,        // held-out readings that the model is far from (outlier_forecasts.hpp)
  other_direction,         // rows that read as the other direction (model_doubts.hpp)
  shifted_rows,            // motor tensions of other rows than theirs (model_doubts.hpp)
  outlier_groups,          // readings far off, of one channel in some runs (outlier_groups.hpp)
  not_following,           // time series: a tension stays the same while the load changes
  reversed,                // time series: pulling looks like releasing
  against_motion,          // time series: its column direction contradicts its motion
  sparse,                  // time series: tensions that too few samples have
  stuck_channel,           // a sensor that reads the same in a run (stuck_channels.hpp)
  silent_run,              // a run without any sensor signal (silent_runs.hpp)
  outside_law,             // beyond the range that a law of the model was seen in
};

inline const char* note_kind_name(NoteKind kind) {
  constexpr std::array names{"time_series",
                             "duplicate",
                             "duplicate_across_runs",
                             "equal_by_chance",
                             "motor_side_above_motor",
                             "units",
                             "covariate",
                             "comment",
                             "column_names",
                             "passed_over",
                             "tare",
                             "known_noise",
                             "assumed",
                             "not_as_pulled",
                             "letters",
                             "outlier",
                             "below_zero",
                             "inverted",
                             "jams",
                             "not_compared",
                             "clock",
                             "no_direction",
                             "no_motion",
                             "runs_of_groups",
                             "far_forecast",
                             "other_direction",
                             "shifted_rows",
                             "far_together",
                             "not_following",
                             "reversed",
                             "against_motion",
                             "sparse",
                             "stuck_channel",
                             "silent_run",
                             "outside_law"};
  static_assert(names.size() == static_cast<std::size_t>(NoteKind::outside_law) + 1);
  return names[static_cast<std::size_t>(kind)];
}

struct DataNote {
  NoteKind kind = NoteKind::duplicate;
  std::string text;
  std::vector<std::size_t> lines = {};  // ascending; empty if it is about the whole file
};

}  // namespace reeve::readings
