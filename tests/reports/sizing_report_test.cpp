// What is said of where a dimension stands.
#include "reports/sizing_report.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <string>
#include <vector>

#include "core/notation.hpp"
#include "reports/document/document.hpp"
#include "tests/support/has.hpp"

namespace reeve {
namespace {

// The lines of the table that begin with a dimension.
std::vector<std::string> standing(const std::string& word, const SizingOptions& options) {
  const std::string said =
      text(sizing_document(sizing_study({parse_routing(word)}, options, Catalogue{})));
  std::vector<std::string> ends;
  for (const char* dimension : {"\ncontact_angle", "\nsheath_angle", "\ntip_angle"}) {
    const std::size_t begin = said.find(dimension);
    if (begin == std::string::npos) continue;
    const std::size_t end = said.find('\n', begin + 1);
    ends.push_back(said.substr(said.rfind("  ", end) + 2, end - said.rfind("  ", end) - 2));
  }
  return ends;
}

SizingOptions asked(const std::string& goal, const std::vector<std::string>& varied) {
  SizingOptions options;
  options.grasps = parse_grasps("none", 2);
  options.goal = goal.find('=') == std::string::npos ? parse_goal(goal) : parse_target(goal, 2);
  for (const std::string& text : varied) options.varied.push_back(parse_varied(text));
  options.robust = false;
  options.starts = 1;
  options.evaluations = 100;
  options.threads = 1;
  return options;
}

// The bounds begin above the hardware's wrap, and a bar's arms share whatever comes.
TEST(SizingDocument, CallsWhatDoesNotMatterFreeAlsoAtABound) {
  EXPECT_EQ(standing("M-W1+1x-W1/2:1-2x", asked("1=2,2=1", {"sheath_angle=7..9"})),
            std::vector<std::string>{"free"});
  EXPECT_EQ(standing("M-1-T-2-F", asked("efficiency", {"sheath_angle=3..9"})),
            std::vector<std::string>{"at its lower bound"});
}

TEST(SizingDocument, DoesNotCallFreeWhatWasNotLookedAt) {
  const std::atomic<bool> at_once{true};
  const SizingReport report =
      sizing_study({parse_routing("M-1-T-2-F")}, asked("efficiency", {"sheath_angle=3..9"}),
                   Catalogue{}, {{}, &at_once});
  EXPECT_FALSE(testing::has(text(sizing_document(report)), "free"));
}

}  // namespace
}  // namespace reeve
