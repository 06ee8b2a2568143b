#include "studies/guess_study.hpp"

namespace reeve::studies {
namespace {

void add_faults(const InputError& error, std::vector<InputFault>& faults) {
  const InputFault& fault = error.fault();
  if (fault.parts.empty()) return faults.push_back(fault);
  faults.insert(faults.end(), fault.parts.begin(), fault.parts.end());
}

template <typename Action>
void collect(std::vector<InputFault>& faults, Action action) {
  try {
    action();
  } catch (const InputError& error) {
    add_faults(error, faults);
  }
}

}  // namespace

GuessReport guess_study(const std::filesystem::path& path, const ReadingOptions& options,
                        const ImportLabels& given, const RoutingResolver& resolve) {
  GuessReport report;
  report.file = path.string();
  report.given = given;
  report.guess = guess_columns(path, options);
  const auto lacks = [&](const char* meaning, bool is_given) {
    return !is_given && !report.guess.has(meaning);
  };
  report.lacks_routing = lacks("routing", given.routing.has_value());
  report.lacks_run = lacks("run", given.run.has_value());
  report.lacks_held = lacks("held", given.held.has_value());
  report.lacks_motion = lacks("position", false) && lacks("speed", false);
  report.lacks_motor_tension = lacks("motor_tension", false);
  ReadingOptions mapped = options;
  mapped.map = report.guess.map;
  collect(report.faults, [&] { report.series = read_logged_series(path, mapped); });
  if (report.series && !report.lacks_routing) {
    collect(report.faults, [&] { require_labels(*report.series, given, resolve); });
  }
  return report;
}

}  // namespace reeve::studies
