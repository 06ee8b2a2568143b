#include "tests/support/reference_comparison.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

#include "tests/support/reference_walk.hpp"

namespace reeve::testing {

namespace {

std::string names(const ReferenceContact& contact) { return contact.left + "-" + contact.right; }

std::string unlike(const std::string& what, double expected, double observed) {
  return fmt::format("{}: expected {:.17g}, observed {:.17g}", what, expected, observed);
}

std::string unlike_tensions(const ReferenceResult& expected, const ReferenceResult& observed,
                            const ComparisonTolerance& tolerance) {
  if (expected.tension.size() != observed.tension.size())
    return unlike("segments", static_cast<double>(expected.tension.size()),
                  static_cast<double>(observed.tension.size()));
  for (const auto& [segment, tension] : expected.tension) {
    const auto found = observed.tension.find(segment);
    if (found == observed.tension.end()) return segment + ": not observed";
    if (!(std::abs(found->second - tension) <= tolerance.tension * tension + tolerance.slack))
      return unlike(segment, tension, found->second);
  }
  return {};
}

// Turning a loop changes sum phi |slip| at once in either direction, so that only one turn is
// least.
bool one_turn_is_least(const reference::Tendon& tendon,
                       const std::map<ContactName, ReferenceContact>& contacts) {
  if (!tendon.loop) return true;
  double still = 0, turning = 0;
  for (std::size_t k = 0; k < tendon.kinds.size(); ++k) {
    const ReferenceContact& contact = contacts.at(tendon.sides(k));
    (contact.slip == 0 ? still : turning) +=
        contact.slip == 0 ? contact.phi : std::copysign(contact.phi, contact.slip);
  }
  return std::abs(turning) < still - 1e-9;
}

std::string unlike_slips(const std::string& word, const ReferenceResult& expected,
                         const ReferenceResult& observed, const ComparisonTolerance& tolerance) {
  std::map<ContactName, ReferenceContact> wanted, found;
  for (const auto& contact : expected.contacts) wanted[{contact.left, contact.right}] = contact;
  for (const auto& contact : observed.contacts) found[{contact.left, contact.right}] = contact;
  if (wanted.size() != found.size())
    return unlike("contacts", static_cast<double>(wanted.size()),
                  static_cast<double>(found.size()));
  for (const reference::Tendon& tendon : reference::read_tendons(word)) {
    const bool comparable = one_turn_is_least(tendon, wanted);
    for (std::size_t k = 0; k < tendon.kinds.size(); ++k) {
      const ReferenceContact& contact = wanted.at(tendon.sides(k));
      const auto other = found.find({contact.left, contact.right});
      if (other == found.end()) return names(contact) + ": not observed";
      if (other->second.kind != contact.kind)
        return names(contact) + ": expected " + contact.kind + ", observed " + other->second.kind;
      if (comparable && !(std::abs(other->second.slip - contact.slip) <=
                          tolerance.movement * (1 + std::abs(contact.slip))))
        return unlike("slip at " + names(contact), contact.slip, other->second.slip);
    }
  }
  return {};
}

std::string unlike_closings(const ReferenceResult& expected, const ReferenceResult& observed,
                            const ComparisonTolerance& tolerance) {
  for (const auto& [finger, closing] : expected.closing) {
    const auto found = observed.closing.find(finger);
    if (found == observed.closing.end()) return fmt::format("finger {}: not observed", finger);
    if (!(std::abs(found->second - closing) <= tolerance.movement * (1 + std::abs(closing))))
      return unlike(fmt::format("closing of finger {}", finger), closing, found->second);
  }
  return {};
}

}  // namespace

std::string disagreement(const std::string& word, const ReferenceResult& expected,
                         const ReferenceResult& observed, const ComparisonTolerance& tolerance) {
  if (expected.jams != observed.jams) return expected.jams ? "does not jam" : "jams";
  for (const std::string& found : {unlike_tensions(expected, observed, tolerance),
                                   unlike_slips(word, expected, observed, tolerance),
                                   unlike_closings(expected, observed, tolerance)})
    if (!found.empty()) return found;
  return {};
}

double work_on_fingers(const ReferenceResult& result) {
  double work = 0;
  for (const auto& [segment, tension] : result.tension) {
    if (segment.front() != 'T') continue;
    const int finger = (std::stoi(segment.substr(1)) + 1) / 2;
    work += tension * result.closing.at(finger);
  }
  return work;
}

}  // namespace reeve::testing
