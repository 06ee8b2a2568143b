#include "readings/log/settling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "numerics/robust.hpp"

namespace reeve::readings {
namespace {

constexpr std::size_t most_blocks = 50;
constexpr double walk_deviations = 4;
constexpr double sticking = 0.5;  // share of the change of the load; 1 is a contact that sticks
constexpr double nearly_slack = 0.05;  // share of the greatest ratio

// NaN where there is none.
double ratio(const SeriesBlock& block, std::size_t tension) {
  return block.load_N > 0 ? block.tensions_N[tension] / block.load_N
                          : std::numeric_limits<double>::quiet_NaN();
}

struct BlockLine {
  double time_s = 0;
  double level = 0;
  double slope = 0;

  double at(double time) const { return level + slope * (time - time_s); }
};

// Through the ratios of the blocks of a least time from `begin` on.
BlockLine line_from(const std::vector<SeriesBlock>& blocks, std::size_t begin,
                    std::size_t tension) {
  constexpr auto count = static_cast<double>(blocks_per_min_duration);
  BlockLine line;
  const std::size_t end = begin + blocks_per_min_duration;
  for (std::size_t i = begin; i < end; ++i) {
    line.time_s += blocks[i].time_s / count;
    line.level += ratio(blocks[i], tension) / count;
  }
  double covariance = 0;
  double variance = 0;
  for (std::size_t i = begin; i < end; ++i) {
    const double time = blocks[i].time_s - line.time_s;
    covariance += time * ratio(blocks[i], tension);
    variance += time * time;
  }
  line.slope = covariance / variance;
  return line;
}

bool is_logged(const std::vector<SeriesBlock>& blocks, std::size_t tension) {
  return std::any_of(blocks.begin(), blocks.end(), [&](const SeriesBlock& block) {
    return !std::isnan(block.tensions_N[tension]);
  });
}

struct WatchedRatio {
  std::size_t tension = 0;
  double level = 0;      // level while sliding
  double tolerance = 0;  // allowed deviation from the level
  double tension_N = 0;  // usual tension
  double noise_N = 0;    // its deviation by noise, in the next block
};

// Returns levels from the later half of the stretch, with tolerances still 0. Tensions that it does
// not have say nothing; small changes of a nearly slack one count little.
std::vector<WatchedRatio> ratio_levels(const std::vector<SeriesBlock>& blocks) {
  std::vector<WatchedRatio> result;
  double greatest = 0;
  std::vector<double> loads;
  for (const SeriesBlock& block : blocks) loads.push_back(block.load_N);
  const double load_N = std::abs(median(std::move(loads)));
  for (std::size_t k = 0; k < blocks.front().tensions_N.size(); ++k) {
    if (!is_logged(blocks, k)) continue;
    std::vector<double> later;
    for (std::size_t i = blocks.size() / 2; i < blocks.size(); ++i) {
      later.push_back(ratio(blocks[i], k));
    }
    result.push_back({k, std::abs(median(std::move(later))), 0, 0, 0});
    greatest = std::max(greatest, result.back().level);
  }
  for (WatchedRatio& ratio : result) {
    ratio.tension_N = ratio.level * load_N;
    ratio.level = std::max(ratio.level, nearly_slack * greatest);
  }
  return result;
}

struct ThirdMeans {
  double first = 0;
  double last = 0;
};

template <typename Value>
ThirdMeans third_means(const std::vector<SeriesBlock>& blocks, std::size_t from, Value value) {
  const std::size_t third = std::max<std::size_t>(1, (blocks.size() - from) / 3);
  ThirdMeans means;
  for (std::size_t i = 0; i < third; ++i) {
    means.first += value(blocks[from + i]) / static_cast<double>(third);
    means.last += value(blocks[blocks.size() - 1 - i]) / static_cast<double>(third);
  }
  return means;
}

struct LoadFollowing {
  bool by_all = true;
  std::vector<std::size_t> staying;  // tensions, where the load changes
};

LoadFollowing following(const std::vector<SeriesBlock>& blocks, std::size_t from,
                        const std::vector<WatchedRatio>& ratios) {
  LoadFollowing result;
  const ThirdMeans load = third_means(blocks, from, [](const SeriesBlock& b) { return b.load_N; });
  const double growth = std::log(load.last / load.first);
  for (const WatchedRatio& watched : ratios) {
    const ThirdMeans means =
        third_means(blocks, from, [&](const SeriesBlock& b) { return ratio(b, watched.tension); });
    const double change = means.last - means.first;
    const double chance = watched.tolerance + watched.noise_N / std::min(load.first, load.last);
    const double sticks = sticking * std::abs(growth) * watched.level;
    if (std::abs(change) <= chance + sticks) continue;
    result.by_all = false;
    if (sticks > chance && change * growth < 0) result.staying.push_back(watched.tension);
  }
  return result;
}

// Blocks before the one that the walk has come to; the first is 1.
struct BlocksAhead {
  std::size_t first = 1;
  std::size_t last = 1;

