// What whoever reads the results should know about the data: noted, never mended silently.
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
  column_names,            // how names and units of columns were taken, if not as docs write them
  passed_over,             // rows and columns that have no readings
  tare,                    // zeros that were taken off
  known_noise,             // what readings are told to scatter by
  assumed,                 // what the file leaves open
  not_as_pulled,           // tensions that no pulling carriage gives
  letters,                 // of segments that another source may use otherwise
  outlier,                 // cells far from all others of their kind
  below_zero,              // tensions that a slack strand or a drifted zero gives
  inverted,                // channels that read the more below zero, the more is pulled
  jams,                    // grasps in which the carriage is blocked (comparison.hpp)
  not_compared,            // values that there is nothing to compare with (comparison.hpp)
  clock,                   // of a time series: set back (steady_readings.hpp)
  no_direction,            // of a time series: it moves, and may pull or release
  no_motion,               // of a time series: it does not say when the carriage moves
  groups_differ,           // what is said of all groups together does not hold of each
  runs_of_groups,          // runs of one name in several groups
  outlier_forecast,        // held-out readings that the model is far from (outlier_forecasts.hpp)
  other_direction,         // rows that read as the other direction (other_direction.hpp)
  outlier_groups,          // readings far off, of one channel in some runs (outlier_groups.hpp)
  not_following,           // of a time series: a tension stays where the load changes
  reversed,                // of a time series: pulling looks like releasing
  against_motion,          // of a time series: its column direction says otherwise than it moves
  sparse,                  // of a time series: tensions that too few samples have
  silent_run,              // of a run in which no sensor says anything (silent_runs.hpp)
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
                             "groups_differ",
                             "runs_of_groups",
                             "far_forecast",
                             "other_direction",
                             "far_together",
                             "not_following",
                             "reversed",
                             "against_motion",
                             "sparse",
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
