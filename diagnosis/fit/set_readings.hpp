// Readings that were set, such as those of weights that hang where the sensor is, and of which the
// motor tension is what was read.
//
// Such readings come in clusters, in which the motor tension M scatters and the readings T do not
// follow it: with sums over the pairs of each cluster about its means, and over clusters,
//
//   sum dM dT / sum dM^2 (within) < half of sum dM dT / sum dM^2 (between)
//
// or the readings of a cluster are all the same.
#pragma once

#include <optional>

#include "diagnosis/dataset.hpp"

namespace reeve::diagnosis {

struct SetReadings {
  double motor_N = 0;  // by which the motor tension scatters about them
  // Each run has readings of one cluster: what differs between runs is what was set.
  bool one_of_each_run = false;
  bool several = false;  // clusters, which tell that scatter from what friction does
};

// Returns nothing of readings that were not set, or of rows with several readings.
std::optional<SetReadings> set_readings(const Dataset& dataset);

}  // namespace reeve::diagnosis