  double count() const { return static_cast<double>(last - first + 1); }
  double middle() const { return static_cast<double>(first + last) / 2; }
};

// Returns the noise of the forecast of these blocks' mean over that of the next block.
double reach_of_noise(BlocksAhead ahead) {
  constexpr auto count = static_cast<double>(blocks_per_min_duration);
  const auto variance = [&](const BlocksAhead& of) {
    const double away = of.middle() + (count - 1) / 2;
    return 1 / of.count() + 1 / count + away * away * 12 / (count * (count * count - 1));
  };
  return std::sqrt(variance(ahead) / variance({1, 1}));
}

// True if the mean of the blocks is off the line, or if a block has no ratio.
bool is_off(const std::vector<SeriesBlock>& blocks, std::size_t from, BlocksAhead ahead,
            const std::vector<WatchedRatio>& ratios) {
  return std::any_of(ratios.begin(), ratios.end(), [&](const WatchedRatio& watched) {
    const BlockLine line = line_from(blocks, from, watched.tension);
    double off = 0;
    double load_N = 0;
    for (std::size_t before = ahead.first; before <= ahead.last; ++before) {
      const SeriesBlock& block = blocks[from - before];
      off += (ratio(block, watched.tension) - line.at(block.time_s)) / ahead.count();
      load_N += block.load_N / ahead.count();
    }
    return !(std::abs(off) <= watched.tolerance + reach_of_noise(ahead) * watched.noise_N / load_N);
  });
}

// A sharp bend shows in the next two blocks, a blunt one in the third to the fifth.
bool bends(const std::vector<SeriesBlock>& blocks, std::size_t from,
           const std::vector<WatchedRatio>& ratios) {
  if (is_off(blocks, from, {1, 1}, ratios) && (from < 2 || is_off(blocks, from, {2, 2}, ratios))) {
    return true;
  }
  return from >= 5 && is_off(blocks, from, {3, 5}, ratios);
}

// A long stretch in blocks so coarse that a slow bend shows in some of them.
struct CoarseStretch {
  std::size_t each = 1;  // blocks in one of these
  std::vector<SeriesBlock> blocks;
};

SeriesBlock merged(const std::vector<SeriesBlock>& blocks, std::size_t begin, std::size_t end) {
  SeriesBlock all;
  const auto count = static_cast<double>(end - begin);
  all.tensions_N.assign(blocks[begin].tensions_N.size(), 0);
  for (std::size_t i = begin; i < end; ++i) {
    all.time_s += blocks[i].time_s / count;
    all.load_N += blocks[i].load_N / count;
    for (std::size_t k = 0; k < all.tensions_N.size(); ++k) {
      all.tensions_N[k] += blocks[i].tensions_N[k] / count;
    }
  }
  return all;
}

// Merges blocks from the stretch's end; the rest at its begin is left out.
CoarseStretch coarse(const std::vector<SeriesBlock>& blocks, const BlockStretch& stretch) {
  CoarseStretch result;
  const std::size_t length = stretch.end - stretch.begin;
  result.each = (length + most_blocks - 1) / most_blocks;
  for (std::size_t end = stretch.end; end >= stretch.begin + result.each; end -= result.each) {
    result.blocks.push_back(merged(blocks, end - result.each, end));
  }
  std::reverse(result.blocks.begin(), result.blocks.end());
  return result;
}

constexpr double hardly_apart = 1.5;

struct NoiseLevel {
  double tension_N = 0;
  double deviation_N = 0;
};

NoiseLevel level_of(const std::vector<ForecastError>& errors, std::size_t begin, std::size_t end) {
  std::vector<double> tensions;
  std::vector<double> sizes;
  for (std::size_t i = begin; i < end; ++i) {
    tensions.push_back(errors[i].tension_N);
    sizes.push_back(errors[i].error_N);
  }
  return {median(std::move(tensions)), mad_about_zero(std::move(sizes))};
}

double squared(double value) { return value * value; }

}  // namespace

double RatioNoise::at(double tension_N) const {
  return std::hypot(absolute_N, relative * std::max(tension_N, least_tension_N));
}

RatioNoise ratio_noise(std::vector<ForecastError> errors) {
  std::erase_if(errors, [](const ForecastError& error) { return std::isnan(error.error_N); });
  if (errors.empty()) return {};
  std::sort(errors.begin(), errors.end(), [](const ForecastError& a, const ForecastError& b) {
    return a.tension_N < b.tension_N;
  });
  const std::size_t count = errors.size();
  const std::size_t third = std::max<std::size_t>(1, count / 3);
  const NoiseLevel low = level_of(errors, 0, third);
  const NoiseLevel high = level_of(errors, count - third, count);
  if (!(high.tension_N > hardly_apart * low.tension_N) || high.deviation_N <= low.deviation_N) {
    return {0, level_of(errors, 0, count).deviation_N, 0};
  }
  const double slope = (squared(high.deviation_N) - squared(low.deviation_N)) /
                       (squared(high.tension_N) - squared(low.tension_N));
  const double relative = std::min(std::sqrt(slope), high.deviation_N / high.tension_N);
  const double left = squared(low.deviation_N) - squared(relative * low.tension_N);
  return {low.tension_N, std::sqrt(std::max(0.0, left)), relative};
}

std::vector<RatioNoise> forecast_noise(const std::vector<std::vector<SeriesBlock>>& recordings,
                                       const std::vector<std::vector<BlockStretch>>& stretches) {
  const std::size_t tensions =
      recordings.empty() || recordings[0].empty() ? 0 : recordings[0][0].tensions_N.size();
  std::vector<std::vector<ForecastError>> errors(tensions);
  for (std::size_t part = 0; part < recordings.size(); ++part) {
    for (const BlockStretch& stretch : stretches[part]) {
      const std::vector<SeriesBlock> blocks = coarse(recordings[part], stretch).blocks;
      for (const WatchedRatio& watched : ratio_levels(blocks)) {
        const std::size_t k = watched.tension;
        for (std::size_t i = 0; i + blocks_per_min_duration < blocks.size(); ++i) {
          const double forecast = line_from(blocks, i + 1, k).at(blocks[i].time_s);
          const double error = (ratio(blocks[i], k) - forecast) * blocks[i].load_N;
          errors[k].push_back({watched.tension_N, error});
        }
      }
    }
  }
  std::vector<RatioNoise> noise;
  for (std::vector<ForecastError>& all : errors) noise.push_back(ratio_noise(std::move(all)));
  return noise;
}

SettledPart settled_part(const std::vector<SeriesBlock>& all, const BlockStretch& stretch,
                         const std::vector<RatioNoise>& noise, double tolerance) {
  const auto [each, blocks] = coarse(all, stretch);
  if (blocks.size() < blocks_per_min_duration) return {stretch.end, {}};
  std::vector<WatchedRatio> ratios = ratio_levels(blocks);
  for (WatchedRatio& watched : ratios) {
    watched.tolerance = tolerance * watched.level;
    watched.noise_N = walk_deviations * noise[watched.tension].at(watched.tension_N);
  }
  std::size_t from = blocks.size() - blocks_per_min_duration;
  while (from > 0 && !bends(blocks, from, ratios)) --from;
  LoadFollowing found = following(blocks, from, ratios);
  if (!found.by_all) return {stretch.end, std::move(found.staying)};
  return {stretch.end - (blocks.size() - from - 1) * each, {}};
}

}  // namespace reeve::readings
