#include "reports/import_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "reports/data_text.hpp"
#include "reports/output/json.hpp"

namespace reeve::reports {
namespace {

const char* motion_name(MotionSource motion) {
  // In the order of MotionSource.
  constexpr std::array names{"position", "speed", "none"};
  return names.at(static_cast<std::size_t>(motion));
}

// Without the time between recordings.
double logged_seconds(const ImportReport& report) {
  const LoggedSeries& series = report.series;
  double seconds = 0;
  for (std::size_t i = 1; i < series.size(); ++i) {
    const double step = series.time_s[i] - series.time_s[i - 1];
    if (step > 0 && series.label[i] == series.label[i - 1]) seconds += step;
  }
  return seconds;
}

std::string readings_line(const ImportReport& report) {
  const std::vector<SteadyReading>& readings = report.steady.readings;
  if (readings.empty()) return "No steady reading in it.";
  const auto pulls = std::ranges::count_if(
      readings, [](const SteadyReading& r) { return r.direction == Direction::pull; });
  std::string line = fmt::format("{}: {} pulling, {} releasing", plural(readings.size(), "reading"),
                                 pulls, readings.size() - static_cast<std::size_t>(pulls));
  double least = 0;
  double greatest = 0;
  bool any = false;
  for (const SteadyReading& reading : readings) {
    if (!reading.motor_tension_N) continue;
    const double load_N = reading.motor_tension_N->mean_N;
    least = any ? std::min(least, load_N) : load_N;
    greatest = any ? std::max(greatest, load_N) : load_N;
    any = true;
  }
  if (any) line += fmt::format("; motor tension {:.3g} to {:.3g} N", least, greatest);
  return line + ".";
}

Section samples_section(const ImportReport& report) {
  Table table{{text_column("samples"), number_column("count"), number_column("share")}, {}};
  const std::vector<std::size_t> counts = count_uses(report.steady.uses);
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == 0 && i > 0) continue;
    table.add(
        {sample_use_words(all_sample_uses[i]), std::to_string(counts[i]),
         percent(static_cast<double>(counts[i]) / static_cast<double>(report.series.size()))});
  }
  return {"What became of the samples", table, {}};
}

// On the log, then on what was made of it.
std::vector<DataNote> all_import_notes(const ImportReport& report) {
  std::vector<DataNote> notes = report.series.notes;
  append(notes, report.steady.notes);
  return notes;
}

Json tension_json(const std::optional<AveragedTension>& tension) {
  return value_or_null(tension, [](const AveragedTension& value) {
    return Json{{"mean_N", number(value.mean_N)}, {"deviation_N", number(value.deviation_N)}};
  });
}

Json reading_json(const ImportReport& report, const SteadyReading& reading) {
  const LoggedSeries& series = report.series;
  const LogLabels& label = report.labels[reading.label];
  Json json{{"run", label.run},
            {"routing", label.routing},
            {"held", label.held},
            {"direction", direction_field(reading.direction)},
            {"time_s", number(reading.time_s)},
            {"lines", {series.lines[reading.begin], series.lines[reading.end - 1]}},
            {"samples", reading.samples},
            {"readings", reading.readings},
            {"speed_mm_s", value_or_null(reading.speed_mm_s, number)},
            {"motor_tension", tension_json(reading.motor_tension_N)}};
  json["tensions"] = Json::object();
  for (std::size_t i = 0; i < series.tensions_N.size(); ++i) {
    json["tensions"][tension_words(series.tensions_N[i])] = tension_json(reading.tensions_N[i]);
  }
  json["others"] = Json::object();
  for (std::size_t i = 0; i < series.others.size(); ++i) {
    json["others"][series.others[i].name] = value_or_null(reading.others[i], number);
  }
  return json;
}

Json settings_of_import(const ImportReport& report) {
  const auto text = [](const std::string& value) { return Json(value); };
  const SteadyOptions& options = report.options;
  return {{"min_duration_s", options.min_duration_s},
          {"tolerance", options.tolerance},
          {"readings_per_stroke", options.readings_per_stroke},
          {"reverse", options.reverse},
          {"direction", value_or_null(options.direction,
                                      [](Direction way) { return Json(direction_field(way)); })},
          {"run", value_or_null(report.given.run, text)},
          {"routing", value_or_null(report.given.routing, text)},
          {"held", value_or_null(report.given.held, text)}};
}

}  // namespace

Document import_sheet(const ImportReport& report) {
  const LoggedSeries& series = report.series;
  Section opening;
  opening.lines.push_back({fmt::format("{}: {} over {:.4g} s, mostly every {:.3g} s", series.file,
                                       plural(series.size(), "sample"), logged_seconds(report),
                                       report.steady.usual_step_s)});
  if (series.simulated) opening.lines.push_back(simulated_line());
  opening.lines.push_back({readings_line(report)});
  Document document{{opening}};
  document.add(samples_section(report));
  document.add(notes_section(all_import_notes(report)));
  return document;
}

std::string import_json(const ImportReport& report) {
  const LoggedSeries& series = report.series;
  Json json{{"data",
             {{"file", series.file},
              {"simulated", series.simulated},
              {"samples", series.size()},
              {"seconds_logged", logged_seconds(report)},
              {"usual_step_s", report.steady.usual_step_s},
              {"motion", motion_name(report.steady.motion)}}}};
  json["readings"] = list_json(report.steady.readings, [&](const SteadyReading& reading) {
    return reading_json(report, reading);
  });
  const std::vector<std::size_t> counts = count_uses(report.steady.uses);
  for (std::size_t i = 0; i < counts.size(); ++i) {
    json["samples"][sample_use_name(all_sample_uses[i])] = counts[i];
  }
  json["notes"] = notes_json(all_import_notes(report));
  json["settings"] = settings_of_import(report);
  json["version"] = version_json();
  return print(json);
}

const char* sample_use_words(SampleUse use) {
  // In the order of SampleUse.
  constexpr std::array names{"taken into readings",
                             "the carriage stands",
                             "the speed is not even",
                             "the tensions are not steady",
                             "not all contacts slide yet",
                             "a tension does not follow the load",
                             "no tension",
                             "pull or release unknown",
                             "a value is missing",
                             "copy of the sample before",
                             "far from all neighbours",
                             "too few samples"};
  return names.at(static_cast<std::size_t>(use));
}

std::string tension_words(const LoggedSignal& tension) {
  return tension.name.substr(0, tension.name.size() - 2);  // _N
}

std::vector<std::size_t> count_uses(const std::vector<SampleUse>& uses) {
  std::vector<std::size_t> counts(all_sample_uses.size(), 0);
  for (const SampleUse use : uses) ++counts[static_cast<std::size_t>(use)];
  return counts;
}

}  // namespace reeve::reports
