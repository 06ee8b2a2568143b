#include "readings/text_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "core/error.hpp"
#include "readings/csv_number.hpp"
#include "readings/words.hpp"

namespace reeve::readings {

Grasp read_held(std::string_view text, int fingers) {
  std::string held = lower(text);
  std::replace(held.begin(), held.end(), ';', ',');
  held.erase(std::remove(held.begin(), held.end(), ' '), held.end());
  if (is_missing(held) || held == "none") return {};
  if (fingers == 0) throw InputError({.expected = "nothing: the routing has no fingers"});
  // As core writes it: "1,2".
  if (const auto grasp = grasp_named(held, fingers)) return *grasp;
  throw InputError(
      {.expected = fmt::format("nothing (none held), or finger numbers from 1 to {}, each "
                               "once, such as {}",
                               fingers, fingers > 1 ? "1;2" : "1")});
}

std::optional<Direction> read_direction(std::string_view text) {
  const std::string direction = lower(text);
  if (is_missing(direction)) return std::nullopt;
  if (direction == "pull") return Direction::pull;
  if (direction == "release") return Direction::release;
  throw InputError({.expected = "pull, release, or an empty cell"});
}

bool says_tare(std::string_view text) { return lower(text) == "tare"; }

}  // namespace reeve::readings
