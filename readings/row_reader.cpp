#include "readings/row_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "core/graph.hpp"
#include "core/motor_sides.hpp"
#include "core/notation.hpp"
#include "core/text.hpp"
#include "readings/column_name.hpp"
#include "readings/csv.hpp"
#include "readings/rows.hpp"

namespace reeve::readings {

ChannelTable::ChannelTable(const std::vector<DataColumn>& columns) {
  for (const DataColumn& column : columns) {
    places_.push_back(column.place);
    measured_.push_back(column.role == DataRole::tension || column.role == DataRole::deviation);
    if (column.role == DataRole::tension && !column.place.beside) channel_of(column.place.segment);
  }
}

void ChannelTable::add_routing(const Network& network) {
  std::vector<std::optional<std::size_t>> channels(places_.size());
  for (std::size_t column = 0; column < places_.size(); ++column) {
    if (!measured_[column]) continue;
    const MeasuredPlace& place = places_[column];
    const auto segment = place.beside ? motor_side_at(network, place.segment) : place.segment;
    if (segment && find_segment(network, *segment)) channels[column] = channel_of(*segment);
  }
  of_routing_.push_back(std::move(channels));
}

std::size_t ChannelTable::channel_of(const Segment& segment) {
  const auto found = std::find_if(channels_.begin(), channels_.end(), [&](const Channel& channel) {
    return channel.segment == segment;
  });
  if (found != channels_.end()) return static_cast<std::size_t>(found - channels_.begin());
  channels_.push_back({segment_name(segment), segment});
  return channels_.size() - 1;
}

std::size_t RoutingTable::index(std::string_view text) {
  const auto found = by_text_.find(text);
  if (found != by_text_.end()) return found->second;
  if (text.empty()) throw InputError({.expected = "a routing such as M-1-T-2-F"});
  const std::size_t index = add(resolve_(std::string(text)));
  by_text_.emplace(text, index);
  return index;
}

// A name and its word are one routing.
std::size_t RoutingTable::add(const Routing& routing) {
  for (std::size_t i = 0; i < routings_.size(); ++i) {
    if (routings_[i].routing == routing) return i;
  }
  MeasuredRouting measured{to_word(routing), routing, expand(routing), {}};
  require_actuated(graph(measured.network), measured.word);
  channels_.add_routing(measured.network);
  routings_.push_back(std::move(measured));
  return routings_.size() - 1;
}

std::vector<MeasuredRouting> RoutingTable::with_segments() const {
  std::vector<MeasuredRouting> result = routings_;
  for (MeasuredRouting& routing : result) {
    for (const Channel& channel : channels_.channels()) {
      routing.segments.push_back(find_segment(routing.network, channel.segment));
    }
  }
  return result;
}

void Covariates::finish(MeasuredData& data, FaultList& faults) const {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    if (is_of_words(i)) {
      data.notes.push_back(
          {NoteKind::passed_over,
           fmt::format("column '{}' has words and is none that is known: it is not read",
                       for_message(names_[i])),
           {}});
      continue;
    }
    faults.add(columns_[i].faults);
    kept.push_back(i);
    data.covariates.push_back(names_[i]);
  }
  if (kept.size() == names_.size()) return;
  for (Reading& reading : data.readings) {
    std::vector<std::optional<double>> values;
    for (const std::size_t i : kept) values.push_back(reading.covariates[i]);
    reading.covariates = std::move(values);
  }
}

namespace {

std::vector<std::string> covariate_names(const std::vector<DataColumn>& columns) {
  std::vector<std::string> names;
  for (const DataColumn& column : columns) {
    if (column.role == DataRole::covariate) names.push_back(column.name);
  }
  return names;
}

// The first ones: a message has one line.
std::string segment_names(const Network& network) {
  constexpr std::size_t most = 20;
  std::string list;
  for (std::size_t i = 0; i < network.segments.size() && i < most; ++i) {
    list += (list.empty() ? "" : ", ") + segment_name(network.segments[i]);
  }
  return network.segments.size() > most ? list + ", …" : list;
}

// The place of the text among those seen, in the order of the file.
std::size_t place_of(std::string_view text, std::map<std::string, std::size_t, std::less<>>& seen,
                     std::vector<std::string>& all) {
  const auto [found, is_new] = seen.emplace(text, all.size());
  if (is_new) all.emplace_back(text);
  return found->second;
}

}  // namespace

