// Chooses the next measurement.
//
// Candidates are steady readings of every strand in the given routings, in each grasp that leaves
// something to close, both directions, at motor tensions, speeds, cycles and temperatures within
// (and a little beyond) what the data have.
//
//   separating  between two explanations A and B: the reading whose forecasts differ most,
//               dᵀ C⁻¹ d / 2 of the differences d_i = (p_A,i − p_B,i) / sd_i, which is the
//               log-likelihood it is expected to bring to whichever is right
//   shrinking   the reading after which the interval of the first named parameter is expected to be
//               narrowest: information matrix JᵀJ of the data, and Jᵀ C⁻¹ J of n such readings
//
// The n readings are of one new mounting, so they share its scatter: C = 1/n + L Lᵀ, with a column
// of L for what each thing that is mounted does to a reading (mounting.hpp).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "causes/model.hpp"
#include "core/routing.hpp"
#include "diagnosis/fit/mounting_scatter.hpp"
#include "diagnosis/fit/problem.hpp"

namespace reeve::diagnosis {

// Readings of one kind that a plan counts on.
inline constexpr int planned_readings = 10;

struct MeasurableRouting {
  std::string word;
  Routing routing;
};

struct Measurement {
  MeasurableRouting routing;
  Grasp grasp;
  Direction direction = Direction::pull;
  Conditions conditions;
  // True for each condition that the measurement needs; the others do not matter to it.
  bool uses_speed = false;
  bool uses_cycle = false;
  bool uses_temperature = false;
};

// Expected reading of one sensor.
struct ExpectedReading {
  std::string segment;     // T1, a, h1
  double expected_N = 0;   // by the extended model; separating: if the first explanation is right
  double other_N = 0;      // separating: if the second is; otherwise the same
  double deviation_N = 0;  // standard deviation of the noise
};

struct PlannedMeasurement {
  Measurement measurement;
  std::string why;                   // one sentence
  std::vector<std::string> between;  // separating: the first explanation and the second
  std::vector<ExpectedReading> expected;
  // Expected from `planned_readings` such readings. Separating: log-likelihood in favour of the
  // true explanation.
  double expected_log_likelihood = 0;
  // Shrinking: width of the interval, now and expected.
  std::string parameter;
  double width_now = 0;
  double width_expected = 0;
};

struct MeasurementPlan {
  const MeasuredData* data = nullptr;       // must outlive the plan
  std::vector<MeasurableRouting> routings;  // to choose from
  Noise noise;
  MountedScatter mounting{};  // of exponents and gains, relative
  double zero_N = 0;          // scatter of the channels' zeros
};

// The data's routings first: what is on the rig is easiest to measure again.
MeasurementPlan measurement_plan(const Dataset& dataset,
                                 const std::vector<MeasurableRouting>& further,
                                 const Scatter& scatter);

// Separates the first of these explanations from the first other one that can be separated from it.
// Returns nothing if no measurement does: they say the same of everything.
std::optional<PlannedMeasurement> separating_measurement(const MeasurementPlan& plan,
                                                         const std::vector<Model>& models,
                                                         const std::vector<std::string>& names);

// Nothing if the model has no parameter that was fitted.
std::optional<PlannedMeasurement> shrinking_measurement(const MeasurementPlan& plan,
                                                        const Problem& problem, const Model& model,
                                                        std::size_t effect);

}  // namespace reeve::diagnosis
