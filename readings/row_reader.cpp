#include "readings/row_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "core/graph.hpp"
#include "core/motor_sides.hpp"
#include "core/notation.hpp"
#include "readings/data_columns.hpp"

namespace reeve::readings {
namespace {

// Names in the order in which the file has them first.
class NamesSeen {
 public:
  std::size_t place_of(std::string_view name) {
    const auto [found, is_new] = places_.emplace(name, names_.size());
    if (is_new) names_.emplace_back(name);
    return found->second;
  }
  std::vector<std::string> take() { return std::move(names_); }

 private:
  std::map<std::string, std::size_t, std::less<>> places_;
  std::vector<std::string> names_;
};

// The routings of a file by the texts of its cells, each with the channels that columns are for it.
// A column of a strand or of a lettered segment is one channel. A column at_T1 is of the motor-side
// segment that is beside T1, so its letter, and with it its channel, is a matter of each routing.
class RoutingTable {
 public:
  RoutingTable(const ColumnList& columns, const RoutingResolver& resolve)
      : columns_(columns), resolve_(resolve) {
    for (const DataColumn& column : columns) {
      if (column.role == DataRole::tension && !column.place.beside) {
        channel_of(column.place.segment);
      }
    }
  }

  // Throws InputError of a text that is no routing, or of one that the motor cannot pull.
  std::size_t index(std::string_view text) {
    const auto found = by_text_.find(text);
    if (found != by_text_.end()) return found->second;
    if (text.empty())
      throw InputError(
          {.expected = "a routing such as M-1-T-2-F (if cells were merged, fill them down)"});
    const std::size_t index = add(resolve_(std::string(text)));
    by_text_.emplace(text, index);
    return index;
  }

  std::size_t count() const { return routings_.size(); }
  const MeasuredRouting& operator[](std::size_t index) const { return routings_[index]; }
  const std::vector<Channel>& channels() const { return channels_; }
  // Returns the channel of a column of tensions or deviations. Returns nothing if the routing has
  // no such segment.
  std::optional<std::size_t> channel(std::size_t routing, std::size_t column) const {
    return of_columns_[routing][column];
  }

  // Once all are known, since each may add channels.
  std::vector<MeasuredRouting> with_segments() const {
    std::vector<MeasuredRouting> result = routings_;
    for (MeasuredRouting& routing : result) {
      for (const Channel& channel : channels_) {
        routing.segments.push_back(find_segment(routing.network, channel.segment));
      }
    }
    return result;
  }

 private:
  // A name and its word are one routing.
  std::size_t add(const Routing& routing) {
    for (std::size_t i = 0; i < routings_.size(); ++i) {
      if (routings_[i].routing == routing) return i;
    }
    if (const int motors = carriage_count(routing); motors > 1) {
      throw InputError(
          {.where = fmt::format("routing '{}'", to_word(routing)),
           .what = fmt::format("it has {} motors, and a row one motor tension", motors),
           .expected = "a routing of one motor"});
    }
    MeasuredRouting measured{to_word(routing), routing, expand(routing), {}};
    require_actuated(measured.network, measured.word);
    of_columns_.push_back(channels_of_columns(measured.network));
    routings_.push_back(std::move(measured));
    return routings_.size() - 1;
  }

  std::vector<std::optional<std::size_t>> channels_of_columns(const Network& network) {
    std::vector<std::optional<std::size_t>> channels(columns_.size());
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const auto& [segment, beside] = columns_[i].place;
      if (columns_[i].role != DataRole::tension && columns_[i].role != DataRole::deviation)
        continue;
      const auto meant = beside ? motor_side_at(network, segment) : segment;
      if (meant && find_segment(network, *meant)) channels[i] = channel_of(*meant);
    }
    return channels;
  }

  std::size_t channel_of(const Segment& segment) {
    const auto found =
        std::find_if(channels_.begin(), channels_.end(),
                     [&](const Channel& channel) { return channel.segment == segment; });
    if (found != channels_.end()) return static_cast<std::size_t>(found - channels_.begin());
    channels_.push_back({segment_name(segment), segment});
    return channels_.size() - 1;
  }

