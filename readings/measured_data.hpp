// Measured tensions, as they stand in a CSV file: one row for each steady reading. docs/data.md
// describes the format for people, data_columns.hpp its columns.
//
// What cannot be read is an InputError that names every line and column. What is taken otherwise
// than it stands in the file (units, zeros), what is left out, and what looks wrong but can be read
// is a note.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/grasp.hpp"
#include "core/network.hpp"
#include "core/routing.hpp"
#include "readings/note.hpp"
#include "readings/reading_options.hpp"

namespace reeve::readings {

// A column of tensions.
struct Channel {
  std::string name;  // name of the segment: T1, a, h1
  Segment segment;
};

struct MeasuredRouting {
  std::string word;
  Routing routing;
  Network network;
  // Parallel to the channels: index of its segment in the network, if it has it.
  std::vector<std::optional<std::size_t>> segments;
};

struct Reading {
  std::size_t line = 0;
  std::size_t taken = 0;             // place in the order in which readings were taken
  std::size_t run = 0;               // index into MeasuredData::runs
  std::size_t routing = 0;           // index into MeasuredData::routings
  std::optional<std::size_t> group;  // index into MeasuredData::groups
  Grasp grasp;
  Direction direction = Direction::pull;
  bool direction_assumed = false;  // the file does not say it
  bool grasp_assumed = false;      // neither does it say which fingers are held
  std::optional<double> motor_tension_N;
  std::optional<double> speed_mm_s;
  std::optional<double> cycle;
  std::optional<double> temperature_C;
  std::optional<double> sheath_angle_rad;
  std::vector<std::optional<double>> tension_N;  // parallel to the channels
  // Parallel to the channels: the standard error of the mean of the samples that the tension is the
  // mean of, sd/√readings.
  std::vector<std::optional<double>> error_N;
  std::optional<double> motor_error_N;
  std::vector<std::optional<double>> covariates;  // parallel to their names
};

struct MeasuredData {
  std::string file;
  bool simulated = false;  // a comment line says so
  std::vector<std::string> runs;
  std::vector<std::string> groups;  // empty if no column was named as one of groups
  std::vector<MeasuredRouting> routings;
  std::vector<Channel> channels;
  std::vector<std::string> covariates;
  std::vector<Reading> readings;
  std::vector<DataNote> notes;
  // Known noise of each channel, parallel to the channels; empty if none is known.
  std::vector<std::optional<KnownNoise>> known_noise;
  std::optional<KnownNoise> known_motor_noise;
};

// Returns the known noise of a channel; nothing if it must be estimated.
std::optional<KnownNoise> known_noise(const MeasuredData& data, std::size_t channel);
// Returns the standard deviation of a reading's motor tension, N; 0 if unknown.
double motor_deviation(const MeasuredData& data, const Reading& reading);

// Parallel to the channels: whether one reads below 0 anywhere, as a load cell that drifts does.
// One that never does may be clipped there.
std::vector<bool> reads_below_zero(const MeasuredData& data);
// Likewise: whether one reads 0 throughout, as a dead one does. It has no noise that would be cut
// off there, and tells of none.
std::vector<bool> reads_zero_alone(const MeasuredData& data);

// Returns the lines of the readings of which that is true.
template <typename Is>
std::vector<std::size_t> lines_where(const MeasuredData& data, Is is) {
  std::vector<std::size_t> lines;
  for (const Reading& reading : data.readings) {
    if (is(reading)) lines.push_back(reading.line);
  }
  return lines;
}

// A routing for the text of a cell: a word, or a name where the caller knows names. Throws
// InputError.
using RoutingResolver = std::function<Routing(const std::string&)>;

MeasuredData read_measured_data(const std::filesystem::path& path, const RoutingResolver& resolve,
                                const ReadingOptions& options = {});
// `name` stands for the file in messages.
MeasuredData parse_measured_data(std::string text, const std::string& name,
                                 const RoutingResolver& resolve,
                                 const ReadingOptions& options = {});

}  // namespace reeve::readings
