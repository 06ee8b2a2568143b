#include "readings/log/fast_clock.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "readings/csv.hpp"
#include "readings/log/recordings.hpp"

namespace reeve::readings {
namespace {

constexpr double short_step_s = 1.0 / 5000;

// By the unit that it was read in.
std::string advice_on_unit(const DataColumn& clock, const ReadingOptions& options) {
  if (clock.unit.factor >= 1) {
    return "If it counts days, as spreadsheets do, multiply it by 86400, which makes seconds";
  }
  std::string text = "If it counts seconds, it is time_s";
  if (!options.unit_option.empty()) {
    text += fmt::format(", and {} '{}=s' says so", options.unit_option, for_message(clock.name));
  }
  return text;
}

}  // namespace

std::optional<DataNote> doubt_of_fast_clock(const LoggedSeries& series, const DataColumn& clock,
                                            const ReadingOptions& options) {
  const double step_s = usual_step(series, {{0, series.size(), 0}});
  if (!(step_s > 0) || step_s >= short_step_s) return std::nullopt;
  const auto [first, last] = std::minmax_element(series.time_s.begin(), series.time_s.end());
  return DataNote{NoteKind::clock,
                  fmt::format("by the clock '{}', in {}, samples are mostly {:.3g} s apart and the "
                              "log lasts {:.3g} s, which is fast for a carriage. {}",
                              for_message(clock.name), clock.unit.name, step_s, *last - *first,
                              advice_on_unit(clock, options)),
                  {}};
}

}  // namespace reeve::readings
