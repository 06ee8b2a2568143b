// One reading from a steady stretch of samples: means over the samples that hold up.
//
// Left out of the stretch, and marked, are samples that lack a value which most of the others have,
// copies (a logger that repeats its last sample while the carriage moves), and spikes: samples with
// a tension farther than six robust standard deviations, and than the tolerance, from a line
// through the medians of the first and the last third.
//
// Means are over the same samples for all signals, so that they belong together even where the load
// grows along the stretch. Deviations are those about the least-squares line in time, so that such
// growth is not counted as noise.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/grasp.hpp"
#include "readings/log/logged_series.hpp"
#include "readings/log/sample_use.hpp"

namespace reeve::readings {

struct AveragedTension {
  double mean_N = 0;
  double deviation_N = 0;  // standard deviation of one sample
};

struct SteadyReading {
  std::size_t begin = 0;  // samples [begin, end)
  std::size_t end = 0;
  std::size_t label = 0;  // index into LoggedSeries::labels
  Direction direction = Direction::pull;
  double time_s = 0;         // mean of the samples
  std::size_t samples = 0;   // number of averaged samples
  std::size_t readings = 1;  // number of independent readings that they are worth
  std::optional<double> speed_mm_s;
  std::optional<AveragedTension> motor_tension_N;
  std::vector<std::optional<AveragedTension>> tensions_N;  // parallel to the series' tensions
  std::vector<std::optional<double>> others;               // likewise
};

// A reading before its scatter is known.
struct AveragedStretch {
  SteadyReading reading;
  // Residuals of the motor tension and of each tension about their lines; empty if there are none.
  std::vector<std::vector<double>> residuals_N;
};

// Averages samples [begin, end) of one recording and marks them in `uses`. Returns nothing if fewer
// than five samples are good. The caller sets label and direction.
std::optional<AveragedStretch> average(const LoggedSeries& series, std::size_t begin,
                                       std::size_t end, double tolerance,
                                       std::vector<SampleUse>& uses);

// Adds the deviations, and the number of independent readings by the noise of all samples together.
std::vector<SteadyReading> with_scatter(std::vector<AveragedStretch> stretches);

}  // namespace reeve::readings
