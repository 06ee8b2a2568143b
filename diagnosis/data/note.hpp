// What whoever reads the results should know about the data: noted, never mended silently.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "numerics/floors.hpp"

namespace reeve::diagnosis {

enum class NoteKind : std::uint8_t {
  time_series,             // samples of a logger in place of readings (recognise_series.hpp)
  duplicate,               // rows equal in all but their line
  duplicate_across_runs,   // … and in the name of the run
  motor_side_above_motor,  // a motor-side segment carries more than the whole carriage
  units,                   // tensions that no sheath or no hand explains
  covariate,               // a column that the model does not know
  comment,                 // comment lines below the header, which may be rows switched off
  jams,                    // grasps in which the carriage is blocked (comparison.hpp)
  not_compared,            // values that there is nothing to compare with (comparison.hpp)
  clock,                   // of a time series: set back (steady_readings.hpp)
  no_motion,               // of a time series: it does not say when the carriage moves
  reversed,                // of a time series: pulling looks like releasing
};
const char* note_kind_name(NoteKind kind);

struct DataNote {
  NoteKind kind = NoteKind::duplicate;
  std::string text;
  std::vector<std::size_t> lines;  // ascending; empty if it is about the whole file
};

}  // namespace reeve::diagnosis