RowReader::RowReader(const CsvReader& csv, const std::vector<DataColumn>& columns,
                     const RoutingResolver& resolve, const ReadingOptions& options,
                     FaultList& faults)
    : csv_(csv),
      columns_(columns),
      options_(options),
      faults_(faults),
      cells_(csv, columns, faults),
      routings_(columns, resolve),
      covariates_(covariate_names(columns)),
      tare_(columns.size()) {
  data_.file = csv.name();
}

void RowReader::read(const CsvRow& row) {
  if (row.ragged) return faults_.add(row.line, "rows of another length", *row.ragged);
  const std::size_t faults_before = faults_.count();
  RowCells::Numbers numbers = cells_.numbers(row);
  if (is_tare(cells_, row)) {
    if (faults_.count() == faults_before) tare_.add(row.line, numbers);
    return;
  }
  tare_.close();
  take_zeros(tare_, columns_, numbers);
  Reading reading;
  reading.line = row.line;
  read_words(row, reading);
  set_numbers(row, numbers, reading);
  read_covariates(row, reading);
  require_tension(row, numbers);
  if (faults_.count() == faults_before) data_.readings.push_back(std::move(reading));
}

MeasuredData RowReader::finish() {
  data_.channels = routings_.channels().channels();
  data_.routings = routings_.with_segments();
  for (Reading& reading : data_.readings) {
    reading.tension_N.resize(data_.channels.size());
    reading.error_N.resize(data_.channels.size());
  }
  note_what_is_passed_over();
  set_known_noise();
  covariates_.finish(data_, faults_);
  for (DataNote& note : tare_.notes()) data_.notes.push_back(std::move(note));
  return std::move(data_);
}

void RowReader::read_words(const CsvRow& row, Reading& reading) {
  reading.run = run(row).value_or(0);
  reading.group = group(row);
  const auto routing = this->routing(row);
  reading.routing = routing.value_or(routings_.count());
  if (const auto held = find_column(columns_, DataRole::held); held && routing) {
    reading.grasp = cells_
                        .at(row, *held,
                            [&](std::string_view text) {
                              return read_held(text, routings_[*routing].network.fingers);
                            })
                        .value_or(Grasp{});
  }
  std::optional<Direction> said;
  if (const auto direction = find_column(columns_, DataRole::direction)) {
    said = cells_.at(row, *direction, read_direction).value_or(std::nullopt);
  }
  reading.direction = said.value_or(Direction::pull);
  reading.direction_assumed = !said;
}

std::optional<std::size_t> RowReader::run(const CsvRow& row) {
  const auto column = find_column(columns_, DataRole::run);
  if (!column) return std::nullopt;
  return cells_.at(row, *column, [&](std::string_view text) {
    if (text.empty()) throw InputError({.expected = "a name or number for the run"});
    require_short_name(text);
    return place_of(text, runs_, data_.runs);
  });
}

std::optional<std::size_t> RowReader::group(const CsvRow& row) {
  const auto column = find_column(columns_, DataRole::group);
  if (!column || is_missing(cells_.cell(row, DataRole::group))) return std::nullopt;
  return cells_.at(row, *column, [&](std::string_view text) {
    require_short_name(text);
    return place_of(text, groups_, data_.groups);
  });
}

std::optional<std::size_t> RowReader::routing(const CsvRow& row) {
  const auto column = find_column(columns_, DataRole::routing);
  if (!column) return std::nullopt;
  return cells_.at(row, *column, [&](std::string_view text) { return routings_.index(text); });
}

void RowReader::set_numbers(const CsvRow& row, const RowCells::Numbers& numbers, Reading& reading) {
  set_conditions(numbers, reading);
  if (reading.routing < routings_.count()) {
    reading.tension_N.resize(routings_.channels().channels().size());
    reading.error_N.resize(routings_.channels().channels().size());
    for (std::size_t column = 0; column < columns_.size(); ++column) {
      if (columns_[column].role != DataRole::tension || !numbers[column]) continue;
      set_tension(row, column, *numbers[column], reading);
    }
    set_errors(numbers, reading);
  }
}

void RowReader::read_covariates(const CsvRow& row, Reading& reading) {
  for (std::size_t column = 0; column < columns_.size(); ++column) {
    if (columns_[column].role != DataRole::covariate) continue;
    const std::size_t covariate = reading.covariates.size();
    std::optional<double> value;
    try {
      value = cells_.covariate(row, column);
      if (value) covariates_.add_number(covariate);
    } catch (const InputError& error) {
      covariates_.add_fault(covariate, row.line, in_column(columns_[column]),
                            cells_.fault(row, column, error));
    }
    reading.covariates.push_back(value);
  }
}