  const ColumnList& columns_;
  const RoutingResolver& resolve_;
  std::vector<MeasuredRouting> routings_;
  std::map<std::string, std::size_t, std::less<>> by_text_;
  std::vector<Channel> channels_;
  std::vector<std::vector<std::optional<std::size_t>>> of_columns_;  // [routing][column]
};

// The first ones: a message has one line.
std::string segment_names(const Network& network) {
  constexpr std::size_t most = 20;
  std::string list;
  for (std::size_t i = 0; i < network.segments.size() && i < most; ++i) {
    list += (list.empty() ? "" : ", ") + segment_name(network.segments[i]);
  }
  return network.segments.size() > most ? list + ", …" : list;
}

// A column that no model knows: numbers, or words.
struct CovariateColumn {
  std::size_t column = 0;
  std::size_t numbers = 0;
  FaultList faults;             // cells that are no number
  std::set<std::string> words;  // these cells; up to one more than there may be groups

  bool is_of_words() const { return faults.count() > numbers; }
  // Several rows share a word, as those of a lot do and times do not.
  bool may_be_of_groups() const {
    return words.size() > 1 && words.size() <= most_groups && 2 * words.size() <= faults.count();
  }

  static constexpr std::size_t most_groups = 20;
};

class RowReader {
 public:
  // All must outlive the reader.
  RowReader(const CsvReader& csv, const ColumnList& columns, const RoutingResolver& resolve,
            const ReadingOptions& options, FaultList& faults)
      : csv_(csv),
        columns_(columns),
        options_(options),
        faults_(faults),
        cells_(csv, columns, faults),
        routings_(columns, resolve) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (columns[i].role == DataRole::covariate) covariates_.push_back({i, 0, {}, {}});
    }
  }

  void read(const CsvRow& row) {
    const std::optional<RowCells::Numbers> numbers = cells_.numbers(row);
    if (!numbers) return;
    Reading reading;
    reading.line = row.line;
    read_words(row, reading);
    set_conditions(*numbers, reading);
    if (reading.routing < routings_.count()) {
      set_tensions(row, *numbers, reading);
      set_errors(*numbers, reading);
    }
    read_covariates(row, reading);
    note_without_tension(row, *numbers);
    data_.readings.push_back(std::move(reading));
  }

  // Once all rows are read.
  MeasuredData finish() {
    data_.file = csv_.name();
    data_.runs = runs_.take();
    add_rows_without_tension();
    data_.groups = groups_.take();
    data_.channels = routings_.channels();
    data_.routings = routings_.with_segments();
    for (Reading& reading : data_.readings) {
      reading.tension_N.resize(data_.channels.size());
      reading.error_N.resize(data_.channels.size());
    }
    note_directions(directions_, data_.notes);
    cells_.note_cells(data_.notes);
    set_known_noise();
    set_covariates();
    cells_.note_zeros(data_.notes);
    return std::move(data_);
  }

 private:
  // Returns nothing if the file has no such column, or if the cell cannot be read.
  template <typename Action>
  auto word(const CsvRow& row, DataRole role, Action action)
      -> std::optional<decltype(action(std::string_view{}))> {
    const auto column = find_column(columns_, role);
    return column ? cells_.at(row, *column, action) : std::nullopt;
  }

  void read_words(const CsvRow& row, Reading& reading) {
    const auto run = word(row, DataRole::run, [&](std::string_view text) {
      if (text.empty()) {
        throw InputError(
            {.expected = "a name or number for the run (if cells were merged, fill them down)"});
      }
      require_short_name(text);
      return runs_.place_of(text);
    });
    reading.run = run.value_or(0);
    const auto group =
        word(row, DataRole::group, [&](std::string_view text) -> std::optional<std::size_t> {
          if (is_missing(text)) return std::nullopt;
          require_short_name(text);
          return groups_.place_of(text);
        });
    reading.group = group.value_or(std::nullopt);
    const auto routing =
        word(row, DataRole::routing, [&](std::string_view text) { return routings_.index(text); });
    reading.routing = routing.value_or(routings_.count());
    if (routing) {
      const int fingers = routings_[*routing].network.fingers;
      reading.grasp_assumed = fingers > 1;
      const auto held = word(row, DataRole::held, [&](std::string_view text) {
        reading.grasp_assumed = fingers > 1 && leaves_held_open(text);
        return read_held(text, fingers);
      });
      reading.grasp = held.value_or(Grasp{});
    }
    const auto said = word(row, DataRole::direction, [&](std::string_view text) {
                        const auto direction = read_direction(text);
                        if (!directions_.contains(text)) directions_.emplace(text);
                        return direction;
                      }).value_or(std::nullopt);
    reading.direction = said.value_or(Direction::pull);
    reading.direction_assumed = !said;
  }

  void set_conditions(const RowCells::Numbers& numbers, Reading& reading) const {
    const auto set = [&](DataRole role, std::optional<double>& value) {
      if (const auto column = find_column(columns_, role)) value = numbers[*column];
    };
    set(DataRole::motor_tension, reading.motor_tension_N);
    set(DataRole::speed, reading.speed_mm_s);
    set(DataRole::cycle, reading.cycle);
    set(DataRole::temperature, reading.temperature_C);
    set(DataRole::sheath_angle, reading.sheath_angle_rad);
  }

  void set_tensions(const CsvRow& row, const RowCells::Numbers& numbers, Reading& reading) {
    reading.tension_N.resize(routings_.channels().size());
    for (std::size_t column = 0; column < columns_.size(); ++column) {
      if (columns_[column].role != DataRole::tension || !numbers[column]) continue;
      cells_.at(row, column, [&](std::string_view) {
        const std::size_t channel = free_channel(reading, column);
        reading.tension_N[channel] = numbers[column];
        return true;
      });
    }
  }

  // Throws InputError if the routing has no such segment, or another column has it.
  std::size_t free_channel(const Reading& reading, std::size_t column) const {
    const MeasuredRouting& routing = routings_[reading.routing];
    const MeasuredPlace& place = columns_[column].place;
    const auto channel = routings_.channel(reading.routing, column);
    if (!channel) {
      throw InputError(
          {.what = fmt::format("the routing '{}' has no {}{}", for_message(routing.word),
                               place.beside ? "motor-side segment at " : "segment ",
                               segment_name(place.segment)),
           .expected =
               fmt::format("an empty cell; its segments are {}", segment_names(routing.network))});
    }
    if (reading.tension_N[*channel]) {
      throw InputError(
          {.what = fmt::format("in the routing '{}' that is segment {}, which another "
                               "column has",
                               for_message(routing.word), routings_.channels()[*channel].name),
           .expected = "an empty cell in one of the two"});
    }
    return *channel;
  }

  // The mean of n samples errs by sd/√n.
  void set_errors(const RowCells::Numbers& numbers, Reading& reading) const {
    reading.error_N.resize(routings_.channels().size());
    const auto readings = find_column(columns_, DataRole::readings);
    const double count = readings ? numbers[*readings].value_or(1) : 1;
    for (std::size_t column = 0; column < columns_.size(); ++column) {
      if (!numbers[column]) continue;
      const double error_N = *numbers[column] / std::sqrt(count);
      if (columns_[column].role == DataRole::motor_deviation) reading.motor_error_N = error_N;
      if (columns_[column].role != DataRole::deviation) continue;
      const auto channel = routings_.channel(reading.routing, column);
      if (channel && reading.tension_N[*channel]) reading.error_N[*channel] = error_N;
    }
  }

  void read_covariates(const CsvRow& row, Reading& reading) {
    for (CovariateColumn& covariate : covariates_) {
      std::optional<double> value;
      try {
        value = cells_.covariate(row, covariate.column);
        if (value) ++covariate.numbers;
      } catch (const InputError& error) {
        cells_.add_fault(row, covariate.column, error, covariate.faults);
        if (covariate.words.size() <= CovariateColumn::most_groups) {
          covariate.words.emplace(trimmed(row.fields[covariate.column]));
        }
      }
      reading.covariates.push_back(value);
    }
  }

  void note_without_tension(const CsvRow& row, const RowCells::Numbers& numbers) {
    if (!find_column(columns_, DataRole::tension)) return;
    for (std::size_t column = 0; column < columns_.size(); ++column) {
      // A cell that cannot be read is a fault of its own.
      if (columns_[column].role != DataRole::tension) continue;
      if (numbers[column] || !is_no_number(trimmed(row.fields[column]))) return;
    }
    without_tension_.push_back(data_.readings.size());
  }

  // Whole runs without one are left out later (silent_runs.hpp).
  void add_rows_without_tension() {
    std::vector<std::size_t> rows(std::max<std::size_t>(data_.runs.size(), 1), 0);
    std::vector<std::size_t> empty = rows;
    for (const Reading& reading : data_.readings) ++rows[reading.run];
    for (const std::size_t r : without_tension_) ++empty[data_.readings[r].run];
    const bool all = without_tension_.size() == data_.readings.size();
    for (const std::size_t r : without_tension_) {
      const Reading& reading = data_.readings[r];
      if (!all && rows[reading.run] == empty[reading.run]) continue;
      faults_.add(reading.line, "rows without a tension",
                  {.where = fmt::format("{}:{}", csv_.name(), reading.line),
                   .what = "the row has no tension",
                   .expected = fmt::format(
                       "a number in column '{}' or another one of tensions",
                       for_message(columns_[*find_column(columns_, DataRole::tension)].name))});
    }
  }

  void set_known_noise() {
    data_.known_noise.resize(data_.channels.size());
    std::string told;
    for (const ColumnNoise& given : options_.noise) {
      for (std::size_t column = 0; column < columns_.size(); ++column) {
        if (!is_noise_of(given, columns_[column])) continue;
        told += fmt::format("{}{} {}", told.empty() ? "" : ", ", for_message(columns_[column].name),
                            noise_text(given.noise));
        if (columns_[column].role == DataRole::motor_tension) data_.known_motor_noise = given.noise;
        for (std::size_t r = 0; r < routings_.count(); ++r) {
          const auto channel = routings_.channel(r, column);
          if (channel) data_.known_noise[*channel] = given.noise;
        }
      }
    }
    if (told.empty()) return;
    data_.notes.push_back(
        {NoteKind::known_noise,
         fmt::format("what readings scatter by is taken as told: {} (one standard deviation)",
                     told)});
  }

  std::string way_to_groups(const CovariateColumn& covariate) const {
    if (options_.group || options_.group_option.empty() || !covariate.may_be_of_groups()) return "";
    return fmt::format(". If it tells lots, winches or operators apart, {} '{}' compares these",
                       options_.group_option, for_message(columns_[covariate.column].name));
  }

  // A column most of whose cells are words is passed over; in another one, words are faults.
  void set_covariates() {
    for (const CovariateColumn& covariate : covariates_) {
      const std::string& name = columns_[covariate.column].name;
      if (covariate.is_of_words()) {
        data_.notes.push_back(
            {NoteKind::passed_over,
             fmt::format("column '{0}' has words and is none that is known: it is not read{1}",
                         for_message(name), way_to_groups(covariate))});
      } else {
        faults_.add(covariate.faults);
        cells_.require_mark(covariate.column, faults_);
        data_.covariates.push_back(name);
      }
    }
    for (Reading& reading : data_.readings) {
      std::vector<std::optional<double>> values;
      for (std::size_t i = 0; i < covariates_.size(); ++i) {
        if (!covariates_[i].is_of_words()) values.push_back(reading.covariates[i]);
      }
      reading.covariates = std::move(values);
    }
  }

  const CsvReader& csv_;
  const ColumnList& columns_;
  const ReadingOptions& options_;
  FaultList& faults_;
  RowCells cells_;
  RoutingTable routings_;
  std::vector<CovariateColumn> covariates_;
  NamesSeen runs_;
  NamesSeen groups_;
  std::set<std::string, std::less<>> directions_;
  std::vector<std::size_t> without_tension_;  // places in the readings
  MeasuredData data_;
};

}  // namespace

MeasuredData read_rows(CsvReader& csv, const Beginning& beginning,
                       const std::vector<DataColumn>& columns, const RoutingResolver& resolve,
                       const ReadingOptions& options, FaultList& faults) {
  RowReader reader(csv, columns, resolve, options, faults);
  each_row(csv, beginning, faults, [&](const CsvRow& row) { reader.read(row); });
  return reader.finish();
}

}  // namespace reeve::readings
