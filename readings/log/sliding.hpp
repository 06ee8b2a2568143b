// Stretches of even carriage motion: blocks of one sign of the speed, each within a fifth of the
// stretch's mean speed.
//
// The speed of a block is the difference quotient of the positions of its neighbours; without a
// position it is the logged speed. The carriage stands where it is slower than 1 % of the log's
// fast blocks (their 95 % quantile), or than four times the noise of the speed.
#pragma once

#include <cstdint>
#include <vector>

#include "readings/log/recordings.hpp"
#include "readings/log/sample_use.hpp"

namespace reeve::readings {

enum class MotionSource : std::uint8_t { position, speed, none };

// A speed that never changes its sign and never comes near 0 is a set point, and says nothing of
// when the carriage moves.
MotionSource motion_source(const LoggedSeries& series);

// One for each block; NaN where a position is missing.
std::vector<double> block_speeds(const std::vector<SeriesBlock>& blocks, MotionSource source,
                                 double width_s);

struct SpeedScale {
  double standstill = 0;  // greatest speed at standstill, mm/s
  double noise = 0;       // standard deviation of a block's speed, mm/s
  bool has_sign = false;  // some blocks move backwards
};

// Takes the speeds of the blocks of all recordings.
SpeedScale speed_scale(const std::vector<std::vector<double>>& speeds);

struct SlidingBlocks {
  std::vector<BlockStretch> stretches;
  std::vector<SampleUse> uses;  // use of each block; taken inside the stretches
};

// Positive speeds pull. Without signs the stretches have no direction.
SlidingBlocks sliding_blocks(const std::vector<SeriesBlock>& blocks,
                             const std::vector<double>& speeds, const SpeedScale& scale,
                             double width_s);

}  // namespace reeve::readings
