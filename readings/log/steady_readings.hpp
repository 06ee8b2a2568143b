// Steady readings from a logger's time series, and the use of each sample.
//
//   log → recordings → blocks → stretches in which the carriage moves evenly (sliding.hpp)
//       → their settled parts (settling.hpp) → readings (steady_reading.hpp)
//
// A log without position and speed gives its steady levels (steady_levels.hpp). A settled part
// along which the load changes by more than five times the tolerance is a sweep. It is cut into
// several readings of equal duration, so that each has a load of its own.
//
// Assumption: the carriage is slow, so tensions are those of equilibrium at every moment.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "readings/log/logged_series.hpp"
#include "readings/log/sample_use.hpp"
#include "readings/log/sliding.hpp"
#include "readings/log/steady_reading.hpp"

namespace reeve::readings {

struct SteadyOptions {
  double min_duration_s = 0.5;          // least duration of a reading
  double tolerance = 0.02;              // relative change up to which a tension counts as unchanged
  std::size_t readings_per_stroke = 5;  // readings at most
  bool reverse = false;                 // positions and speeds fall while the carriage pulls
  std::optional<Direction> direction;   // direction to assume if the log does not say
};

struct SteadyReadings {
  std::vector<SteadyReading> readings;  // sorted by sample
  std::vector<SampleUse> uses;          // use of each sample
  MotionSource motion = MotionSource::none;
  double usual_step_s = 0;
  std::vector<DataNote> notes;
};

SteadyReadings steady_readings(const LoggedSeries& series, const SteadyOptions& options);

}  // namespace reeve::readings
