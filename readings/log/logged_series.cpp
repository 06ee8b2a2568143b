#include "readings/log/logged_series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "readings/log/log_clock.hpp"
#include "readings/log/log_columns.hpp"
#include "readings/rows.hpp"
#include "readings/wall_clock.hpp"

namespace reeve::readings {
namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

// A column of a log that has words: labels, which stay for a while, or what goes with the samples,
// such as a clock on the wall. A log that is cut where the latter change has no steady stretch.
class LogWords {
 public:
  // Adds the word of the next samples.
  void add(std::string_view word, std::size_t samples = 1) {
    auto found = known_.find(word);
    if (found == known_.end()) {
      found = known_.emplace(word, static_cast<std::uint32_t>(words_.size())).first;
      words_.push_back(&found->first);
    }
    ids_.insert(ids_.end(), samples, found->second);
  }

  // Equal for equal words.
  std::uint32_t id(std::size_t sample) const { return ids_[sample]; }
  const std::string& word(std::size_t sample) const { return *words_[ids_[sample]]; }

  // True if they label: no times of day, alone or behind a date, and on average each stays over as
  // many samples as the shortest reading has.
  bool are_labels() const {
    constexpr std::size_t least_samples = 5;
    std::size_t changes = 0;
    for (std::size_t i = 1; i < ids_.size(); ++i) changes += ids_[i] != ids_[i - 1] ? 1 : 0;
    return changes * least_samples <= ids_.size() && !are_times_of_day();
  }

 private:
  bool are_times_of_day() const {
    bool any = false;
    for (const std::string* word : words_) {
      if (word->empty()) continue;
      if (!wall_time(*word)) return false;
      any = true;
    }
    return any;
  }

