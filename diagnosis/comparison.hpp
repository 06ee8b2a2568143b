// Measured tensions beside those of the nominal model: nothing is fitted, nothing is tuned.
//
// Let p_i be the forecast of what segment i's sensor reads (fit/forecast.hpp), in the row's
// routing, grasp and direction.
//   with motor_tension_N     every measured segment: T_i in newton beside p_i
//   without                  the measured strands: the share T_i / Σ T beside p_i / Σ p, both sums
//                            over the strands that the row has (as the Exo-Glove II paper does)
// Residuals are measured − predicted. A row's sheath_angle_rad stands for the wrap angle of every
// sheath in that row, over whatever the hardware says of it, also for one finger or one contact.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "causes/model.hpp"
#include "readings/measured_data.hpp"

namespace reeve::diagnosis {

enum class ComparedQuantity : std::uint8_t {
  tension,  // N
  share,    // share of the measured strands' sum, 1
};
const char* quantity_name(ComparedQuantity quantity);

struct ComparedValue {
  std::size_t reading = 0;  // in MeasuredData::readings
  std::size_t channel = 0;  // in MeasuredData::channels
  ComparedQuantity quantity = ComparedQuantity::tension;
  double measured = 0;
  double predicted = 0;

  double residual() const { return measured - predicted; }
};

// In the quantity's unit. All but the count are NaN where there is nothing to divide by.
struct ResidualSummary {
  std::string group;
  std::size_t count = 0;
  double mean_measured = 0;
  double mean_residual = 0;
  double rms = 0;           // root of the mean squared residual, about zero
  double relative_rms = 0;  // rms / mean_measured, 1
};

struct QuantitySummary {
  ResidualSummary all;
  std::vector<ResidualSummary> by_routing;    // words, in the order of the file
  std::vector<ResidualSummary> by_channel;    // in the order of the columns
  std::vector<ResidualSummary> by_grasp;      // "none", "1", "1,2"
  std::vector<ResidualSummary> by_direction;  // "pull", "release"
  std::vector<ResidualSummary> by_run;        // in the order of the file
  std::vector<ResidualSummary> by_group;      // likewise; of rows that have one
};

struct Comparison {
  std::vector<ComparedValue> values;  // in the order of readings and channels
  QuantitySummary tension;            // count 0 where no row has a motor tension
  QuantitySummary share;              // count 0 where all rows have one
  std::vector<DataNote> notes;        // on the comparison; those on the data are in the data
};

// Throws InputError if there is nothing at all to compare, and OutOfRange that names the line where
// the model has no tensions.
Comparison compare(const MeasuredData& data, const Model& model);

}  // namespace reeve::diagnosis
