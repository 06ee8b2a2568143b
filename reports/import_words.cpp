#include "reports/import_words.hpp"

namespace reeve::reports {

const char* sample_use_words(SampleUse use) {
  switch (use) {
    case SampleUse::taken:
      return "taken into readings";
    case SampleUse::standstill:
      return "the carriage stands";
    case SampleUse::speed_varies:
      return "the speed is not even";
    case SampleUse::load_varies:
      return "the tensions are not steady";
    case SampleUse::settling:
      return "not all contacts slide yet";
    case SampleUse::not_following:
      return "a tension does not follow the load";
    case SampleUse::slack:
      return "no tension";
    case SampleUse::no_direction:
      return "pull or release unknown";
    case SampleUse::incomplete:
      return "a value is missing";
    case SampleUse::copy:
      return "copy of the sample before";
    case SampleUse::spike:
      return "far from all neighbours";
    case SampleUse::too_few:
      return "too few samples";
  }
  return "";
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
