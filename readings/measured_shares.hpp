// Measured strand tensions as shares of their sum, averaged over the readings of one routing in one
// grasp, pulling.
//
// A share needs all strands: the reading of a row in which one is missing has none.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "readings/measured_data.hpp"

namespace reeve::readings {

struct MeasuredShares {
  std::size_t routing = 0;  // index into MeasuredData::routings
  Grasp grasp;
  std::size_t readings = 0;
  std::vector<double> mean;  // means for T1 … T2n
  // Standard deviation over the readings; empty if there is only one.
  std::vector<double> deviation;
};

struct SharesOfData {
  std::vector<MeasuredShares> groups;  // sorted as in the file
  std::vector<DataNote> notes;         // on readings that are in no group
};

// The columns of T1 … T2n, n: fingers of the routing; empty if one is not among them.
std::vector<std::size_t> strand_channels(const MeasuredData& data, const MeasuredRouting& routing);

// T1 … T2n of a reading; nothing if one of them is missing.
std::optional<std::vector<double>> strand_tensions(const MeasuredData& data,
                                                   const Reading& reading);

SharesOfData measured_shares(const MeasuredData& data);

}  // namespace reeve::readings
