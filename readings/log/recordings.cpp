#include "readings/log/recordings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "numerics/robust.hpp"

namespace reeve::readings {
namespace {

constexpr std::size_t samples_per_set_back = 20;

void require_a_clock(const LoggedSeries& series, const std::vector<std::size_t>& set_back) {
  if (set_back.size() * samples_per_set_back <= series.size() || set_back.size() < 2) return;
  throw InputError(
      {.where = fmt::format("{}:{}", series.file, set_back.front()),
       .what = fmt::format("the time is less than in the row before, and so in {} of {} rows",
                           set_back.size(), series.size()),
       .expected = "rows in the order of their time"});
}

double median_within(const LoggedSignal& signal, std::size_t begin, std::size_t end) {
  if (!signal.is_logged()) return std::numeric_limits<double>::quiet_NaN();
  const auto at = signal.values.begin();
  return median({at + static_cast<std::ptrdiff_t>(begin), at + static_cast<std::ptrdiff_t>(end)});
}

SeriesBlock block_of(const LoggedSeries& series, std::size_t begin, std::size_t end) {
  SeriesBlock block;
  block.begin = begin;
  block.end = end;
  for (std::size_t i = begin; i < end; ++i) {
    block.time_s += series.time_s[i] / static_cast<double>(end - begin);
  }
  block.position_mm = median_within(series.position_mm, begin, end);
  block.speed_mm_s = median_within(series.speed_mm_s, begin, end);
  double sum_N = 0;
  for (const LoggedSignal& tension : series.tensions_N) {
    block.tensions_N.push_back(median_within(tension, begin, end));
    if (!std::isnan(block.tensions_N.back())) sum_N += block.tensions_N.back();
  }
  block.load_N = series.motor_tension_N.is_logged()
                     ? median_within(series.motor_tension_N, begin, end)
                     : sum_N;
  return block;
}

}  // namespace

Recordings recordings(const LoggedSeries& series) {
  Recordings result;
  std::size_t zeros = 0;  // passed
  for (std::size_t i = 0; i < series.size(); ++i) {
    const bool back = i > 0 && series.time_s[i] < series.time_s[i - 1];
    if (back) result.clock_set_back.push_back(series.lines[i]);
    const bool zeroed = zeros < series.zeroed_at.size() && series.zeroed_at[zeros] == i;
    zeros += zeroed ? 1 : 0;
    if (i == 0 || back || zeroed || series.label[i] != series.label[i - 1]) {
      result.parts.push_back({i, i, series.label[i]});
    }
    result.parts.back().end = i + 1;
  }
  require_a_clock(series, result.clock_set_back);
  return result;
}

double usual_step(const LoggedSeries& series, const std::vector<Recording>& parts) {
  std::vector<double> steps;
  for (const Recording& part : parts) {
    for (std::size_t i = part.begin + 1; i < part.end; ++i) {
      const double step = series.time_s[i] - series.time_s[i - 1];
      if (step > 0) steps.push_back(step);
    }
  }
  return steps.empty() ? 0 : median(std::move(steps));
}

double block_width(double min_duration_s, double usual_step_s) {
  constexpr double samples = 3;  // so that one of them may be wild
  return std::max(min_duration_s / blocks_per_min_duration, samples * usual_step_s);
}

std::vector<SeriesBlock> series_blocks(const LoggedSeries& series, const Recording& part,
                                       double width_s) {
  std::vector<SeriesBlock> blocks;
  const double start = series.time_s[part.begin];
  const auto number = [&](std::size_t i) {
    return std::floor((series.time_s[i] - start) / width_s);
  };
  for (std::size_t begin = part.begin, end = begin; begin < part.end; begin = end) {
    while (end < part.end && number(end) == number(begin)) ++end;
    blocks.push_back(block_of(series, begin, end));
  }
  return blocks;
}

bool is_gap(const SeriesBlock& block, const SeriesBlock& next, double width_s) {
  constexpr double widths = 3;  // two blocks with one missing between them are 2 apart
  return next.time_s - block.time_s >= widths * width_s;
}

}  // namespace reeve::readings
