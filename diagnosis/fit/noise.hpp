// How far readings of one mounting scatter where nothing changes: sd² = absolute² + (relative T)².
//
// Estimated from
//   repeats     readings of a channel under the same conditions, in one mounting
//   smoothing   other readings of a channel in one routing, grasp and direction, beside a
//               regression of T / T_M on load, speed, cycle, temperature and order, with a level of
//               its own in each run: what no smooth law explains
// together, since repeats of few conditions cannot tell the relative part from the absolute one;
// where the data are too few for that, from
//   residuals   of a model, beside all that a mounting could change (mounting.hpp), or
// where these are too few, too, from the same without regard to runs, or from residuals alone.
// Both parts together maximise the (restricted) likelihood of the residuals.
//
// Channels whose noise somebody knows (readings/measured_data.hpp) tell nothing of that of the
// others. Where the motor tension is known to scatter, what goes with it in all readings of a row
// is taken out of them; of a reading that is alone in its row, the known variance is.
//
// Where somebody names groups of rows (winches, operators), each may have f times the noise of all,
// if that is clearly likelier.
#pragma once

#include <Eigen/Core>

#include <optional>
#include <vector>

#include "diagnosis/dataset.hpp"
#include "diagnosis/fit/forecast.hpp"
#include "diagnosis/fit/mounting.hpp"

namespace reeve::diagnosis {

enum class NoiseSource : std::uint8_t {
  repeats,
  smoothing,
  repeats_and_smoothing,
  residuals,
  known,  // given for every channel
};
const char* noise_source_name(NoiseSource source);

struct Noise {
  double relative = 0;    // share of the reading, 1
  double absolute_N = 0;  // N; at least a thousandth of the median reading, so that a reading of 0
                          // does not weigh infinitely
  NoiseSource source = NoiseSource::residuals;
  double degrees_of_freedom = 0;
  bool within_mountings = true;    // otherwise it contains what differs between them
  std::vector<double> of_group{};  // f, parallel to the data's groups; empty: they scatter alike

  double deviation(double tension_N) const;  // noise of all groups together
  double scale_of(const Reading& reading) const;
};

// sd of each cell at what a model expects it to read, and not less than what the file says of it
// (the standard error of an average); where the reading is far from that, at the reading. (Always
// at the reading would be worse: readings that chance made small would weigh more than those that
// it made large.)
Eigen::VectorXd deviations(const Dataset& dataset, const Noise& noise,
                           const Eigen::VectorXd& expected_N);

// The same as if none were far from what the model expects.
Eigen::VectorXd deviations_if_near(const Dataset& dataset, const Noise& noise,
                                   const Eigen::VectorXd& expected_N);

// From repeats and smoothing; nothing if there are too few.
std::optional<Noise> noise_without_model(const Dataset& dataset);
// From what a model leaves of the readings.
Noise noise_left_by(const Dataset& dataset, const Model& model);
// The same noise within each mounting, beside what the mounting itself could have changed. Returns
// nothing where that leaves too few readings.
std::optional<Noise> noise_left_within_mountings(const Dataset& dataset, const Model& model,
                                                 const MountingModes& modes);

}  // namespace reeve::diagnosis
