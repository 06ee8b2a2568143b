#include "reports/exploration/range_notes.hpp"

#include <fmt/format.h>

namespace reeve::reports {
namespace {

void add_note(const char* parts, double mu, const MuRange& range, std::vector<std::string>& notes) {
  if (range.low <= mu && mu <= range.high) return;
  notes.push_back(fmt::format(
      "the nominal friction coefficient of {}, {:.4g}, is outside its range, {:.4g} "
      "to {:.4g}, which is widened to hold it: [uncertainty] of the hardware file gives "
      "another",
      parts, mu, range.low, range.high));
}

}  // namespace

std::vector<std::string> range_notes(const Hardware& nominal, const UncertaintyRanges& ranges) {
  std::vector<std::string> notes;
  add_note("tubes", nominal.tube.mu, ranges.tube_mu, notes);
  add_note("sheaths", nominal.sheath.mu, ranges.sheath_mu, notes);
  return notes;
}

}  // namespace reeve::reports
