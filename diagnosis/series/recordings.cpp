#include "diagnosis/series/recordings.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "numerics/robust.hpp"

namespace reeve::diagnosis {
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

}  // namespace

Recordings recordings(const LoggedSeries& series) {
  Recordings result;
  for (std::size_t i = 0; i < series.size(); ++i) {
    const bool back = i > 0 && series.time_s[i] < series.time_s[i - 1];
    if (back) result.clock_set_back.push_back(series.lines[i]);
    if (i == 0 || back || series.label[i] != series.label[i - 1]) {
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
  return steps.empty() ? 0 : middle_of(std::move(steps));
}

}  // namespace reeve::diagnosis
