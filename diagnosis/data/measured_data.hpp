// Measured tensions, as they stand in a CSV file: one row for each steady reading. docs/data.md
// describes the format for people, data_columns.hpp its columns.
//
// Nothing is corrected and nothing is dropped: what cannot be read is an InputError that names line
// and column, what looks wrong but can be read is a note (data_notes.hpp).
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
#include "diagnosis/data/note.hpp"

namespace reeve::diagnosis {

// A column of tensions.
struct Channel {
  std::string name;  // of the segment: T1, a, h1
  Segment segment;
};

struct MeasuredRouting {
  std::string word;
  Routing routing;
  Network network;
  // Parallel to the channels: which of the network's segments each is, if it has it.
  std::vector<std::optional<std::size_t>> segments;
};

struct Reading {
  std::size_t line = 0;
  std::size_t run = 0;      // in MeasuredData::runs
  std::size_t routing = 0;  // in MeasuredData::routings
  Grasp grasp;
  Direction direction = Direction::pull;
  std::optional<double> motor_tension_N;
  std::optional<double> speed_mm_s;
  std::optional<double> cycle;
  std::optional<double> temperature_C;
  std::optional<double> sheath_angle_rad;
  std::vector<std::optional<double>> tension_N;   // parallel to the channels
  std::vector<std::optional<double>> covariates;  // parallel to their names
};

struct MeasuredData {
  std::string file;
  bool simulated = false;  // a comment line says so
  std::vector<std::string> runs;
  std::vector<MeasuredRouting> routings;
  std::vector<Channel> channels;
  std::vector<std::string> covariates;
  std::vector<Reading> readings;
  std::vector<DataNote> notes;
};

// Parallel to the channels: whether one reads below 0 anywhere, as a load cell that drifts does.
// One that never does may be clipped there.
std::vector<bool> reads_below_zero(const MeasuredData& data);

// A routing for the text of a cell: a word, or a name where the caller knows names. Throws
// InputError.
using RoutingResolver = std::function<Routing(const std::string&)>;

MeasuredData read_measured_data(const std::filesystem::path& path, const RoutingResolver& resolve);
// `name` stands for the file in messages.
MeasuredData parse_measured_data(std::string text, const std::string& name,
                                 const RoutingResolver& resolve);

}  // namespace reeve::diagnosis