  std::map<std::string, std::uint32_t, std::less<>> known_;
  std::vector<const std::string*> words_;  // [id]
  std::vector<std::uint32_t> ids_;
};

bool is_label(DataRole role) {
  return role == DataRole::run || role == DataRole::routing || role == DataRole::held ||
         role == DataRole::direction;
}

bool has_form_of_number(std::string_view text) {
  const auto marks = std::ranges::count_if(text, [](char c) { return c == '.' || c == ','; });
  return (marks < 2 && text.find_first_not_of("0123456789+-eE.,") == std::string_view::npos) ||
         is_no_number(text);
}

// Row by row into columns; what is wrong goes to the list of faults.
class LogReader {
 public:
  // All must outlive the reader.
  LogReader(const CsvReader& csv, const std::vector<DataColumn>& columns, FaultList& faults)
      : csv_(csv),
        columns_(columns),
        faults_(faults),
        cells_(csv, columns, faults),
        values_(columns.size()) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      values_[c].is_text = is_label(columns[c].role);
    }
  }

  void read(const CsvRow& row) {
    if (garbled_.size() == most_garbled || !is_garbled(row)) return read_cells(row);
    garbled_.push_back(row);
  }

  // Once all rows are read. A serial line loses characters now and then, and a device writes a line
  // of words; where such rows are many, the file is another one than it seems, and each is a fault.
  void settle_garbled() {
    const std::size_t rows = series_.lines.size() + garbled_.size();
    if (garbled_.size() == most_garbled || garbled_.size() * rows_per_garbled > rows) {
      for (const CsvRow& row : garbled_) read_cells(row);
      return;
    }
    if (garbled_.empty()) return;
    DataNote note{NoteKind::passed_over,
                  fmt::format("{} of {} rows are no samples (words, or cells that are missing, cut "
                              "or joined): they are left out",
                              garbled_.size(), rows)};
    for (const CsvRow& row : garbled_) note.lines.push_back(row.line);
    series_.notes.push_back(std::move(note));
  }

  LoggedSeries finish() {
    series_.file = csv_.name();
    series_.has_runs = find_column(columns_, DataRole::run).has_value();
    series_.has_routings = find_column(columns_, DataRole::routing).has_value();
    series_.has_held = find_column(columns_, DataRole::held).has_value();
    set_labels();
    for (std::size_t i = 0; i < columns_.size(); ++i) take(i);
    for (const std::size_t line : cells_.lines_of_zeros()) {
      const auto below = std::lower_bound(series_.lines.begin(), series_.lines.end(), line);
      series_.zeroed_at.push_back(static_cast<std::size_t>(below - series_.lines.begin()));
    }
    series_.zeroed_at.erase(std::unique(series_.zeroed_at.begin(), series_.zeroed_at.end()),
                            series_.zeroed_at.end());
    cells_.note_cells(series_.notes);
    cells_.note_zeros(series_.notes);
    return std::move(series_);
  }

 private:
  struct Values {
    bool is_text = false;
    bool is_decided = false;      // for covariates
    std::vector<double> numbers;  // empty if it is text
    LogWords words;
  };

  static constexpr std::size_t most_garbled = 10'000;
  static constexpr std::size_t rows_per_garbled = 50;  // 2 %

  // A cell that is empty is none: what lacks it is told.
  bool is_garbled(const CsvRow& row) const {
    if (row.ragged) return true;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const bool is_numeric =
          is_of_numbers(columns_[i].role) || (values_[i].is_decided && !values_[i].is_text);
      const std::string_view text = trimmed(row.fields[i]);
      const bool is_time = columns_[i].role == DataRole::time && wall_time(text);
      if (is_numeric && !is_time && !has_form_of_number(text)) return true;
    }
    return false;
  }

  void read_cells(const CsvRow& row) {
    const std::optional<RowCells::Numbers> numbers = cells_.numbers(row);
    if (!numbers) return;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const DataRole role = columns_[i].role;
      if (role == DataRole::time) require_time(row, i);
      if (role == DataRole::covariate) {
        read_covariate(row, i);
      } else if (is_label(role)) {
        values_[i].words.add(label(row, i));
      } else if (is_of_numbers(role)) {
        values_[i].numbers.push_back((*numbers)[i].value_or(missing));
      }
    }
    series_.lines.push_back(row.line);
  }

  void require_time(const CsvRow& row, std::size_t column) {
    cells_.at(row, column, [](std::string_view text) {
      if (is_no_number(text)) throw InputError({.expected = "the time of the sample, a number"});
      return true;
    });
  }

  std::string_view label(const CsvRow& row, std::size_t column) {
    const auto text = cells_.at(row, column, [](std::string_view label) {
      require_short_name(label);
      return label;
    });
    return text.value_or("");
  }

  // The first cell that is not empty tells numbers from text.
  void read_covariate(const CsvRow& row, std::size_t column) {
    Values& values = values_[column];
    const std::string_view text = trimmed(row.fields[column]);
    if (!values.is_decided && !is_no_number(text)) {
      values.is_decided = true;
      values.is_text = !is_number(row, column);
      if (values.is_text) values.words.add("", series_.lines.size());
    }
    if (values.is_text) return values.words.add(text);
    const auto number =
        cells_.at(row, column, [&](std::string_view) { return cells_.covariate(row, column); });
    values.numbers.push_back(number.value_or(std::nullopt).value_or(missing));
  }

  bool is_number(const CsvRow& row, std::size_t column) {
    try {
      cells_.covariate(row, column);
      return true;
    } catch (const InputError&) {
      return false;
    }
  }

  bool parts_the_log(std::size_t column) const {
    const bool is_covariate = columns_[column].role == DataRole::covariate;
    return values_[column].is_text && (!is_covariate || values_[column].words.are_labels());
  }

  void set_labels() {
    std::vector<std::size_t> parting;  // columns
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      if (parts_the_log(i)) parting.push_back(i);
    }
    std::map<std::vector<std::uint32_t>, std::size_t> known;
    std::vector<std::uint32_t> ids(parting.size());
    for (std::size_t sample = 0; sample < series_.lines.size(); ++sample) {
      for (std::size_t k = 0; k < parting.size(); ++k) {
        ids[k] = values_[parting[k]].words.id(sample);
      }
      const auto [found, is_new] = known.emplace(ids, series_.labels.size());
      if (is_new) series_.labels.push_back(labels(sample));
      series_.label.push_back(found->second);
    }
  }

  LogLabels labels(std::size_t sample) const {
    const auto word = [&](DataRole role) {
      const auto column = find_column(columns_, role);
      return column ? values_[*column].words.word(sample) : std::string();
    };
    return {word(DataRole::run), word(DataRole::routing), word(DataRole::held),
            word(DataRole::direction)};
  }

  // A column of labels has none of these.
  void take(std::size_t column) {
    const DataColumn& of = columns_[column];
    if (of.role == DataRole::covariate) {
      if (values_[column].is_text) return note_text(column);
      cells_.require_mark(column, faults_);
    }
    LoggedSignal signal{of.meaning, std::move(values_[column].numbers), of.name};
    if (of.role == DataRole::time) series_.time_s = std::move(signal.values);
    if (of.role == DataRole::position) series_.position_mm = std::move(signal);
    if (of.role == DataRole::speed) series_.speed_mm_s = std::move(signal);
    if (of.role == DataRole::motor_tension) series_.motor_tension_N = std::move(signal);
    if (of.role == DataRole::tension) series_.tensions_N.push_back(std::move(signal));
    if (of.role == DataRole::covariate) series_.others.push_back(std::move(signal));
  }

  void note_text(std::size_t column) {
    const std::string name = for_message(columns_[column].name);
    if (parts_the_log(column)) {
      series_.notes.push_back(
          {NoteKind::covariate,
           fmt::format("column '{}' holds text: the log is cut where it changes, and readings do "
                       "not have it",
                       name)});
    } else {
      series_.notes.push_back(
          {NoteKind::passed_over,
           fmt::format("column '{}' holds times of day, or text that changes every few samples: it "
                       "is not read",
                       name)});
    }
  }

  const CsvReader& csv_;
  const std::vector<DataColumn>& columns_;
  FaultList& faults_;
  RowCells cells_;
  std::vector<CsvRow> garbled_;  // rows that are left out or faults, as far as they are kept
  std::vector<Values> values_;   // [column]
  LoggedSeries series_;
};

