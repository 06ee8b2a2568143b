// The published result, as a result of the model: of the paper's seven routings, TR7 is first.
//
// Held for all friction coefficients of tubes and sheaths in the literature range of Teflon on
// steel, 0.05 to 0.20, at sheath angle 2 pi and bearing friction 0.001.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/notation.hpp"
#include "search/evaluate/evaluation.hpp"
#include "search/rank/ranking.hpp"
#include "tests/support/published_words.hpp"

namespace reeve {
namespace {

using testing::published_words;

const std::string& tr1() { return published_words().front(); }
const std::string& tr7() { return published_words().back(); }

std::vector<Design> evaluated(const Hardware& hardware, const GraspSet& grasps) {
  DesignEvaluator evaluator(hardware, grasps);
  std::vector<Design> designs;
  for (const std::string& word : published_words()) {
    designs.push_back({word, evaluator.evaluate(parse_routing(word))});
  }
  return designs;
}

std::vector<Hardware> friction_grid() {
  std::vector<Hardware> grid;
  for (int tube = 5; tube <= 20; ++tube) {
    for (int sheath = 5; sheath <= 20; ++sheath) {
      Hardware hardware;
      hardware.tube.mu = 0.01 * tube;
      hardware.sheath.mu = 0.01 * sheath;
      grid.push_back(hardware);
    }
  }
  return grid;
}

std::string to_text(const Hardware& hardware) {
  return "mu_t " + std::to_string(hardware.tube.mu) + ", mu_s " +
         std::to_string(hardware.sheath.mu);
}

void expect_tr7_first(const GraspSet& grasps, const std::vector<Objective>& objectives) {
  for (const Hardware& hardware : friction_grid()) {
    SCOPED_TRACE(to_text(hardware));
    const std::vector<Design> designs = evaluated(hardware, grasps);
    const Design& best = designs.back();
    for (std::size_t other = 0; other + 1 < designs.size(); ++other) {
      for (const Objective objective : objectives) {
        EXPECT_GT(value(best.values, objective), value(designs[other].values, objective))
            << designs[other].word << " " << row(objective).name;
      }
    }
    const std::vector<RankedDesign> ranked = rank(designs, objectives);
    EXPECT_EQ(ranked[0].design.word, tr7());
    EXPECT_EQ(ranked[0].front, 1);
    EXPECT_EQ(ranked[1].front, 2);
  }
}

TEST(Validation, Tr7IsFirstOnBothObjectivesInThePapersGraspAndInMeanAndWorstOverAll) {
  const std::vector<Objective> means{Objective::uniformity_mean, Objective::efficiency_mean};
  expect_tr7_first(paper_grasps(), means);
  expect_tr7_first(single_grasps(2), means);
  expect_tr7_first(single_grasps(2), {Objective::uniformity_worst, Objective::efficiency_worst});
}

// Force transmission, which some mean by efficiency, turns the order round; so it does in the mean.
void expect_tr1_first_and_tr7_last_by_force(const GraspSet& grasps) {
  for (const Hardware& hardware : friction_grid()) {
    SCOPED_TRACE(to_text(hardware));
    const std::vector<Design> designs = evaluated(hardware, grasps);
    const auto force = [](const Design& design) {
      return value(design.values, Objective::force_transmission);
    };
    for (const Design& design : designs) {
      if (design.word != tr1()) {
        EXPECT_LT(force(design), force(designs.front())) << design.word;
      }
      if (design.word != tr7()) {
        EXPECT_GT(force(design), force(designs.back())) << design.word;
      }
    }
    const std::vector<RankedDesign> ranked = rank(designs, {Objective::force_transmission});
    EXPECT_EQ(ranked.front().design.word, tr1());
    EXPECT_EQ(ranked.back().design.word, tr7());
  }
}

TEST(Validation, ByForceTransmissionAloneTr1IsFirstAndTr7Last) {
  expect_tr1_first_and_tr7_last_by_force(paper_grasps());
  expect_tr1_first_and_tr7_last_by_force(single_grasps(2));
}

}  // namespace
}  // namespace reeve
