#include "diagnosis/verdict/channel_units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "diagnosis/fit/forecast.hpp"
#include "numerics/robust.hpp"
#include "readings/units.hpp"

namespace reeve::diagnosis {
namespace {

constexpr double near_a_unit = 0.1;  // in logarithms
constexpr std::size_t enough_readings = 8;

struct ChannelLevel {
  double middle = 0;  // median of ln (T / m)
  double spread = 0;  // median of the distances from it
};

std::vector<double> distances_from(std::vector<double> values, double middle) {
  for (double& value : values) value = std::abs(value - middle);
  return values;
}

// NaN of channels with few readings that tell.
std::vector<ChannelLevel> channel_levels(const Dataset& all, const Forecast& at) {
  std::vector<std::vector<double>> logs(all.data->channels.size());
  for (const DatasetRow& row : all.rows) {
    if (!row.has_motor_tension) continue;
    for (std::size_t i = row.first; i < row.last; ++i) {
      const double forecast_N = at.reading_N[static_cast<Eigen::Index>(i)];
      const double measured_N = all.cells[i].measured_N;
      if (!(forecast_N > 0) || !(measured_N > 0)) continue;
      logs[all.cells[i].channel].push_back(std::log(measured_N / forecast_N));
    }
  }
  std::vector<ChannelLevel> levels;
  for (std::vector<double>& of_channel : logs) {
    if (of_channel.size() < enough_readings) {
      levels.push_back({std::nan(""), std::nan("")});
      continue;
    }
    const double middle = median(of_channel);
    levels.push_back({middle, median(distances_from(std::move(of_channel), middle))});
  }
  return levels;
}

// The name of the unit in which a reading is so many times less than in newton.
std::optional<std::string> unit_of(double middle) {
  for (const char* name : {"kgf", "lbf", "daN", "kN"}) {
    const double factor = find_unit(name, Dimension::force)->factor;
    if (std::abs(middle + std::log(factor)) < near_a_unit) return name;
  }
  return std::nullopt;
}

bool others_are_near(const std::vector<ChannelLevel>& levels, std::size_t channel) {
  const double half = std::abs(levels[channel].middle) / 2;
  std::size_t others = 0;
  for (std::size_t c = 0; c < levels.size(); ++c) {
    if (c == channel || std::isnan(levels[c].middle)) continue;
    ++others;
    if (std::abs(levels[c].middle) > half) return false;
  }
  return others >= 2;
}

}  // namespace

std::vector<DataNote> notes_on_channel_units(const Dataset& all, const Model& nominal) {
  const std::optional<Forecast> at = try_forecast(all, nominal);
  if (!at) return {};
  const std::vector<ChannelLevel> levels = channel_levels(all, *at);
  std::vector<DataNote> notes;
  for (std::size_t c = 0; c < levels.size(); ++c) {
    const ChannelLevel& level = levels[c];
    if (std::isnan(level.middle) || level.spread > near_a_unit || !others_are_near(levels, c)) {
      continue;
    }
    const std::string name = all.data->channels[c].name + "_N";
    const double factor = std::exp(level.middle);
    if (const auto unit = unit_of(level.middle)) {
      notes.push_back(
          {NoteKind::units,
           fmt::format("{} reads {:.3g} times what the model says, and no other channel "
                       "is off like that: is it in {}?",
                       name, factor, *unit),
           {}});
    } else if (const auto taken_for = unit_of(-level.middle)) {
      notes.push_back(
          {NoteKind::units,
           fmt::format("{} reads {:.3g} times what the model says, and no other channel "
                       "is off like that: is it in newton, and taken for {}?",
                       name, factor, *taken_for),
           {}});
    }
  }
  return notes;
}

}  // namespace reeve::diagnosis
