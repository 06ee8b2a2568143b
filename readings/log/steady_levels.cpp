#include "readings/log/steady_levels.hpp"

#include <algorithm>
#include <cmath>

#include "numerics/robust.hpp"

namespace reeve::readings {

namespace {

constexpr double level_deviations = 4;

// The tensions, and then the load.
double level_signal(const SeriesBlock& block, std::size_t signal) {
  return signal < block.tensions_N.size() ? block.tensions_N[signal] : block.load_N;
}

class LevelSearch {
 public:
  LevelSearch(const std::vector<SeriesBlock>& blocks, const std::vector<double>& noise_N,
              double tolerance, double width_s)
      : blocks_(blocks), noise_N_(noise_N), tolerance_(tolerance), width_s_(width_s) {}

  std::vector<BlockStretch> find() {
    std::vector<BlockStretch> levels;
    for (std::size_t begin = 0, end = 0; begin < blocks_.size(); begin = end) {
      sums_.assign(noise_N_.size(), 0);
      end = begin;
      do add(blocks_[end++]);
      while (end < blocks_.size() && goes_on(begin, end));
      if (end - begin < blocks_per_min_duration + 2 || drifts(begin, end)) {
        end = begin + std::max<std::size_t>(1, (end - begin) / blocks_per_min_duration);
        continue;
      }
      levels.push_back({begin + 1, end - 1, std::nullopt});
    }
    set_directions(levels);
    return levels;
  }

 private:
  void add(const SeriesBlock& block) {
    for (std::size_t k = 0; k < sums_.size(); ++k) sums_[k] += level_signal(block, k);
  }

  double allowed(std::size_t tension, double load_N) const {
    return tolerance_ * std::abs(load_N) + level_deviations * noise_N_[tension];
  }

  // A tension that is missing throughout says nothing.
  bool goes_on(std::size_t begin, std::size_t block) const {
    if (is_gap(blocks_[block - 1], blocks_[block], width_s_)) return false;
    for (std::size_t k = 0; k < sums_.size(); ++k) {
      const double mean = sums_[k] / static_cast<double>(block - begin);
      const double tension = level_signal(blocks_[block], k);
      if (std::isnan(mean) && std::isnan(tension)) continue;
      if (!(std::abs(tension - mean) <= allowed(k, blocks_[begin].load_N))) return false;
    }
    return true;
  }

  // True if a level changes from the first third to the last.
  bool drifts(std::size_t begin, std::size_t end) const {
    for (std::size_t k = 0; k < sums_.size(); ++k) {
      const EndLevels levels = end_levels(
          begin, end, [&](std::size_t block) { return level_signal(blocks_[block], k); });
      if (std::abs(levels.last - levels.first) > allowed(k, blocks_[begin].load_N)) return true;
    }
    return false;
  }

  double load(std::size_t begin, std::size_t end) const {
    std::vector<double> loads;
    for (std::size_t i = begin; i < end; ++i) loads.push_back(blocks_[i].load_N);
    return median(std::move(loads));
  }

  void set_directions(std::vector<BlockStretch>& levels) const {
    double before_N = blocks_.empty() ? 0 : blocks_.front().load_N;
    std::optional<Direction> last;
    for (BlockStretch& level : levels) {
      const double load_N = load(level.begin, level.end);
      const double noise_N = *std::max_element(noise_N_.begin(), noise_N_.end());
      const double least = tolerance_ * std::abs(load_N) + level_deviations * noise_N;
      if (load_N > before_N + least) last = Direction::pull;
      if (load_N < before_N - least) last = Direction::release;
      level.direction = last;
      before_N = load_N;
    }
  }

  const std::vector<SeriesBlock>& blocks_;
  const std::vector<double>& noise_N_;
  double tolerance_;
  double width_s_;
  std::vector<double> sums_;
};

}  // namespace

std::vector<double> block_noise(const std::vector<std::vector<SeriesBlock>>& recordings) {
  std::vector<double> noise;
  const std::size_t tensions =
      recordings.empty() || recordings[0].empty() ? 0 : recordings[0][0].tensions_N.size();
  for (std::size_t k = 0; k <= tensions; ++k) {
    std::vector<std::vector<double>> signals(recordings.size());
    for (std::size_t part = 0; part < recordings.size(); ++part) {
      for (const SeriesBlock& block : recordings[part]) {
        signals[part].push_back(level_signal(block, k));
      }
    }
    noise.push_back(deviation_about_trend(signals));
  }
  return noise;
}

std::vector<BlockStretch> steady_levels(const std::vector<SeriesBlock>& blocks,
                                        const std::vector<double>& noise_N, double tolerance,
                                        double width_s) {
  return LevelSearch(blocks, noise_N, tolerance, width_s).find();
}

}  // namespace reeve::readings
