// What is found in the logs of a simulated rig, whose truth is known at every sample.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "readings/log/steady_readings.hpp"
#include "tests/support/rig_log.hpp"

namespace reeve::testing {

inline const std::vector<RigRun> one_run{
    {"1", "M-1-T-2-F", "", {{0.7, 1.2}, {0.55, 1.5}, {0.45, 1.8}, {0.35, 2.2}}}};

inline LoggedSeries series_of(const std::vector<RigSample>& samples,
                              const RigColumns& columns = {}) {
  return parse_logged_series(rig_csv(samples, one_run, columns), "log.csv");
}

struct RigFinding {
  std::vector<RigSample> samples;
  SteadyReadings found;
};

inline RigFinding readings_on(const RigPlan& plan, const std::vector<RigRun>& runs = one_run) {
  std::vector<RigSample> samples = rig_log(plan, runs);
  SteadyReadings found = steady_readings(series_of(samples), {});
  return {std::move(samples), std::move(found)};
}

inline std::size_t count(const SteadyReadings& found, SampleUse use) {
  return static_cast<std::size_t>(std::count(found.uses.begin(), found.uses.end(), use));
}

inline void expect_sound(const std::vector<RigSample>& samples, const SteadyReadings& found) {
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (found.uses[i] != SampleUse::taken) continue;
    EXPECT_TRUE(samples[i].slides) << "at " << samples[i].time_s << " s";
  }
  for (const SteadyReading& reading : found.readings) {
    const RigSample& middle = samples[(reading.begin + reading.end) / 2];
    EXPECT_EQ(reading.direction == Direction::pull, middle.speed_mm_s > 0) << reading.time_s;
    EXPECT_NEAR(*reading.speed_mm_s, std::abs(middle.speed_mm_s), 0.3);
  }
}

// Mean of the true tensions over the samples that were taken into the reading.
inline double true_mean(const std::vector<RigSample>& samples, const SteadyReadings& found,
                        const SteadyReading& reading, std::size_t strand) {
  double sum = 0;
  for (std::size_t i = reading.begin; i < reading.end; ++i) {
    if (found.uses[i] == SampleUse::taken) sum += samples[i].strands_N[strand];
  }
  return sum / static_cast<double>(reading.samples);
}

inline std::vector<double> deviations_from_truth(const std::vector<RigSample>& samples,
                                                 const SteadyReadings& found) {
  std::vector<double> deviations;
  for (const SteadyReading& reading : found.readings) {
    for (std::size_t strand = 0; strand < 4; ++strand) {
      const AveragedTension& tension = *reading.tensions_N[strand];
      const double error_N = tension.deviation_N / std::sqrt(static_cast<double>(reading.readings));
      deviations.push_back((tension.mean_N - true_mean(samples, found, reading, strand)) / error_N);
    }
  }
  return deviations;
}

inline double share_within(const std::vector<double>& values, double limit) {
  const auto within = std::count_if(values.begin(), values.end(),
                                    [&](double value) { return std::abs(value) <= limit; });
  return static_cast<double>(within) / static_cast<double>(values.size());
}

}  // namespace reeve::testing
