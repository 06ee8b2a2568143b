#include "diagnosis/data/measured_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <map>
#include <utility>

#include "core/error.hpp"
#include "core/graph.hpp"
#include "core/notation.hpp"
#include "core/text.hpp"
#include "diagnosis/data/checks/below_zero.hpp"
#include "diagnosis/data/csv.hpp"
#include "diagnosis/data/csv_number.hpp"
#include "diagnosis/data/data_columns.hpp"
#include "diagnosis/data/data_notes.hpp"

namespace reeve::diagnosis {
namespace {

bool says_simulated(const std::string& comment) {
  constexpr std::string_view word = "simulated";
  return std::search(comment.begin(), comment.end(), word.begin(), word.end(), [](char a, char b) {
           return std::tolower(static_cast<unsigned char>(a)) == b;
         }) != comment.end();
}

// "1;2" as core writes it: "1,2".
Grasp read_held(std::string_view text, int fingers) {
  std::string held(text);
  std::replace(held.begin(), held.end(), ';', ',');
  held.erase(std::remove(held.begin(), held.end(), ' '), held.end());
  if (held.empty() || held == "none") return {};
  if (fingers == 0) throw InputError({.expected = "an empty cell: the routing has no fingers"});
  if (const auto grasp = grasp_named(held, fingers)) return *grasp;
  throw InputError(
      {.expected = fmt::format("an empty cell (none held), or finger numbers from 1 to {}, each "
                               "once, such as {}",
                               fingers, fingers > 1 ? "1;2" : "1")});
}

Direction read_direction(std::string_view text) {
  if (text.empty() || text == "pull") return Direction::pull;
  if (text == "release") return Direction::release;
  throw InputError({.expected = "pull, release, or an empty cell (pull)"});
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

class DataReader {
 public:
  DataReader(CsvReader csv, const RoutingResolver& resolve)
      : csv_(std::move(csv)),
        resolve_(resolve),
        columns_(read_columns(csv_)),
        numbers_(csv_.separator()),
        run_column_(*find_column(columns_, DataRole::run)),
        routing_column_(*find_column(columns_, DataRole::routing)),
        held_column_(find_column(columns_, DataRole::held)) {
    for (const DataColumn& column : columns_) {
      if (column.role == DataRole::tension) {
        data_.channels.push_back({segment_name(column.segment), column.segment});
      }
      if (column.role == DataRole::covariate) data_.covariates.push_back(column.name);
    }
  }

  MeasuredData read() {
    data_.file = csv_.name();
    for (CsvRow row; csv_.next(row);) read_row(row);
    if (data_.readings.empty()) {
      throw InputError({.where = fmt::format("{}:{}", data_.file, csv_.header().line),
                        .expected = "rows below the header, and there are none"});
    }
    std::vector<CsvComment> below;
    for (const CsvComment& comment : csv_.comments()) {
      data_.simulated |= says_simulated(comment.text);
      if (comment.line > csv_.header().line) below.push_back(comment);
    }
    std::vector<DataNote> left_out = leave_out_negative_motor_tensions(data_);
    if (data_.readings.empty()) {
      throw InputError({.where = data_.file,
                        .what = "motor_tension_N is below zero in every row",
                        .expected = "motor tensions from 0"});
    }
    data_.notes = data_notes(data_, below);
    std::move(left_out.begin(), left_out.end(), std::back_inserter(data_.notes));
    return std::move(data_);
  }

 private:
  // Runs `action` on the cell, and puts file, line, column and value before its input error.
  template <typename Action>
  auto at(const CsvRow& row, std::size_t column, Action action) {
    const std::string_view cell = trimmed(row.fields[column]);
    try {
      return action(cell);
    } catch (const InputError& error) {
      throw InputError(changed(error.fault(), one_line))
          .at(InputFault{.where = fmt::format("{}:{}", csv_.name(), row.line),
                         .what = fmt::format("column '{}'", for_message(columns_[column].name)),
                         .value = for_message(cell),
                         .form = InputForm::cell});
    }
  }

  void read_row(const CsvRow& row) {
    Reading reading;
    reading.line = row.line;
    reading.run = at(row, run_column_, [&](std::string_view text) { return run(text); });
    reading.routing =
        at(row, routing_column_, [&](std::string_view text) { return routing(text); });
    const MeasuredRouting& routing = data_.routings[reading.routing];
    if (held_column_) {
      reading.grasp = at(row, *held_column_, [&](std::string_view text) {
        return read_held(text, routing.network.fingers);
      });
    }
    for (std::size_t column = 0; column < columns_.size(); ++column) {
      read_cell(row, column, routing, reading);
    }
    const auto is_given = [](const std::optional<double>& tension) { return tension.has_value(); };
    if (std::none_of(reading.tension_N.begin(), reading.tension_N.end(), is_given)) {
      throw InputError(
          {.where = fmt::format("{}:{}", csv_.name(), row.line),
           .what = "the row has no tension",
           .expected = fmt::format("a number in column '{}' or another one of tensions",
                                   columns_[*find_column(columns_, DataRole::tension)].name)});
    }
    data_.readings.push_back(std::move(reading));
  }

  void read_cell(const CsvRow& row, std::size_t column, const MeasuredRouting& routing,
                 Reading& reading) {
    const auto number = [&] { return this->number(row, column); };
    switch (columns_[column].role) {
      case DataRole::run:
      case DataRole::routing:
      case DataRole::held:
        break;
      case DataRole::direction:
        reading.direction = at(row, column, read_direction);
        break;
      case DataRole::motor_tension:
        reading.motor_tension_N = number();
        break;
      case DataRole::speed:
        reading.speed_mm_s = number();
        break;
      case DataRole::cycle:
        reading.cycle = number();
        break;
      case DataRole::temperature:
        reading.temperature_C = number();
        break;
      case DataRole::sheath_angle:
        reading.sheath_angle_rad = number();
        break;
      case DataRole::tension:
        reading.tension_N.push_back(tension(row, column, routing, reading.tension_N.size()));
        break;
      case DataRole::covariate:
        reading.covariates.push_back(number());
        break;
    }
  }

  std::optional<double> number(const CsvRow& row, std::size_t column) {
    return at(row, column, [&](std::string_view text) -> std::optional<double> {
      if (text.empty()) return std::nullopt;
      return numbers_.read(text, row.line, columns_[column].low, columns_[column].high);
    });
  }

  std::optional<double> tension(const CsvRow& row, std::size_t column,
                                const MeasuredRouting& routing, std::size_t channel) {
    const std::optional<double> value = number(row, column);
    if (!value || routing.segments[channel]) return value;
    return at(row, column, [&](std::string_view) -> std::optional<double> {
      throw InputError(
          {.what = fmt::format("the routing '{}' has no segment {}", for_message(routing.word),
                               data_.channels[channel].name),
           .expected =
               fmt::format("an empty cell; its segments are {}", segment_names(routing.network))});
    });
  }

  std::size_t run(std::string_view text) {
    if (text.empty()) throw InputError({.expected = "a name or number for the run"});
    const auto [found, is_new] = runs_.emplace(text, data_.runs.size());
    if (is_new) data_.runs.emplace_back(text);
    return found->second;
  }

  std::size_t routing(std::string_view text) {
    const auto found = routings_.find(text);
    if (found != routings_.end()) return found->second;
    if (text.empty()) throw InputError({.expected = "a routing such as M-1-T-2-F"});
    const std::size_t index = add_routing(resolve_(std::string(text)));
    routings_.emplace(text, index);
    return index;
  }

  // A name and its word are one routing.
  std::size_t add_routing(const Routing& routing) {
    for (std::size_t i = 0; i < data_.routings.size(); ++i) {
      if (data_.routings[i].routing == routing) return i;
    }
    MeasuredRouting measured{to_word(routing), routing, expand(routing), {}};
    require_actuated(graph(measured.network), measured.word);
    for (const Channel& channel : data_.channels) {
      measured.segments.push_back(find_segment(measured.network, channel.segment));
    }
    data_.routings.push_back(std::move(measured));
    return data_.routings.size() - 1;
  }

  CsvReader csv_;
  const RoutingResolver& resolve_;
  std::vector<DataColumn> columns_;
  CsvNumberReader numbers_;
  std::size_t run_column_;
  std::size_t routing_column_;
  std::optional<std::size_t> held_column_;
  std::map<std::string, std::size_t, std::less<>> runs_;
  std::map<std::string, std::size_t, std::less<>> routings_;
  MeasuredData data_;
};

}  // namespace

MeasuredData read_measured_data(const std::filesystem::path& path, const RoutingResolver& resolve) {
  return DataReader(CsvReader::open(path), resolve).read();
}

MeasuredData parse_measured_data(std::string text, const std::string& name,
                                 const RoutingResolver& resolve) {
  return DataReader(CsvReader(std::move(text), name), resolve).read();
}

}  // namespace reeve::diagnosis
