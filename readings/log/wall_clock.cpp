#include "readings/log/wall_clock.hpp"

#include <algorithm>
#include <cstddef>

namespace reeve::readings {
namespace {

constexpr std::string_view all_digits = "0123456789";

bool is_number_of(std::string_view text, std::size_t most_digits) {
  return !text.empty() && text.size() <= most_digits &&
         text.find_first_not_of(all_digits) == std::string_view::npos;
}

// Three numbers of as many digits as days, months and years have, alike parted.
bool is_date(std::string_view text, char parting) {
  if (std::count(text.begin(), text.end(), parting) != 2) return false;
  const std::size_t first = text.find(parting);
  const std::size_t second = text.rfind(parting);
  return is_number_of(text.substr(0, first), 4) &&
         is_number_of(text.substr(first + 1, second - first - 1), 2) &&
         is_number_of(text.substr(second + 1), 4);
}

}  // namespace

bool is_time_of_day(std::string_view text) {
  return text.find(':') != std::string_view::npos &&
         text.find_first_not_of("0123456789:.,-/+ TZ") == std::string_view::npos;
}

bool is_date_or_time(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon != std::string_view::npos) return text.find_first_of(all_digits) < colon;
  return is_date(text, '-') || is_date(text, '.') || is_date(text, '/');
}

}  // namespace reeve::readings
