#include "studies/import_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/error.hpp"
#include "core/graph.hpp"
#include "core/network.hpp"
#include "core/text.hpp"
#include "readings/column_name.hpp"
#include "readings/csv.hpp"
#include "readings/fault_list.hpp"
#include "readings/rows.hpp"

namespace reeve::studies {
namespace {

// The first sample that bears it.
std::size_t line_of_label(const LoggedSeries& series, std::size_t label) {
  const auto first = std::ranges::find(series.label, label);
  return series.lines[static_cast<std::size_t>(first - series.label.begin())];
}

// Checks the labels of one stretch of the log.
class LabelCheck {
 public:
  // All must outlive it.
  LabelCheck(const LoggedSeries& series, std::size_t label, const std::string& start,
             FaultList& faults)
      : series_(series),
        label_(label),
        start_(start),
        line_(line_of_label(series, label)),
        faults_(faults) {}

  // Returns the result of the action. An input error of a logged cell goes into the list of faults;
  // one of a given label is thrown, since it holds for every stretch.
  template <typename Action>
  auto at(const std::string& column, bool is_logged, const std::string& value, Action action)
      -> std::optional<decltype(action())> {
    try {
      return action();
    } catch (const InputError& error) {
      if (!is_logged) {
        throw InputError(changed(error.fault(), one_line))
            .at(InputFault{.what = start_ + column, .value = for_message(value)});
      }
      add(line_, column, cell_error(error, series_.file, line_, column, value).fault());
      return std::nullopt;
    }
  }

  // A column of tensions must be one of the routing's segments, or empty there.
  void require_segments(const std::string& routing, const Network& network) {
    for (const LoggedSignal& tension : series_.tensions_N) {
      const Segment segment = column_named(tension.name)->place.segment;
      if (!find_segment(network, segment)) require_empty(tension, routing, segment);
    }
  }

 private:
  void require_empty(const LoggedSignal& tension, const std::string& routing,
                     const Segment& segment) {
    for (std::size_t i = 0; i < series_.size(); ++i) {
      if (series_.label[i] != label_ || std::isnan(tension.values[i])) continue;
      const std::size_t line = series_.lines[i];
      return add(line, tension.column,
                 {.where = fmt::format("{}:{}", series_.file, line),
                  .what = fmt::format("column '{}': the routing '{}' has no segment {}",
                                      for_message(tension.column), for_message(routing),
                                      segment_name(segment)),
                  .expected = "an empty cell"});
    }
  }

  void add(std::size_t line, const std::string& column, InputFault fault) {
    faults_.add(line, in_column(column), std::move(fault));
  }

  const LoggedSeries& series_;
  std::size_t label_;
  const std::string& start_;
  std::size_t line_;
  FaultList& faults_;
};

void require_no_other(const LoggedSeries& series, const std::string& column, bool is_logged,
                      const std::optional<std::string>& given) {
  if (!is_logged || !given) return;
  throw InputError({.where = series.file,
                    .what = fmt::format("the log has a column '{}', and '{}' is given too", column,
                                        for_message(*given)),
                    .expected = "one of them"});
}

std::vector<LogLabels> filled_in(const LoggedSeries& series, const ImportLabels& given) {
  require_no_other(series, "run", series.has_runs, given.run);
  require_no_other(series, "routing", series.has_routings, given.routing);
  require_no_other(series, "held", series.has_held, given.held);
  std::vector<LogLabels> labels = series.labels;
  for (LogLabels& label : labels) {
    if (!series.has_runs) label.run = given.run.value_or("1");
    if (!series.has_routings) label.routing = given.routing.value_or("");
    if (!series.has_held) label.held = given.held.value_or("");
  }
  return labels;
}

Network network_of(const std::string& routing, const RoutingResolver& resolve) {
  if (routing.empty()) {
    throw InputError({.expected = "a routing such as M-1-T-2-F, in a column of the log or given"});
  }
  Network network = expand(resolve(routing));
  require_actuated(network, routing);
  return network;
}

std::string run_of(const std::string& text) {
  if (text.empty()) throw InputError({.expected = "a name or number for the run"});
  if (says_tare(text)) {
    throw InputError({.expected = "another name: a row of that run holds the sensors' zeros"});
  }
  if (says_summary(text)) {
    throw InputError({.expected = "another name: a row of that run is a summary of others"});
  }
  return text;
}

void validate_labels(const LoggedSeries& series, const std::vector<LogLabels>& labels,
                     const std::string& start, const RoutingResolver& resolve) {
  FaultList faults;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const LogLabels& label = labels[i];
    LabelCheck check(series, i, start, faults);
    check.at("run", series.has_runs, label.run, [&] { return run_of(label.run); });
    const auto network = check.at("routing", series.has_routings, label.routing,
                                  [&] { return network_of(label.routing, resolve); });
    if (network) {
      check.at("held", series.has_held, label.held,
               [&] { return read_held(label.held, network->fingers); });
      check.require_segments(label.routing, *network);
    }
    check.at("direction", true, label.direction, [&] { return read_direction(label.direction); });
  }
  faults.throw_any(series.file);
}

// The user must not think that the tool knows which finger an object stops.
void note_held(LoggedSeries& series, const std::vector<LogLabels>& labels,
               const RoutingResolver& resolve) {
  const auto is_open = [&](const LogLabels& label) {
    return leaves_held_open(trimmed(label.held)) && network_of(label.routing, resolve).fingers > 1;
  };
  if (!std::ranges::all_of(labels, is_open)) return;
  series.notes.push_back(
      {NoteKind::assumed, held_is_assumed(series.size(), series.size(), "samples")});
}

}  // namespace

void require_labels(const LoggedSeries& series, const ImportLabels& given,
                    const RoutingResolver& resolve) {
  validate_labels(series, filled_in(series, given), given.start, resolve);
}

ImportReport import_study(LoggedSeries series, const ImportLabels& given,
                          const SteadyOptions& options, const RoutingResolver& resolve) {
  ImportReport report;
  report.labels = filled_in(series, given);
  validate_labels(series, report.labels, given.start, resolve);
  note_held(series, report.labels, resolve);
  std::set<std::string, std::less<>> directions;
  for (const LogLabels& label : report.labels) directions.insert(label.direction);
  readings::note_directions(directions, series.notes);
  report.steady = steady_readings(series, options);
  report.series = std::move(series);
  report.options = options;
  report.given = given;
  return report;
}

}  // namespace reeve::studies
