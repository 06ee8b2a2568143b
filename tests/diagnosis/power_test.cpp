#include "diagnosis/plan/power.hpp"

#include <gtest/gtest.h>

namespace reeve {
namespace {

Finding finding(Verdict verdict, const std::vector<std::string>& named,
                const std::vector<std::string>& hidden) {
  DiagnosisResult result;
  result.verdict = verdict;
  for (const std::string& name : named) result.causes.emplace_back().name = name;
  return judged(1, result, hidden).finding;
}

TEST(Power, CountsAsFoundOnlyWhatIsNamedInFullAndAlone) {
  EXPECT_EQ(finding(Verdict::cause, {"wear"}, {"wear"}), Finding::found);
  EXPECT_EQ(finding(Verdict::cause, {"b", "a"}, {"a", "b"}), Finding::found);
  EXPECT_EQ(finding(Verdict::cause, {"a"}, {"a", "b"}), Finding::wrong);
  EXPECT_EQ(finding(Verdict::cause, {"a", "b"}, {"a"}), Finding::wrong);
  EXPECT_EQ(finding(Verdict::cause, {"sensor_gain[T3]"}, {"sensor_gain[T4]"}), Finding::wrong);
}

TEST(Power, CountsSilenceAsRightOnlyWhereNothingIsHidden) {
  EXPECT_EQ(finding(Verdict::none, {}, {}), Finding::found);
  EXPECT_EQ(finding(Verdict::none, {}, {"wear"}), Finding::none);
  EXPECT_EQ(finding(Verdict::cause, {"wear"}, {}), Finding::wrong);
}

TEST(Power, KeepsVerdictsThatNameNoOneCauseApart) {
  EXPECT_EQ(finding(Verdict::unexplained, {"wear"}, {"wear"}), Finding::unexplained);
  EXPECT_EQ(finding(Verdict::indistinguishable, {"wear"}, {"wear"}), Finding::indistinguishable);
}

TEST(Power, GivesTheShareOfEachFindingWithItsInterval) {
  std::vector<PowerTrial> trials(10);
  for (std::size_t i = 0; i < 8; ++i) trials[i].finding = Finding::found;
  const std::vector<FindingShare> shares = finding_shares(trials);
  ASSERT_EQ(shares.size(), 5U);
  EXPECT_EQ(shares[0].finding, Finding::found);
  EXPECT_EQ(shares[0].count, 8U);
  EXPECT_DOUBLE_EQ(shares[0].share, 0.8);
  EXPECT_NEAR(shares[0].interval.low, 0.4439, 1e-4);
  EXPECT_NEAR(shares[0].interval.high, 0.9748, 1e-4);
  EXPECT_EQ(shares[2].count, 2U);
}

}  // namespace
}  // namespace reeve
