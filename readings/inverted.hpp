// Channels whose sign is exchanged: a load cell that is mounted or wired the other way round reads
// the more below zero, the more is pulled. A zero that has drifted, or a slack strand, does not
// follow the load.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "numerics/floors.hpp"
#include "readings/log/logged_series.hpp"
#include "readings/measured_data.hpp"
#include "readings/note.hpp"

namespace reeve::readings {

// Whether what a sensor reads falls while the load grows: what tells a sensor that is the other way
// round, of readings and of samples alike.

class SignCount {
 public:
  void add(double tension_N) {
    ++given_;
    below_ += tension_N < 0 ? 1 : 0;
  }
  // Four of five, and enough to tell.
  bool nearly_all_below() const {
    return given_ >= 5 && static_cast<double>(below_) >= 0.8 * static_cast<double>(given_);
  }

 private:
  std::size_t given_ = 0;
  std::size_t below_ = 0;
};

// Of rows alike but for the load, about their own means: what arrives of a load depends on all
// else.
struct LoadedRows {
  double rows = 0;
  double mean_load = 0, mean_reading = 0;
  double square_load = 0, square_reading = 0;
  double product = 0;

  void add(double load, double reading) {
    ++rows;
    const double load_off = load - mean_load;
    const double reading_off = reading - mean_reading;
    mean_load += load_off / rows;
    mean_reading += reading_off / rows;
    square_load += load_off * (load - mean_load);
    square_reading += reading_off * (reading - mean_reading);
    product += load_off * (reading - mean_reading);
  }
};

// By the mean correlation over the groups, of which each has a size of its own; of two rows it
// would be ±1. Noise and friction leave far more than -0.5 of it, a drifting zero far less.
inline bool falls_with_load(const std::vector<LoadedRows>& groups) {
  double sum = 0;
  double weights = 0;
  for (const LoadedRows& alike : groups) {
    const double scale = std::sqrt(alike.square_load * alike.square_reading);
    if (alike.rows < 3 || !(scale > 0)) continue;
    sum += (alike.rows - 1) * alike.product / scale;
    weights += alike.rows - 1;
  }
  return weights > 0 && sum / weights < -0.5;
}

// One note that names those channels. Nothing is changed: what else is exchanged with the sign, the
// file does not say.
std::optional<DataNote> note_inverted(const MeasuredData& data);
// The same of channels that are known; nothing of none.
std::optional<DataNote> note_on_inverted(const std::vector<std::string>& channels);

// Channels of a log whose sign is exchanged, as in a file of readings (data/checks/inverted.hpp).
// It is asked of the samples, since of a motor tension that reads below zero no reading is made.
//
// What pulls is the size of the motor tension, or for that itself, and where there is none, the sum
// of the sizes of the other tensions. A channel is the other way round if it reads below zero in at
// least four of five samples of the half that pulls most, and its correlation with what pulls,
// within stretches of one label, is below -0.5.

std::optional<DataNote> inverted_signals(const LoggedSeries& series);

}  // namespace reeve::readings
