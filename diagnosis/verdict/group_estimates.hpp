// The coefficients and causes of a model in each group of rows by itself: a winch, an operator.
//
// Each group's readings are fitted alone, with the scatter that all readings have. A group stands
// out in a parameter if
//
//   t = (x_g − x_o) / √(s_g² + s_o²),   x_o = Σ x/s² / Σ 1/s²,   s_o² = 1 / Σ 1/s²
//
// (x_o: of all other groups) is beyond Student's t of Welch's degrees of freedom at alpha over as
// many comparisons as are made (B. L. Welch, Biometrika 34, 1947).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "diagnosis/fit/intervals.hpp"
#include "diagnosis/fit/mounting_scatter.hpp"

namespace reeve::diagnosis {

// Greatest number of groups listed; nobody reads a longer list.
inline constexpr std::size_t most_groups_estimated = 40;

struct GroupEstimate {
  std::size_t group = 0;  // in MeasuredData::groups
  double value = 0;
  ParameterInterval interval;
};

// One effect's size in each group. Groups whose readings hardly determine it are left out.
struct EstimatesByGroup {
  std::string cause;
  std::string parameter;
  std::string unit;
  std::vector<GroupEstimate> groups;  // two or more
  std::size_t farthest = 0;           // in MeasuredData::groups: the one that stands out most
  double p_value = 1;                 // chance of a difference so large, over all comparisons
  bool differs = false;
};

// In the order of the model's effects. None without groups.
std::vector<EstimatesByGroup> estimates_by_group(const MeasuredData& data,
                                                 const std::vector<std::size_t>& readings,
                                                 const Model& model, const Scatter& scatter,
                                                 double mounting_degrees, double alpha,
                                                 Workers& workers);

}  // namespace reeve::diagnosis
