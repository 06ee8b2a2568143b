#include "readings/recognise_series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "numerics/robust.hpp"
#include "readings/column_name.hpp"

namespace reeve::readings {
namespace {

constexpr std::size_t least_rows_by_clock = 200;
constexpr std::size_t least_fast_rows = 100;
constexpr double fast_step_s = 0.05;
constexpr double regular_share = 0.97;
constexpr double regular_within = 0.2;
constexpr std::size_t least_rows_without_clock = 1000;
constexpr double least_autocorrelation = 0.7;
constexpr double least_of_differences = -0.3;
constexpr double most_autocorrelation_of_set = 0.3;

constexpr double no_share = std::numeric_limits<double>::quiet_NaN();

bool follows(const Reading& reading, const Reading& before) {
  return reading.run == before.run && reading.routing == before.routing;
}

std::optional<std::size_t> clock_covariate(const MeasuredData& data) {
  for (std::size_t i = 0; i < data.covariates.size(); ++i) {
    if (clock_unit(data.covariates[i])) return i;
  }
  return std::nullopt;
}

// Forward steps of the clock inside the runs, in seconds.
std::vector<double> clock_steps(const MeasuredData& data, std::size_t clock) {
  const double unit = *clock_unit(data.covariates[clock]);
  std::vector<double> steps;
  for (std::size_t i = 1; i < data.readings.size(); ++i) {
    const Reading& reading = data.readings[i];
    const Reading& before = data.readings[i - 1];
    if (!follows(reading, before)) continue;
    if (!reading.covariates[clock] || !before.covariates[clock]) continue;
    steps.push_back(unit * (*reading.covariates[clock] - *before.covariates[clock]));
  }
  return steps;
}

bool is_regular(const std::vector<double>& steps, double usual) {
  const auto regular = std::count_if(steps.begin(), steps.end(), [&](double step) {
    return std::abs(step - usual) <= regular_within * usual;
  });
  return static_cast<double>(regular) >= regular_share * static_cast<double>(steps.size());
}

// The motor tension, or the sum of the row's tensions.
double load_of(const Reading& reading) {
  double load_N = reading.motor_tension_N.value_or(0);
  if (!reading.motor_tension_N) {
    for (const std::optional<double>& tension : reading.tension_N) load_N += tension.value_or(0);
  }
  return load_N;
}

// Returns the values of the rows one after the other, cut between runs and routings.
template <typename Value>
std::vector<double> in_a_row(const MeasuredData& data, Value value) {
  std::vector<double> values;
  for (std::size_t i = 0; i < data.readings.size(); ++i) {
    if (i > 0 && !follows(data.readings[i], data.readings[i - 1])) values.push_back(no_share);
    values.push_back(value(data.readings[i]));
  }
  return values;
}

double share_of_load(const Reading& reading, std::size_t channel) {
  const double load_N = load_of(reading);
  if (!reading.tension_N[channel] || load_N <= 0) return no_share;
  return *reading.tension_N[channel] / load_N;
}

// Lag 1; NaN marks where the series is cut.
double lag_one(const std::vector<double>& values) {
  double mean = 0;
  std::size_t count = 0;
  for (const double value : values) {
    if (std::isnan(value)) continue;
    mean += value;
    ++count;
  }
  mean /= static_cast<double>(count);
  double together = 0;
  double alone = 0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (std::isnan(values[i]) || std::isnan(values[i - 1])) continue;
    together += (values[i] - mean) * (values[i - 1] - mean);
    alone += (values[i - 1] - mean) * (values[i - 1] - mean);
  }
  return alone > 0 ? together / alone : no_share;
}

// The load of a row says nothing of that of the next one: each was set by itself.
bool is_set_anew(const MeasuredData& data) {
  return lag_one(in_a_row(data, load_of)) < most_autocorrelation_of_set;
}

std::optional<DataNote> by_clock(const MeasuredData& data, std::size_t clock) {
  const std::vector<double> steps = clock_steps(data, clock);
  if (steps.size() + 1 < least_fast_rows) return std::nullopt;
  const double usual = median(steps);
  if (!(usual > 0)) return std::nullopt;
  const bool regular =
      steps.size() + 1 >= least_rows_by_clock && is_regular(steps, usual) && !is_set_anew(data);
  if (!regular && usual > fast_step_s) return std::nullopt;
  return DataNote{
      NoteKind::time_series,
      fmt::format("{} rows with a clock (column '{}', every {:.3g} s) are a logger's time series, "
                  "whose neighbouring rows are no readings of their own: make readings of it "
                  "(reeve import)",
                  data.readings.size(), data.covariates[clock], usual)};
}

bool goes_on_from_row_to_row(const MeasuredData& data, std::size_t channel) {
  const std::vector<double> shares =
      in_a_row(data, [&](const Reading& reading) { return share_of_load(reading, channel); });
  std::vector<double> differences(shares.size(), no_share);
  std::transform(shares.begin() + 1, shares.end(), shares.begin(), differences.begin() + 1,
                 std::minus{});
  return lag_one(shares) > least_autocorrelation && lag_one(differences) > least_of_differences;
}

std::optional<DataNote> by_noise(const MeasuredData& data) {
  if (data.readings.size() < least_rows_without_clock) return std::nullopt;
  std::size_t series = 0;
  for (std::size_t i = 0; i < data.channels.size(); ++i) {
    series += goes_on_from_row_to_row(data, i) ? 1 : 0;
  }
  if (2 * series < data.channels.size()) return std::nullopt;
  return DataNote{NoteKind::time_series,
                  fmt::format("{} rows whose tensions go on from row to row are a logger's time "
                              "series, no readings: add its clock, and make readings of it (reeve "
                              "import)",
                              data.readings.size())};
}

}  // namespace

std::optional<DataNote> recognise_series(const MeasuredData& data) {
  if (const auto clock = clock_covariate(data)) return by_clock(data, *clock);
  return by_noise(data);
}

}  // namespace reeve::readings