void RowReader::set_conditions(const RowCells::Numbers& numbers, Reading& reading) const {
  const auto set = [&](DataRole role, std::optional<double>& value) {
    if (const auto column = find_column(columns_, role)) value = numbers[*column];
  };
  set(DataRole::motor_tension, reading.motor_tension_N);
  set(DataRole::speed, reading.speed_mm_s);
  set(DataRole::cycle, reading.cycle);
  set(DataRole::temperature, reading.temperature_C);
  set(DataRole::sheath_angle, reading.sheath_angle_rad);
}

void RowReader::set_tension(const CsvRow& row, std::size_t column, double tension_N,
                            Reading& reading) {
  cells_.at(row, column, [&](std::string_view) {
    const MeasuredRouting& routing = routings_[reading.routing];
    const MeasuredPlace& place = columns_[column].place;
    const auto channel = routings_.channels().channel(reading.routing, column);
    const std::string name =
        (place.beside ? "motor-side segment at " : "segment ") + segment_name(place.segment);
    if (!channel) {
      throw InputError(
          {.what = fmt::format("the routing '{}' has no {}", for_message(routing.word), name),
           .expected =
               fmt::format("an empty cell; its segments are {}", segment_names(routing.network))});
    }
    if (reading.tension_N[*channel]) {
      throw InputError({.what = fmt::format("in the routing '{}' that is segment {}, which another "
                                            "column has",
                                            for_message(routing.word),
                                            routings_.channels().channels()[*channel].name),
                        .expected = "an empty cell in one of the two"});
    }
    reading.tension_N[*channel] = tension_N;
    return true;
  });
}

// The mean of n samples errs by sd/√n.
void RowReader::set_errors(const RowCells::Numbers& numbers, Reading& reading) const {
  const auto readings = find_column(columns_, DataRole::readings);
  const double count = readings ? numbers[*readings].value_or(1) : 1;
  if (const auto motor = find_column(columns_, DataRole::motor_deviation)) {
    if (numbers[*motor]) reading.motor_error_N = *numbers[*motor] / std::sqrt(count);
  }
  for (std::size_t column = 0; column < columns_.size(); ++column) {
    if (columns_[column].role != DataRole::deviation || !numbers[column]) continue;
    const auto channel = routings_.channels().channel(reading.routing, column);
    if (channel && reading.tension_N[*channel]) {
      reading.error_N[*channel] = *numbers[column] / std::sqrt(count);
    }
  }
}

void RowReader::set_known_noise() {
  data_.known_noise.resize(data_.channels.size());
  std::string told;
  for (const ColumnNoise& given : options_.noise) {
    for (std::size_t column = 0; column < columns_.size(); ++column) {
      if (!is_noise_of(given, columns_[column])) continue;
      told += fmt::format("{}{} {}", told.empty() ? "" : ", ", for_message(columns_[column].name),
                          noise_text(given.noise));
      if (columns_[column].role == DataRole::motor_tension) data_.known_motor_noise = given.noise;
      for (std::size_t r = 0; r < routings_.count(); ++r) {
        const auto channel = routings_.channels().channel(r, column);
        if (channel) data_.known_noise[*channel] = given.noise;
      }
    }
  }
  if (told.empty()) return;
  data_.notes.push_back(
      {NoteKind::known_noise,
       fmt::format("what readings scatter by is taken as told: {} (one standard deviation)", told),
       {}});
}

void RowReader::require_tension(const CsvRow& row, const RowCells::Numbers& numbers) {
  const auto first = find_column(columns_, DataRole::tension);
  if (!first) return;
  for (std::size_t column = 0; column < columns_.size(); ++column) {
    // A cell that cannot be read is a fault of its own.
    if (columns_[column].role != DataRole::tension) continue;
    if (numbers[column] || !is_missing(trimmed(row.fields[column]))) return;
  }
  faults_.add(row.line, "rows without a tension",
              {.where = fmt::format("{}:{}", csv_.name(), row.line),
               .what = "the row has no tension",
               .expected = fmt::format("a number in column '{}' or another one of tensions",
                                       for_message(columns_[*first].name))});
}

void RowReader::note_what_is_passed_over() {
  if (cells_.lines_without_name().empty()) return;
  data_.notes.push_back({NoteKind::passed_over, "cells in columns without a name are not read",
                         cells_.lines_without_name()});
}

}  // namespace reeve::readings
