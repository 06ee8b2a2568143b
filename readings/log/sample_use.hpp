// Use of each sample of a log: taken into a reading, or left out for one reason.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "numerics/floors.hpp"

namespace reeve::readings {

enum class SampleUse : std::uint8_t {
  taken,
  standstill,     // the carriage stands: friction is anywhere between its two limits
  speed_varies,   // it starts, stops or turns
  load_varies,    // without position and speed: between two levels
  settling,       // the contacts do not all slide yet
  not_following,  // a tension stays where the load grows or falls
  slack,          // the motor tension, or the sum of the tensions, is not above 0
  no_direction,   // pull or release: the log does not say
  incomplete,     // a value is missing that its neighbours have
  copy,           // every signal is as in the sample before, while the carriage moves
  spike,          // far from all neighbours
  too_few,        // the rest of the stretch has too few samples
};
inline constexpr std::array all_sample_uses{
    SampleUse::taken,       SampleUse::standstill,   SampleUse::speed_varies,
    SampleUse::load_varies, SampleUse::settling,     SampleUse::not_following,
    SampleUse::slack,       SampleUse::no_direction, SampleUse::incomplete,
    SampleUse::copy,        SampleUse::spike,        SampleUse::too_few};

inline const char* sample_use_name(SampleUse use) {
  constexpr std::array names{"taken",      "standstill",    "speed_varies", "load_varies",
                             "settling",   "not_following", "slack",        "no_direction",
                             "incomplete", "copy",          "spike",        "too_few"};
  static_assert(names.size() == all_sample_uses.size());
  return names[static_cast<std::size_t>(use)];
}

}  // namespace reeve::readings
