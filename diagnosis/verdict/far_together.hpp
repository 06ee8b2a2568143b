// Readings far from the final model that keep together: of one channel, in some runs.
//
// Student's t takes any reading for noise, however far out, and lets it weigh little; so it does
// with a sensor that steps, sticks or fails in some runs, and what is judged by what readings weigh
// (structure.hpp) does not see it. But noise chooses no channel and no run. That k or more of the n
// cells of a channel, or of a channel in a run, are far (far_cells.hpp) has the chance
//
//   P(X ≥ k),  X ~ B(n, q)
//
// times the number of these groups. q: the chance that t gives one, or their share among all other
// cells, if that is more. Mountings whose contacts stick or slide are far in whole runs, too: what
// is rarer than a quarter of alpha is judged again by mountings that are solved
// (mounted_draws.hpp), by the rarest group of each draw.
//
// Held-out runs are looked at, too: nothing is fitted to what is found. Where many of all other
// readings are far, too, they keep to nothing, and none is found.
//
// Where far readings are of some runs, or on one side, or change sides with the load
// (far_sides.hpp), they follow something, and the verdict says so. Otherwise the channel scatters
// more than the others.
#pragma once

#include <functional>
#include <vector>

#include "diagnosis/verdict/far_sides.hpp"
#include "diagnosis/verdict/residual_structure.hpp"

namespace reeve::diagnosis {

struct FarTogether {
  std::vector<std::size_t> channels;  // ascending
  std::vector<std::size_t> runs;      // ascending
  bool everywhere = false;            // all runs in which the channels were read
  std::size_t readings = 0;           // of these channels in these runs
  FarSides sides;                     // of those that are far
  double p_value = 1;                 // of the rarest of its groups, family-wise
  std::vector<std::size_t> far_rows;  // readings of the data, ascending

  std::size_t far() const { return sides.above + sides.below; }
};

struct FarReadings {
  std::vector<FarTogether> together;  // the rarest first
  std::size_t far_elsewhere = 0;
  std::size_t elsewhere = 0;
};

// Of all other readings. Heavy tails put 1 % there; more, and it is the model that is wrong.
inline constexpr double most_far_elsewhere = 0.05;
bool keep_to_something(const FarReadings& found);

struct FarSearch {
  const Problem& training;
  const Problem* held_out = nullptr;
  const Model& model;
  const Noise& noise;
  const MountingScatter& mounting;
  double alpha = 0.02;
  Replicates replicates;
};

// Without meaning once `stop` has said so.
FarReadings far_readings_together(const FarSearch& search, Workers& workers,
                                  const std::function<bool()>& stop);

// Whether they are of some runs, or on sides on which noise would put them in fewer than a quarter
// of alpha of data sets.
bool follow_something(const FarTogether& together, double alpha);

}  // namespace reeve::diagnosis
