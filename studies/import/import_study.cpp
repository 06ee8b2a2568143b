#include "studies/import/import_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "core/graph.hpp"
#include "core/network.hpp"
#include "diagnosis/data/csv.hpp"
#include "diagnosis/data/intake/column_name.hpp"
#include "diagnosis/data/intake/text_cells.hpp"

namespace reeve::studies {
namespace {

// The first sample that bears it.
std::size_t line_of_label(const LoggedSeries& series, std::size_t label) {
  const auto first = std::find(series.label.begin(), series.label.end(), label);
  return series.lines[static_cast<std::size_t>(first - series.label.begin())];
}

// Puts the place of a label before the input errors of `action`: the cell, or what was given.
template <typename Action>
auto for_label(const LoggedSeries& series, std::size_t label, const std::string& column,
               bool is_logged, const std::string& value, Action action) {
  try {
    return action();
  } catch (const InputError& error) {
    if (is_logged) {
      throw cell_error(error, series.file, line_of_label(series, label), column, value);
    }
    throw InputError(changed(error.fault(), one_line))
        .at(InputFault{.what = column, .value = for_message(value)});
  }
}

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
  require_actuated(graph(network), routing);
  return network;
}

void require_run(const std::string& text) {
  if (text.empty()) throw InputError({.expected = "a name or number for the run"});
}

// A column of tensions must be one of the routing's segments, or empty there.
void require_segments(const LoggedSeries& series, std::size_t label, const std::string& routing,
                      const Network& network) {
  for (const LoggedSignal& tension : series.tensions_N) {
    const Segment segment = column_named(tension.name)->place.segment;
    if (find_segment(network, segment)) continue;
    for (std::size_t i = 0; i < series.size(); ++i) {
      if (series.label[i] != label || std::isnan(tension.values[i])) continue;
      throw InputError({.where = fmt::format("{}:{}", series.file, series.lines[i]),
                        .what = fmt::format("column '{}': the routing '{}' has no segment {}",
                                            for_message(tension.column), for_message(routing),
                                            segment_name(segment)),
                        .expected = "an empty cell"});
    }
  }
}

void validate_labels(const LoggedSeries& series, const std::vector<LogLabels>& labels,
                     const RoutingResolver& resolve) {
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const LogLabels& label = labels[i];
    for_label(series, i, "run", series.has_runs, label.run, [&] { require_run(label.run); });
    const Network network = for_label(series, i, "routing", series.has_routings, label.routing,
                                      [&] { return network_of(label.routing, resolve); });
    for_label(series, i, "held", series.has_held, label.held,
              [&] { read_held(label.held, network.fingers); });
    for_label(series, i, "direction", true, label.direction,
              [&] { read_direction(label.direction); });
    require_segments(series, i, label.routing, network);
  }
}

}  // namespace

ImportReport import_study(LoggedSeries series, const ImportLabels& given,
                          const SteadyOptions& options, const RoutingResolver& resolve) {
  ImportReport report;
  report.labels = filled_in(series, given);
  validate_labels(series, report.labels, resolve);
  report.steady = steady_readings(series, options);
  report.series = std::move(series);
  report.options = options;
  report.given = given;
  return report;
}

}  // namespace reeve::studies
