// Several routings, ranked before and after, and where they come from.
#include <gtest/gtest.h>

#include <cmath>

#include "catalog/catalogue.hpp"
#include "studies/sizing_study.hpp"
#include "tests/sizing/sizing_of.hpp"
#include "tests/support/temporary_folder.hpp"

namespace reeve::testing {
namespace {

SizingReport ranked(const std::vector<std::string>& words, const SizingOptions& options) {
  std::vector<Routing> routings;
  for (const std::string& word : words) routings.push_back(parse_routing(word));
  return sizing_study(routings, options, read_catalogue(std::filesystem::path(REEVE_CATALOG_DIR)));
}

std::vector<std::string> words(const SizingReport& report) {
  std::vector<std::string> result;
  for (const SizedRouting& routing : report.designs) result.push_back(routing.word);
  return result;
}

// Once neither join bends the tendon they are equal, and the one without a bearing has fewer parts.
TEST(SizingStudy, RanksBeforeAndAfter) {
  SizingOptions options = sizing("efficiency", {"contact_angle[T2-T3]=0..9"});
  const SizingReport report = ranked({"M-1-B-2-F", "M-1-T-2-F"}, options);
  EXPECT_EQ(words(report), (std::vector<std::string>{"M-1-T-2-F", "M-1-B-2-F"}));
  EXPECT_EQ(report.designs[0].rank_after, 1U);
  EXPECT_EQ(report.designs[0].rank_before, 2U);
  EXPECT_EQ(report.designs[1].rank_before, 1U);
  EXPECT_EQ(report.designs[0].name, "TR1");
}

TEST(SizingStudy, OfATargetRanksTheLeastMissFirst) {
  const SizingReport report =
      ranked({"M-1-T-2-F", "1-P-2-P-1"}, aiming("1=1,2=1", {"sheath_angle=3..9"}));
  EXPECT_EQ(report.designs[0].word, "1-P-2-P-1");
  EXPECT_LT(report.designs[0].design.after.goal, report.designs[1].design.after.goal);
  EXPECT_TRUE(best_meets_target(report));
  EXPECT_FALSE(best_meets_target(ranked({"M-1-T-2-F"}, aiming("1=1,2=1", {"sheath_angle=3..9"}))));
}

SizingDetails details_of(const SizingOptions& options) {
  return sizing_details(ranked({"M-1-T-2-F"}, options),
                        read_catalogue(std::filesystem::path(REEVE_CATALOG_DIR)));
}

TEST(SizingDetails, AreShownInTheGraspsThatAreAskedWhateverThoseOfATarget) {
  const std::vector<std::string> varied{"sheath_angle=3..9"};
  for (SizingOptions options : {sizing("uniformity", varied), aiming("1=1,2=1", varied)}) {
    EXPECT_EQ(details_of(options).sized.grasps.size(), 3U);
    options.grasps = parse_grasps("1/2", 2);
    EXPECT_EQ(details_of(options).before.grasps.size(), 2U);
  }
  SizingOptions open = sizing("uniformity", varied);
  open.grasps = parse_grasps("none", 2);
  EXPECT_EQ(details_of(open).sized.grasps.size(), 1U);
}

// Every tension goes with e^{-0.18 θ_s}: best is the least θ_s, and 1 % is lost by ln(1/0.99)/0.18
// more of it, which lies beyond these bounds.
TEST(SizingDetails, HaveProfilesAsFarAsBoundsAndToleranceReach) {
  const SizingDetails details = details_of(sizing("efficiency", {"sheath_angle=3..3.05"}));
  ASSERT_EQ(details.profiles.size(), 1U);
  EXPECT_EQ(details.profiles[0].values.front(), 3);
  EXPECT_NEAR(details.profiles[0].values.back(), 3 - std::log(0.99) / 0.18, 1e-3);
}

class ExploredDesigns : public ::testing::Test {
 protected:
  std::vector<std::string> read(const std::string& csv, std::size_t count = 20) {
    folder_.write("designs.csv", csv);
    std::vector<std::string> result;
    for (const Routing& routing : explored_designs(folder_.path(), count)) {
      result.push_back(to_word(routing));
    }
    return result;
  }

  TemporaryFolder folder_;
};

TEST_F(ExploredDesigns, AreTheFirstInTheOrderOfTheFile) {
  const std::string csv =
      "# partial: stopped\nrank,front,routing,name,x\n1,1,1-P-2-P-1,TR7,2\n2,1,M-1-T-2-F,TR1,3\n";
  EXPECT_EQ(read(csv), (std::vector<std::string>{"1-P-2-P-1", "M-1-T-2-F"}));
  EXPECT_EQ(read(csv, 1), (std::vector<std::string>{"1-P-2-P-1"}));
}

TEST_F(ExploredDesigns, NameThePlaceOfWhatIsWrong) {
  EXPECT_EQ(folder_.error_of([&] { read("rank,word\n1,M-1-F\n"); }),
            "designs.csv: no column 'routing'; expected the designs.csv of an exploration");
  EXPECT_EQ(folder_.error_of([&] { read("rank,routing\n"); }), "designs.csv: it holds no design");
  EXPECT_EQ(folder_.error_of([&] { read("rank,routing\n1,M-1-T-2-F\n2,M-1-Q\n"); }).substr(0, 47),
            "designs.csv:3: routing 'M-1-Q', column 5: unkno");
}

}  // namespace
}  // namespace reeve::testing
