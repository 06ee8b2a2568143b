// Expected value of each cell, from all others of its kind: the rows of one routing, grasp and
// direction.
//
//   ln T(row, channel) ≈ s(row) + l(channel)
//
// since tensions are nearly proportional to the load. s and l are medians taken in turn (Tukey's
// median polish), so one wild cell moves neither. The motor tension is one of the channels; where a
// row has less than three of them, it is the scale itself, and the row's median where there is
// none. Channels that often read nothing are no part of a row's median.
//
// Source: Tukey, Exploratory Data Analysis (1977), chapter 11.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "readings/measured_data.hpp"

namespace reeve::readings {

// `channel` = the number of channels: the motor tension.
struct KindCell {
  std::size_t reading = 0;
  std::size_t channel = 0;
  double value_N = 0;
};

// Sorted by row; the motor tension is the last of a row.
using KindCells = std::vector<KindCell>;

// The cells of each routing, grasp and direction.
std::vector<KindCells> cells_by_kind(const MeasuredData& data);

struct PolishedLevels {
  std::map<std::size_t, double> row;
  std::map<std::size_t, double> channel;

  // NaN where there is no level: all of its row or channel is zero or below.
  double expected_N(const KindCell& cell) const;
};

// `motor` is the channel of the motor tension.
PolishedLevels polished_levels(const KindCells& cells, std::size_t motor);

// The least difference between two of the values that is no rounding error; 0 if there is none.
double least_step(std::vector<double> values);

}  // namespace reeve::readings
