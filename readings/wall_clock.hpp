// Times of day as the clock of a log: "09:59:58.250", behind a date or not, with AM or PM, a zone
// or neither ("2026-11-30T09:59:58Z", "30.11.2026 09:59:58", "9:59:58 PM"), and "59:58.2", which
// spreadsheets make of it.
//
// Seconds count from the beginning of the first day. What the date says hangs on the country, so it
// is not read: a day passes where its text changes, or, without one, where the time falls by more
// than half a day (of "59:58.2": an hour by half an hour). So a pause of days counts as one:
// samples on both sides of it are apart in either case. Zones and summer time are passed over.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "numerics/floors.hpp"

namespace reeve::readings {

struct WallTime {
  std::string_view date;  // as written; part of the text
  double second = 0;      // of the day or the hour
  double period_s = 0;    // of a day or an hour
};

// Returns nothing of a number, a date alone and other text.
std::optional<WallTime> wall_time(std::string_view text);

class WallClock {
 public:
  // Returns the seconds of the next sample; nothing of a number. Throws InputError where one of the
  // samples before has the other form.
  std::optional<double> read(std::string_view text);

 private:
  std::optional<double> period_s_;  // 0 of numbers; nothing before the first sample
  std::string date_;
  double passed_s_ = 0;  // the days before this one
  double last_s_ = 0;
};

}  // namespace reeve::readings
