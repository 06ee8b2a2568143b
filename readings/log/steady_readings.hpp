// From a logger's time series to steady readings, and what became of each sample.
//
//   log → recordings → blocks → stretches in which the carriage moves evenly (sliding.hpp)
//       → their settled parts (settling.hpp) → readings (steady_reading.hpp)
//
// and of a log without position and speed, its steady levels (steady_levels.hpp). A settled part
// along which the load changes by more than five times the tolerance is a sweep, and is cut into
// several readings of equal duration, so that each stands for a load of its own.
//
// Assumed is that the carriage is slow: tensions are those of equilibrium at every moment.
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
  double least_time_s = 0.5;           // that a reading lasts
  double tolerance = 0.02;             // relative, within which a tension is as it was
  std::size_t per_sweep = 5;           // readings at most
  bool reverse = false;                // positions and speeds fall while the carriage pulls
  std::optional<Direction> direction;  // where the log does not say
};

struct SteadyReadings {
  std::vector<SteadyReading> readings;  // in the order of the samples
  std::vector<SampleUse> uses;          // of each sample
  MotionSource motion = MotionSource::none;
  double usual_step_s = 0;
  std::vector<DataNote> notes;
};

SteadyReadings steady_readings(const LoggedSeries& series, const SteadyOptions& options);

}  // namespace reeve::readings
