#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "studies/exploration_study.hpp"

namespace reeve {
namespace {

ListedDesign listed(const std::string& word, const std::string& same_as = "") {
  ListedDesign design;
  design.ranked.design.word = word;
  design.same_as = same_as;
  return design;
}

std::vector<std::string> words_to_sweep(const ExploreReport& report) {
  std::vector<std::string> words;
  for (const ListedDesign& design : designs_to_sweep(report)) {
    words.push_back(design.ranked.design.word);
  }
  return words;
}

// Of those that are equal to another none is swept again.
TEST(DesignsToSweep, AreTheBestTheStepsAndTheFrontEachOnce) {
  ExploreReport report;
  report.top = {listed("best"), listed("second")};
  report.tradeoff.affordable = listed("cheap");
  report.tradeoff.steps = {listed("cheap"), listed("best"), listed("step"), listed("step")};
  report.front = {listed("best"), listed("step"), listed("bearing", "best"), listed("front")};
  EXPECT_EQ(words_to_sweep(report), (std::vector<std::string>{"best", "cheap", "step", "front"}));
}

TEST(DesignsToSweep, AreAFewAlone) {
  ExploreReport report;
  for (int i = 0; i < 20; ++i) report.front.push_back(listed(std::to_string(i)));
  EXPECT_EQ(words_to_sweep(report).size(), most_swept);
}

}  // namespace
}  // namespace reeve
