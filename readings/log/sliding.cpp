#include "readings/log/sliding.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "numerics/robust.hpp"

namespace reeve::readings {
namespace {

constexpr double even = 0.2;  // share of the mean speed
constexpr double slow = 0.01;
constexpr double fast_share = 0.95;

double speed_between(const SeriesBlock& from, const SeriesBlock& to) {
  return (to.position_mm - from.position_mm) / (to.time_s - from.time_s);
}

class EvenStretches {
 public:
  EvenStretches(const std::vector<SeriesBlock>& blocks, const std::vector<double>& speeds,
                const SpeedScale& scale, double width_s)
      : blocks_(blocks), speeds_(speeds), scale_(scale), width_s_(width_s) {}

  SlidingBlocks find() {
    SlidingBlocks result;
    for (std::size_t i = 0; i < blocks_.size(); ++i) result.uses.push_back(use_of(i));
    for (std::size_t begin = 0, end = 0; begin < blocks_.size(); begin = end) {
      end = begin + 1;
      if (!moves(begin)) continue;
      double sum = speeds_[begin];
      while (end < blocks_.size() && goes_on(begin, end, sum)) sum += speeds_[end++];
      if (end - begin < blocks_per_min_duration) {
        end = begin + 1;  // the start of an even stretch may lie inside
        continue;
      }
      std::fill(result.uses.begin() + static_cast<std::ptrdiff_t>(begin),
                result.uses.begin() + static_cast<std::ptrdiff_t>(end), SampleUse::taken);
      result.stretches.push_back({begin, end, direction(speeds_[begin])});
    }
    return result;
  }

 private:
  // A position without neighbours has no speed.
  SampleUse use_of(std::size_t block) const {
    if (std::isnan(speeds_[block])) {
      return std::isnan(blocks_[block].position_mm) ? SampleUse::incomplete : SampleUse::too_few;
    }
    return moves(block) ? SampleUse::speed_varies : SampleUse::standstill;
  }

  bool moves(std::size_t block) const { return std::abs(speeds_[block]) > scale_.standstill; }

  bool goes_on(std::size_t begin, std::size_t block, double sum) const {
    if (!moves(block) || is_gap(blocks_[block - 1], blocks_[block], width_s_)) return false;
    const double mean = sum / static_cast<double>(block - begin);
    return std::abs(speeds_[block] - mean) <= even * std::abs(mean) + 3 * scale_.noise;
  }

  std::optional<Direction> direction(double speed) const {
    if (!scale_.has_sign) return std::nullopt;
    return speed > 0 ? Direction::pull : Direction::release;
  }

  const std::vector<SeriesBlock>& blocks_;
  const std::vector<double>& speeds_;
  const SpeedScale& scale_;
  double width_s_;
};

}  // namespace

MotionSource motion_source(const LoggedSeries& series) {
  if (series.position_mm.is_logged()) return MotionSource::position;
  if (!series.speed_mm_s.is_logged()) return MotionSource::none;
  double least = std::numeric_limits<double>::infinity();
  double greatest = 0;
  bool forward = false;
  bool backward = false;
  for (const double speed : series.speed_mm_s.values) {
    if (std::isnan(speed)) continue;
    least = std::min(least, std::abs(speed));
    greatest = std::max(greatest, std::abs(speed));
    forward |= speed > 0;
    backward |= speed < 0;
  }
  return least > slow * greatest && !(forward && backward) ? MotionSource::none
                                                           : MotionSource::speed;
}

std::vector<double> block_speeds(const std::vector<SeriesBlock>& blocks, MotionSource source,
                                 double width_s) {
  std::vector<double> speeds;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (source == MotionSource::speed) {
      speeds.push_back(blocks[i].speed_mm_s);
      continue;
    }
    const bool before = i > 0 && !is_gap(blocks[i - 1], blocks[i], width_s);
    const bool after = i + 1 < blocks.size() && !is_gap(blocks[i], blocks[i + 1], width_s);
    speeds.push_back(before || after
                         ? speed_between(blocks[before ? i - 1 : i], blocks[after ? i + 1 : i])
                         : std::numeric_limits<double>::quiet_NaN());
  }
  return speeds;
}

SpeedScale speed_scale(const std::vector<std::vector<double>>& speeds) {
  std::vector<double> sizes;
  for (const std::vector<double>& part : speeds) {
    for (const double speed : part) sizes.push_back(std::abs(speed));
  }
  SpeedScale scale;
  scale.noise = deviation_about_trend(speeds);
  const double fast = quantile_of(std::move(sizes), fast_share);
  scale.standstill = std::max(std::isnan(fast) ? 0 : slow * fast, 4 * scale.noise);
  for (const std::vector<double>& part : speeds) {
    for (const double speed : part) scale.has_sign |= speed < -scale.standstill;
  }
  return scale;
}

SlidingBlocks sliding_blocks(const std::vector<SeriesBlock>& blocks,
                             const std::vector<double>& speeds, const SpeedScale& scale,
                             double width_s) {
  return EvenStretches(blocks, speeds, scale, width_s).find();
}

}  // namespace reeve::readings
