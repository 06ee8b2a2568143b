// Readings far from the final model that keep together: of one channel, in some runs.
//
// Evidence lets a reading far out weigh little (fit/evidence.hpp), also those of a sensor that
// steps, sticks or fails in some runs; what is judged by what readings weigh (structure.hpp) does
// not see it. But noise chooses no channel and no run. That k or more of the n cells of a channel,
// or of a channel in a run, are far (JudgedCell) has the chance
//
//   P(X ≥ k),  X ~ B(n, q)
//
// times the number of these groups. q: the chance that Student's t of few degrees of freedom gives
// one, or their share among all other cells, if that is more. Mountings whose contacts stick or
// slide are far in whole runs, too: what is rarer than a quarter of alpha is judged again by
// mountings that are solved (mounted_draws.hpp), by the rarest group of each draw.
//
// Held-out runs are looked at, too: nothing is fitted to what is found. Where many of all other
// readings are far, too, they keep to nothing, and none is found.
//
// Where far readings are of some runs, or on one side, or change sides with the load
// (OutlierSides), they follow something, and the verdict says so. Otherwise the channel
// scatters more than the others.
#pragma once

#include <cstddef>
#include <vector>

#include "diagnosis/fit/noise.hpp"
#include "diagnosis/fit/problem.hpp"
#include "diagnosis/verdict/structure.hpp"

namespace reeve::diagnosis {

// How far each reading is from a model, in standard deviations of what is not far out.
//
//   z = (T − m) / √(sd² + s²)
//
// sd: of the noise, not less for a reading that is far out;
// s: of what the reading shares with its mounting, all of whose contacts may be off to the same
// side: Σ |s_k| over what a mounting changes, not the root of the sum of squares that independent
// ones have.
struct JudgedCell {
  std::size_t reading = 0;
  std::size_t run = 0;
  std::size_t channel = 0;
  double expected_N = 0;
  double z = 0;
};

// Cells beyond this are far. Of noise with three degrees of freedom, 1 % is.
inline constexpr double outlier_deviations = 6;

// On which side of the model readings are that are far from it.
//
// Noise chooses none, whatever the load. So of rows with such readings, of which each counts once,
// half are on either side (the sign test), and those of greater loads are on no other side than
// those of lesser ones (the rank sum of H. B. Mann and D. R. Whitney, Ann. Math. Stat. 18, 1947,
// as normal as it is for many). A zero that has moved reads more throughout; a sensor that sticks,
// more of small loads and less of great ones.
struct OutlierSides {
  std::size_t above = 0;  // cells
  std::size_t below = 0;
  double p_value = 1;  // p-value of the rarer of the two tests, corrected for both
};

// All of them far, in the order of their readings.
OutlierSides outlier_sides(const std::vector<JudgedCell>& far);

struct OutlierGroups {
  std::vector<std::size_t> channels;      // ascending
  std::vector<std::size_t> runs;          // ascending
  bool everywhere = false;                // all runs in which the channels were read
  bool exchanged = false;                 // two channels, each as the other should read
  std::size_t readings = 0;               // number of readings of these channels in these runs
  OutlierSides sides;                     // sides of the far readings
  double p_value = 1;                     // p-value of the rarest of its groups, family-wise
  std::vector<std::size_t> outlier_rows;  // readings of the data, ascending

  std::size_t far() const { return sides.above + sides.below; }
};

struct OutlierReadings {
  std::vector<OutlierGroups> together;  // the rarest first
  std::size_t far_elsewhere = 0;
  std::size_t elsewhere = 0;
};

// Greatest share of all other readings. Heavy tails put 1 % there; with more, the model is wrong.
inline constexpr double most_far_elsewhere = 0.05;
bool keep_to_something(const OutlierReadings& found);

struct OutlierSearch {
  const Problem& training;
  const Problem* held_out = nullptr;
  const Model& model;
  const Noise& noise;
  const MountingScatter& mounting;
  double alpha = 0.02;
  Replicates replicates;
};

OutlierReadings outlier_readings_together(const OutlierSearch& search, Workers& workers);

// True if they belong to some runs, or lie on sides on which noise would put them in fewer than a
// quarter of alpha of data sets.
bool follow_something(const OutlierGroups& together, double alpha);

}  // namespace reeve::diagnosis
