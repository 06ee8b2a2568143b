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

struct ChannelGroup {
  std::vector<std::string> off;  // columns that read exp(middle) times what the model says
  std::size_t others = 0;
  bool others_are_near = true;
};

ChannelGroup group_at(double middle, const std::vector<ChannelLevel>& levels,
                      const std::vector<Channel>& channels) {
  ChannelGroup group;
  for (std::size_t c = 0; c < levels.size(); ++c) {
    if (std::isnan(levels[c].middle)) continue;
    if (std::abs(levels[c].middle - middle) < near_a_unit && levels[c].spread <= near_a_unit) {
      group.off.push_back(channels[c].name + "_N");
      continue;
    }
    ++group.others;
    if (std::abs(levels[c].middle) > std::abs(middle) / 2) group.others_are_near = false;
  }
  return group;
}

std::string who_is_off(const ChannelGroup& group, double factor) {
  const bool are_many = group.off.size() > 1;
  // Two channels of which one is off do not say which.
  const std::size_t least_others = are_many && group.others == 0 ? 0 : 2;
  if (group.off.empty() || !group.others_are_near || group.others < least_others) return "";
  return fmt::format(
      "{} {} about {:.3g} times what the model says{}: {}", fmt::join(group.off, ", "),
      are_many ? "read" : "reads", factor,
      group.others == 0 ? " with the motor's tension" : ", and no other channel is off like that",
      are_many ? "are they in " : "is it in ");
}

}  // namespace

std::vector<DataNote> notes_on_channel_units(const Dataset& all, const Model& nominal) {
  const std::optional<Forecast> at = try_forecast(all, nominal);
  if (!at) return {};
  const std::vector<ChannelLevel> levels = channel_levels(all, *at);
  std::vector<DataNote> notes;
  for (const char* unit : {"kgf", "lbf", "kN"}) {
    const double factor = find_unit(unit, Dimension::force)->factor;
    for (const bool is_taken_for_it : {false, true}) {
      const double reads = is_taken_for_it ? factor : 1 / factor;
      const std::string who =
          who_is_off(group_at(std::log(reads), levels, all.data->channels), reads);
      if (who.empty()) continue;
      notes.push_back({NoteKind::units,
                       is_taken_for_it ? fmt::format("{}newton, and taken for {}?", who, unit)
                                       : fmt::format("{}{}?", who, unit),
                       {}});
    }
  }
  return notes;
}

}  // namespace reeve::diagnosis
