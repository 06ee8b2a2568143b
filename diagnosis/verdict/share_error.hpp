// How far the forecasts are off in the tension distribution: of a pulled row with readings of all
// strands of its routing,
//
//   error = √ Σ_i (T_i / ΣT − p_i / Σp)²        p: forecast of the strands' readings
//
// averaged over the rows of a routing in one grasp, and then over these. So the Exo-Glove II
// supplement must have taken its 13.6 % and 3.4 % (docs/diagnosis.md).
#pragma once

#include <optional>
#include <vector>

#include "diagnosis/verdict/compared_cell.hpp"
#include "readings/measured_data.hpp"

namespace reeve::diagnosis {

struct ShareError {
  std::size_t routing = 0;  // in MeasuredData::routings
  Grasp grasp;
  std::size_t rows = 0;
  std::size_t held_out_rows = 0;
  double before = 0;               // error of the nominal model
  double after = 0;                // error of the extended model
  std::optional<double> left_out;  // error of the causes fitted without the row's run
};

struct ShareErrors {
  std::vector<ShareError> groups;  // in the order of the file
  double before = 0;               // means over the groups
  double after = 0;
  std::optional<double> left_out;
};

// Empty where no row has all strands.
ShareErrors share_errors(const MeasuredData& data, const std::vector<ComparedCell>& cells);

// √ Σ (T_i / ΣT − s_i)² of shares as they are, which as printed need not add up to 1.
double distance_to_shares(const std::vector<double>& tensions, const std::vector<double>& shares);
// The same of the shares of two lists of tensions.
double share_distance(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace reeve::diagnosis
