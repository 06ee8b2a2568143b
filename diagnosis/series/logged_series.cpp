#include "diagnosis/series/logged_series.hpp"

#include <fmt/format.h>

#include <limits>
#include <map>
#include <utility>

#include "core/error.hpp"
#include "core/text.hpp"
#include "diagnosis/data/csv.hpp"
#include "diagnosis/data/csv_number.hpp"
#include "diagnosis/data/intake/words.hpp"
#include "diagnosis/series/log_columns.hpp"

namespace reeve::diagnosis {
namespace {

// Far above any rig, and squares of them stay numbers.
constexpr double greatest_logged = 1e9;
constexpr double greatest_clock = 1e15;  // a date in microseconds

class LogReader {
 public:
  explicit LogReader(CsvReader csv)
      : csv_(std::move(csv)),
        columns_(read_log_columns(csv_)),
        numbers_(csv_.separator()),
        is_decided_(columns_.size(), false),
        is_text_(columns_.size(), false),
        cells_(columns_.size()) {}

  LoggedSeries read() {
    series_.file = csv_.name();
    for (CsvRow row; csv_.next(row);) read_sample(row);
    if (series_.lines.empty()) {
      throw InputError({.where = fmt::format("{}:{}", series_.file, csv_.header().line),
                        .expected = "rows below the header, and there are none"});
    }
    for (const CsvComment& comment : csv_.comments()) {
      series_.simulated |= says_simulated(comment.text);
      if (comment.line < csv_.header().line) series_.comments.push_back(comment.text);
    }
    take_columns();
    return std::move(series_);
  }

 private:
  void read_sample(const CsvRow& row) {
    series_.lines.push_back(row.line);
    LogLabels labels;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const std::string_view cell = trimmed(row.fields[i]);
      switch (columns_[i].role) {
        case LogRole::run:
          labels.run = name(row, i, cell);
          break;
        case LogRole::routing:
          labels.routing = cell;
          break;
        case LogRole::held:
          labels.held = cell;
          break;
        case LogRole::direction:
          labels.direction = cell;
          break;
        case LogRole::other:
          read_other(row, i, cell, labels);
          break;
        default:
          cells_[i].push_back(number(row, i, cell));
      }
    }
    const auto [found, is_new] = known_labels_.emplace(std::move(labels), series_.labels.size());
    if (is_new) series_.labels.push_back(found->first);
    series_.label.push_back(found->second);
  }

  // The first cell that is not empty tells numbers from text.
  void read_other(const CsvRow& row, std::size_t column, std::string_view cell, LogLabels& labels) {
    if (!is_decided_[column] && !is_missing(cell)) {
      is_decided_[column] = true;
      is_text_[column] = !is_number(row, column, cell);
    }
    if (is_text_[column]) {
      labels.others.push_back(fmt::format("{}={}", columns_[column].name, name(row, column, cell)));
    } else {
      cells_[column].push_back(number(row, column, cell));
    }
  }

  std::string_view name(const CsvRow& row, std::size_t column, std::string_view cell) const {
    try {
      require_short_name(cell);
    } catch (const InputError& error) {
      throw cell_error(error, csv_.name(), row.line, columns_[column].name, cell);
    }
    return cell;
  }

  bool is_number(const CsvRow& row, std::size_t column, std::string_view cell) {
    try {
      number(row, column, cell);
      return true;
    } catch (const InputError&) {
      return false;
    }
  }

  double number(const CsvRow& row, std::size_t column, std::string_view cell) {
    const LogColumn& log_column = columns_[column];
    const bool clock = log_column.role == LogRole::time;
    if (is_missing(cell) && !clock) return std::numeric_limits<double>::quiet_NaN();
    const double greatest = clock ? greatest_clock : greatest_logged;
    try {
      if (is_missing(cell)) throw InputError({.expected = "the time of the sample, a number"});
      return log_column.scale * numbers_.read(cell, row.line, -greatest, greatest);
    } catch (const InputError& error) {
      throw cell_error(error, csv_.name(), row.line, log_column.name, cell);
    }
  }

  void take_columns() {
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      LoggedSignal signal{columns_[i].name, std::move(cells_[i])};
      switch (columns_[i].role) {
        case LogRole::time:
          series_.time_s = std::move(signal.values);
          break;
        case LogRole::position:
          series_.position_mm = std::move(signal);
          break;
        case LogRole::speed:
          series_.speed_mm_s = std::move(signal);
          break;
        case LogRole::motor_tension:
          series_.motor_tension_N = std::move(signal);
          break;
        case LogRole::tension:
          series_.tensions_N.push_back(std::move(signal));
          break;
        case LogRole::run:
          series_.has_runs = true;
          break;
        case LogRole::routing:
          series_.has_routings = true;
          break;
        case LogRole::held:
          series_.has_held = true;
          break;
        case LogRole::direction:
          break;
        case LogRole::other:
          if (is_text_[i]) {
            series_.notes.push_back(
                {NoteKind::covariate,
                 fmt::format(
                     "column '{}' holds text: the log is cut where it changes, and readings "
                     "do not have it",
                     for_message(columns_[i].name)),
                 {}});
          } else {
            series_.others.push_back(std::move(signal));
          }
      }
    }
  }

  CsvReader csv_;
  std::vector<LogColumn> columns_;
  CsvNumberReader numbers_;
  std::vector<bool> is_decided_;  // of other columns: numbers or text
  std::vector<bool> is_text_;
  std::vector<std::vector<double>> cells_;  // of each column; none of text
  std::map<LogLabels, std::size_t> known_labels_;
  LoggedSeries series_;
};

}  // namespace

LoggedSeries read_logged_series(const std::filesystem::path& path) {
  return LogReader(CsvReader::open(path)).read();
}

LoggedSeries parse_logged_series(std::string text, const std::string& name) {
  return LogReader(CsvReader(std::move(text), name)).read();
}

}  // namespace reeve::diagnosis
