#include "diagnosis/series/settling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "diagnosis/series/robust.hpp"

namespace reeve::diagnosis {
namespace {

constexpr double walk_deviations = 4;

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
  constexpr auto count = static_cast<double>(blocks_per_least_time);
  BlockLine line;
  const std::size_t end = begin + blocks_per_least_time;
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

bool is_logged(const std::vector<SeriesBlock>& blocks, const BlockStretch& stretch,
               std::size_t tension) {
  return std::any_of(
      blocks.begin() + static_cast<std::ptrdiff_t>(stretch.begin),
      blocks.begin() + static_cast<std::ptrdiff_t>(stretch.end),
      [&](const SeriesBlock& block) { return !std::isnan(block.tensions_N[tension]); });
}

struct WatchedRatio {
  std::size_t tension = 0;
  double level = 0;
  double allowed = 0;
};

// By the later half of the stretch. Tensions that it does not have say nothing.
std::vector<WatchedRatio> watched(const std::vector<SeriesBlock>& blocks,
                                  const BlockStretch& stretch, const std::vector<double>& noise,
                                  double tolerance) {
  std::vector<WatchedRatio> result;
  for (std::size_t k = 0; k < noise.size(); ++k) {
    if (!is_logged(blocks, stretch, k)) continue;
    std::vector<double> later;
    for (std::size_t i = (stretch.begin + stretch.end) / 2; i < stretch.end; ++i) {
      later.push_back(ratio(blocks[i], k));
    }
    const double level = std::abs(middle_of(std::move(later)));
    result.push_back({k, level, tolerance * level + walk_deviations * noise[k]});
  }
  return result;
}

bool slides_at_the_end(const std::vector<SeriesBlock>& blocks, std::size_t end,
                       const std::vector<WatchedRatio>& ratios) {
  const std::size_t begin = end - blocks_per_least_time;
  const double seconds = blocks[end - 1].time_s - blocks[begin].time_s;
  const double load = std::abs(blocks[end - 1].load_N / blocks[begin].load_N - 1);
  return std::all_of(ratios.begin(), ratios.end(), [&](const WatchedRatio& watched) {
    const double change = std::abs(line_from(blocks, begin, watched.tension).slope) * seconds;
    return change <= watched.allowed + 0.5 * load * watched.level;
  });
}

// Not so of a ratio that there is not.
bool goes_on(const std::vector<SeriesBlock>& blocks, std::size_t block, std::size_t from,
             const std::vector<WatchedRatio>& ratios) {
  return std::all_of(ratios.begin(), ratios.end(), [&](const WatchedRatio& watched) {
    const double forecast = line_from(blocks, from, watched.tension).at(blocks[block].time_s);
    return std::abs(ratio(blocks[block], watched.tension) - forecast) <= watched.allowed;
  });
}

}  // namespace

std::vector<double> ratio_noise(const std::vector<std::vector<SeriesBlock>>& recordings,
                                const std::vector<std::vector<BlockStretch>>& stretches) {
  std::vector<double> noise;
  const std::size_t tensions =
      recordings.empty() || recordings[0].empty() ? 0 : recordings[0][0].tensions_N.size();
  for (std::size_t k = 0; k < tensions; ++k) {
    std::vector<double> errors;
    for (std::size_t part = 0; part < recordings.size(); ++part) {
      const std::vector<SeriesBlock>& blocks = recordings[part];
      for (const BlockStretch& stretch : stretches[part]) {
        for (std::size_t i = stretch.begin; i + blocks_per_least_time < stretch.end; ++i) {
          errors.push_back(ratio(blocks[i], k) - line_from(blocks, i + 1, k).at(blocks[i].time_s));
        }
      }
    }
    noise.push_back(deviation_about_zero(std::move(errors)));
  }
  return noise;
}

std::size_t settled_from(const std::vector<SeriesBlock>& blocks, const BlockStretch& stretch,
                         const std::vector<double>& noise, double tolerance) {
  if (stretch.end - stretch.begin < blocks_per_least_time) return stretch.end;
  const std::vector<WatchedRatio> ratios = watched(blocks, stretch, noise, tolerance);
  if (!slides_at_the_end(blocks, stretch.end, ratios)) return stretch.end;
  std::size_t from = stretch.end - blocks_per_least_time;
  while (from > stretch.begin) {
    const bool next = goes_on(blocks, from - 1, from, ratios);
    const bool but_one = from >= stretch.begin + 2 && goes_on(blocks, from - 2, from, ratios);
    if (!next && !but_one) break;
    --from;
  }
  return from + 1;
}

}  // namespace reeve::diagnosis
