// Readings less what they scatter about, from which the noise is estimated (noise.hpp): repeats
// under the same conditions, and what no smooth law of the conditions explains.
//
// Where the motor tension is known to scatter, what goes with it in all readings of a row is taken
// out of them: with r the residuals and T the levels of the row's readings, r − T Σ w r/T / Σ w.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "diagnosis/dataset.hpp"

namespace reeve::diagnosis {

// A reading less what it scatters about, and which part of its variance is left in that.
struct ScatterSample {
  double level_N = 0;
  double residual_N = 0;
  double kept = 1;
  double motor_variance_N2 = 0;  // from the known scatter of its row's motor tension
  std::size_t row = 0;           // in the dataset
  double scale = 1;              // its group's noise over that of all
};

// Runs have levels of their own, or share one.
enum class Runs : std::uint8_t { by_themselves, alike };

// Returns the median of the readings above 0; 1 N if there are none.
double median_reading(const Dataset& dataset);
// Parallel to the channels: whether its readings tell of a noise that is to be estimated. Not where
// somebody knows it, nor where all are 0: what a dead sensor scatters by is no noise of the others.
std::vector<bool> tell_of_noise(const Dataset& dataset);
// N², of a cell at this forecast: what its motor tension is known to bring.
double motor_variance(const DatasetRow& row, double by_scale);

// Marks the cells that it used; smoothing leaves these alone.
std::vector<ScatterSample> repeats(const Dataset& dataset, Runs runs, std::vector<char>& used);
std::vector<ScatterSample> smoothing(const Dataset& dataset, Runs runs,
                                     const std::vector<char>& used);

// Takes the part out of the samples of a row that a motor tension off by some share would bring.
void take_out_motor(const Dataset& dataset, std::vector<ScatterSample>& samples);

}  // namespace reeve::diagnosis
