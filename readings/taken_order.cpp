#include "readings/taken_order.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <tuple>
#include <vector>

#include "readings/log/log_columns.hpp"

namespace reeve::readings {
namespace {

std::vector<std::size_t> as_they_stand(std::size_t count) {
  std::vector<std::size_t> places(count);
  std::iota(places.begin(), places.end(), std::size_t{0});
  return places;
}

struct TimeSpan {
  double first = std::numeric_limits<double>::infinity();
  double last = -std::numeric_limits<double>::infinity();
};

// Of each run among the runs.
std::vector<std::size_t> places_of_runs(const MeasuredData& data, std::size_t clock) {
  std::vector<TimeSpan> spans(data.runs.size());
  for (const Reading& reading : data.readings) {
    TimeSpan& span = spans[reading.run];
    span.first = std::min(span.first, *reading.covariates[clock]);
    span.last = std::max(span.last, *reading.covariates[clock]);
  }
  std::vector<std::size_t> order = as_they_stand(spans.size());
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return spans[a].first < spans[b].first; });
  const auto begun_again = std::adjacent_find(
      order.begin(), order.end(),
      [&](std::size_t a, std::size_t b) { return spans[b].first < spans[a].last; });
  if (begun_again != order.end()) return as_they_stand(spans.size());
  std::vector<std::size_t> places(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) places[order[i]] = i;
  return places;
}

}  // namespace

std::optional<std::size_t> clock_of(const MeasuredData& data) {
  for (std::size_t c = 0; c < data.covariates.size(); ++c) {
    const bool everywhere =
        std::all_of(data.readings.begin(), data.readings.end(),
                    [&](const Reading& reading) { return reading.covariates[c].has_value(); });
    if (everywhere && clock_unit(data.covariates[c])) return c;
  }
  return std::nullopt;
}

void set_taken(MeasuredData& data) {
  std::vector<std::size_t> order = as_they_stand(data.readings.size());
  if (const std::optional<std::size_t> clock = clock_of(data)) {
    const std::vector<std::size_t> runs = places_of_runs(data, *clock);
    const auto key = [&](std::size_t i) {
      const Reading& reading = data.readings[i];
      return std::tuple(runs[reading.run], *reading.covariates[*clock]);
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  }
  for (std::size_t i = 0; i < order.size(); ++i) data.readings[order[i]].taken = i;
}

}  // namespace reeve::readings
