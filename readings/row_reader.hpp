// Rows of a file of measured tensions, one after the other, into readings. What is wrong with a row
// goes into the list of faults, all of it, and the row into nothing else.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "readings/columns.hpp"
#include "readings/fault_list.hpp"
#include "readings/measured_data.hpp"
#include "readings/rows.hpp"

namespace reeve::readings {

// Which columns are channels. A column of a strand or of a lettered segment is one. A column at_T1
// is of the motor-side segment that is beside T1, so its letter, and with it its channel, is a
// matter of each routing.

class ChannelTable {
 public:
  explicit ChannelTable(const std::vector<DataColumn>& columns);

  // Adds the channels that columns beside strands are for this routing, the next one.
  void add_routing(const Network& network);

  // Of a column of tensions or of deviations; nothing if the routing has no such segment.
  std::optional<std::size_t> channel(std::size_t routing, std::size_t column) const {
    return of_routing_[routing][column];
  }
  const std::vector<Channel>& channels() const { return channels_; }

 private:
  std::size_t channel_of(const Segment& segment);

  std::vector<MeasuredPlace> places_;  // by column
  std::vector<bool> measured_;         // whether it is such a column
  std::vector<Channel> channels_;
  std::vector<std::vector<std::optional<std::size_t>>> of_routing_;
};

// The routings of a file by the texts of its cells, each with the columns that are its segments.

class RoutingTable {
 public:
  // `resolve` must outlive the table.
  RoutingTable(const std::vector<DataColumn>& columns, const RoutingResolver& resolve)
      : channels_(columns), resolve_(resolve) {}

  // Throws InputError of a text that is no routing, or of one that the motor cannot pull.
  std::size_t index(std::string_view text);
  std::size_t count() const { return routings_.size(); }
  const MeasuredRouting& operator[](std::size_t index) const { return routings_[index]; }
  const ChannelTable& channels() const { return channels_; }
  // Once all are known, since each may add channels.
  std::vector<MeasuredRouting> with_segments() const;

 private:
  std::size_t add(const Routing& routing);

  ChannelTable channels_;
  const RoutingResolver& resolve_;
  std::vector<MeasuredRouting> routings_;
  std::map<std::string, std::size_t, std::less<>> by_text_;
};

// Columns that no model knows: numbers, or words. A column most of whose cells are words is passed
// over; in another one, words are faults.

class Covariates {
 public:
  explicit Covariates(std::vector<std::string> names)
      : names_(std::move(names)), columns_(names_.size()) {}

  std::size_t count() const { return names_.size(); }
  void add_number(std::size_t covariate) { ++columns_[covariate].numbers; }
  void add_fault(std::size_t covariate, std::size_t line, const std::string& kind,
                 const InputFault& fault) {
    columns_[covariate].faults.add(line, kind, fault);
  }

  // Once all rows are read: the names go into the data, columns of words leave the readings with a
  // note, and the faults of the others join the list.
  void finish(MeasuredData& data, FaultList& faults) const;

 private:
  struct Column {
    std::size_t numbers = 0;
    FaultList faults;
  };

  bool is_of_words(std::size_t covariate) const {
    return columns_[covariate].faults.count() > columns_[covariate].numbers;
  }

  std::vector<std::string> names_;
  std::vector<Column> columns_;
};

class RowReader {
 public:
  // All must outlive the reader.
  RowReader(const CsvReader& csv, const std::vector<DataColumn>& columns,
            const RoutingResolver& resolve, const ReadingOptions& options, FaultList& faults);

  void read(const CsvRow& row);
  // Once all rows are read.
  MeasuredData finish();

 private:
  std::optional<std::size_t> run(const CsvRow& row);
  std::optional<std::size_t> group(const CsvRow& row);
  std::optional<std::size_t> routing(const CsvRow& row);
  void read_words(const CsvRow& row, Reading& reading);
  void set_numbers(const CsvRow& row, const RowCells::Numbers& numbers, Reading& reading);
  void read_covariates(const CsvRow& row, Reading& reading);
  void set_conditions(const RowCells::Numbers& numbers, Reading& reading) const;
  void set_tension(const CsvRow& row, std::size_t column, double tension_N, Reading& reading);
  void set_errors(const RowCells::Numbers& numbers, Reading& reading) const;
  void require_tension(const CsvRow& row, const RowCells::Numbers& numbers);
  void note_what_is_passed_over();
  void set_known_noise();

  const CsvReader& csv_;
  const std::vector<DataColumn>& columns_;
  const ReadingOptions& options_;
  FaultList& faults_;
  RowCells cells_;
  RoutingTable routings_;
  Covariates covariates_;
  Tare tare_;
  std::map<std::string, std::size_t, std::less<>> runs_;
  std::map<std::string, std::size_t, std::less<>> groups_;
  MeasuredData data_;
};

}  // namespace reeve::readings
