#include "readings/log/sparse_channels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace reeve::readings {
namespace {

// Of the readings that lack a channel which some of their samples have.
struct Sparse {
  std::size_t readings = 0;
  std::size_t samples = 0;
  std::size_t missing = 0;
  std::vector<std::size_t> lines;

  void add(const LoggedSeries& series, const LoggedSignal& signal, const SteadyReading& reading) {
    const auto at = [&](std::size_t i) {
      return signal.values.begin() + static_cast<std::ptrdiff_t>(i);
    };
    const auto none = static_cast<std::size_t>(std::count_if(
        at(reading.begin), at(reading.end), [](double value) { return std::isnan(value); }));
    const std::size_t all = reading.end - reading.begin;
    if (none == all) return;
    ++readings;
    samples += all;
    missing += none;
    lines.push_back(series.lines[reading.begin]);
  }

  DataNote note(const LoggedSignal& signal) const {
    const double share = static_cast<double>(missing) / static_cast<double>(samples);
    return {NoteKind::sparse,
            fmt::format("{} is missing in {:.0f} % of the samples of {} of the readings, which "
                        "therefore do not have it: of a sensor that is logged more seldom than "
                        "the others keep the rows that have it",
                        signal.name, 100 * share, readings),
            lines};
  }
};

}  // namespace

std::vector<DataNote> sparse_channels(const LoggedSeries& series,
                                      const std::vector<SteadyReading>& readings) {
  std::vector<DataNote> notes;
  const auto look_at = [&](const LoggedSignal& signal, const auto& mean_in) {
    if (!signal.is_logged()) return;
    Sparse sparse;
    for (const SteadyReading& reading : readings) {
      if (!mean_in(reading)) sparse.add(series, signal, reading);
    }
    if (sparse.readings > 0) notes.push_back(sparse.note(signal));
  };
  look_at(series.motor_tension_N,
          [](const SteadyReading& reading) { return reading.motor_tension_N.has_value(); });
  for (std::size_t i = 0; i < series.tensions_N.size(); ++i) {
    look_at(series.tensions_N[i],
            [i](const SteadyReading& reading) { return reading.tensions_N[i].has_value(); });
  }
  return notes;
}

}  // namespace reeve::readings
