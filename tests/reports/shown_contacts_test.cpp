#include <gtest/gtest.h>

#include <string>

#include "core/notation.hpp"
#include "reports/show_report.hpp"

namespace reeve {
namespace {

std::string contacts_of(const std::string& word) {
  const Routing routing = parse_routing(word);
  const ShownRouting shown =
      shown_routing(routing, {}, parse_grasps("none", finger_count(routing)), Direction::pull, {});
  std::string list;
  for (const ShownContact& contact : shown_contacts(shown)) {
    list += (list.empty() ? "" : ", ") + contact.between + " " + contact.kind;
  }
  return list;
}

TEST(ShownContacts, OfALoopOfTwoSegmentsHaveTwoNames) {
  EXPECT_EQ(contacts_of("M-Y1+1-Y1-1"), "a-h1 sheath, T2-T1 block, T1-T2 tube");
}

TEST(ShownContacts, HaveTheWrapAngleThatTheWordGives) {
  EXPECT_EQ(contacts_of("M-1/170-B/22.5-2-F"),
            "a-T1 sheath, T1-T2 tube 170 deg, T2-T3 bearing 22.5 deg, T3-T4 tube");
}

}  // namespace
}  // namespace reeve
