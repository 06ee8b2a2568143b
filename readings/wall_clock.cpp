#include "readings/wall_clock.hpp"

#include <cmath>
#include <cstdlib>
#include <regex>

#include "core/error.hpp"

namespace reeve::readings {
namespace {

constexpr double hour_s = 3600;
constexpr double day_s = 24 * hour_s;

double number(const std::csub_match& digits) { return std::strtod(digits.str().c_str(), nullptr); }

}  // namespace

std::optional<WallTime> wall_time(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  const std::size_t time = text.find_last_of(" T,;", colon) + 1;  // 0 where there is no date
  // Hours, minutes, seconds, their fraction, AM or PM, zone.
  static const std::regex form(R"((?:(\d{1,3}):)?([0-5]?\d):([0-5]?\d)(?:[.,:](\d+))?)"
                               R"((?: ?([AaPp])[Mm])?(?: ?(?:Z|UTC|[+-]\d\d:?\d\d))?)",
                               std::regex::optimize);
  std::cmatch found;
  if (!std::regex_match(text.data() + time, text.data() + text.size(), found, form)) {
    return std::nullopt;
  }
  const bool has_hour = found[1].matched;
  if (!has_hour && !found[4].matched) return std::nullopt;  // 12:30 may be either
  double hour = number(found[1]);
  if (found[5].matched) hour = std::fmod(hour, 12) + ((*found[5].first | ' ') == 'p' ? 12 : 0);
  const double fraction = std::strtod(("0." + found[4].str()).c_str(), nullptr);
  return WallTime{.date = text.substr(0, time),
                  .second = hour * hour_s + number(found[2]) * 60 + number(found[3]) + fraction,
                  .period_s = has_hour ? day_s : hour_s};
}

std::optional<double> WallClock::read(std::string_view text) {
  const std::optional<WallTime> time = wall_time(text);
  const double period_s = time ? time->period_s : 0;
  const bool is_first = !period_s_;
  if (period_s_.value_or(period_s) != period_s) {
    throw InputError({.expected = *period_s_ > 0 ? "a time of day, as in the samples before"
                                                 : "a number, as in the samples before"});
  }
  period_s_ = period_s;
  if (!time) return std::nullopt;
  const bool is_later = time->date.empty() && date_.empty() ? time->second < last_s_ - period_s / 2
                                                            : time->date != date_;
  if (is_later && !is_first) passed_s_ += period_s;
  date_ = time->date;
  last_s_ = time->second;
  return passed_s_ + time->second;
}

}  // namespace reeve::readings
