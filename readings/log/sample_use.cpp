#include "readings/log/sample_use.hpp"

namespace reeve::readings {

const char* sample_use_name(SampleUse use) {
  switch (use) {
    case SampleUse::taken:
      return "taken";
    case SampleUse::standstill:
      return "standstill";
    case SampleUse::speed_varies:
      return "speed_varies";
    case SampleUse::load_varies:
      return "load_varies";
    case SampleUse::settling:
      return "settling";
    case SampleUse::not_following:
      return "not_following";
    case SampleUse::slack:
      return "slack";
    case SampleUse::no_direction:
      return "no_direction";
    case SampleUse::incomplete:
      return "incomplete";
    case SampleUse::copy:
      return "copy";
    case SampleUse::spike:
      return "spike";
    case SampleUse::too_few:
      return "too_few";
  }
  return "";
}

}  // namespace reeve::readings