LoggedSeries read(CsvReader csv, const ReadingOptions& options) {
  FaultList faults;
  const Beginning beginning = read_beginning(csv, options, faults);
  DataColumns columns = read_log_columns(csv, beginning, options, faults);
  LogReader rows(csv, columns.columns, faults);
  each_row(csv, beginning, faults, [&](const CsvRow& row) { rows.read(row); });
  rows.settle_garbled();
  faults.throw_any(csv.name());
  LoggedSeries series = rows.finish();
  require_rows(csv, series.lines.size(), series.notes);
  std::move(series.notes.begin(), series.notes.end(), std::back_inserter(columns.notes));
  series.notes = std::move(columns.notes);
  for (const CsvComment& comment : csv.comments()) {
    series.simulated |= says_simulated(comment.text);
    if (comment.line < csv.header().line) series.comments.push_back(comment.text);
  }
  check_clock(series, columns.columns[*find_column(columns.columns, DataRole::time)], options);
  return series;
}

}  // namespace

std::vector<const LoggedSignal*> LoggedSeries::sensors() const {
  std::vector<const LoggedSignal*> all;
  if (motor_tension_N.is_logged()) all.push_back(&motor_tension_N);
  for (const LoggedSignal& tension : tensions_N) all.push_back(&tension);
  return all;
}

LoggedSeries read_logged_series(const std::filesystem::path& path, const ReadingOptions& options) {
  return read(CsvReader::open(path), options);
}

LoggedSeries parse_logged_series(std::string text, const std::string& name,
                                 const ReadingOptions& options) {
  return read(CsvReader(std::move(text), name), options);
}

}  // namespace reeve::readings
