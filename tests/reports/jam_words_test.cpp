#include "reports/jam_words.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "core/notation.hpp"

namespace reeve {
namespace {

using reports::held_words;
using reports::jam_sentence;

// One tendon through all fingers.
Network with_fingers(int fingers) {
  std::string word = "M-";
  for (int f = 1; f <= fingers; ++f) word += std::to_string(f) + (f == fingers ? "-F" : "-T-");
  return expand(parse_routing(fingers == 0 ? "M-F" : word));
}

ObjectiveValues jamming_in(double grasps) {
  ObjectiveValues values{};
  value(values, Objective::jams_all) = grasps;
  return values;
}

TEST(JamWords, SayWhichFingersHaveToBeHeld) {
  EXPECT_EQ(held_words(hold({2})), "finger 2 is held");
  EXPECT_EQ(held_words(hold({1, 2})), "fingers 1 and 2 are both held");
  EXPECT_EQ(held_words(hold({1, 2, 4})), "fingers 1, 2 and 4 are all held");
}

TEST(JamWords, SayInHowManyGraspsItJams) {
  EXPECT_EQ(jam_sentence({}, jamming_in(0), with_fingers(3)),
            "It never jams unless all fingers are held");
  EXPECT_EQ(jam_sentence({Grasp{}}, jamming_in(7), with_fingers(3)), "It jams in every grasp");
  EXPECT_EQ(jam_sentence({hold({1, 2}), hold({3, 4})}, jamming_in(6), with_fingers(4)),
            "It jams when fingers 1 and 2 are both held, or fingers 3 and 4 are both held "
            "(6 of 15 grasps)");
}

TEST(JamWords, NameFourWaysAtMost) {
  const std::vector<Grasp> each{hold({1}), hold({2}), hold({3}), hold({4}), hold({5}), hold({6})};
  EXPECT_EQ(jam_sentence(each, jamming_in(62), with_fingers(6)),
            "It jams when finger 1 is held, or finger 2 is held, or finger 3 is held, or finger 4 "
            "is held, or in 2 more ways (62 of 63 grasps)");
  EXPECT_EQ(jam_sentence({each.begin(), each.end() - 1}, jamming_in(62), with_fingers(6)),
            "It jams when finger 1 is held, or finger 2 is held, or finger 3 is held, or finger 4 "
            "is held, or finger 5 is held (62 of 63 grasps)");
}

TEST(JamWords, SayWhereItIsNotKnown) {
  EXPECT_EQ(jam_sentence({}, jamming_in(std::numeric_limits<double>::infinity()), with_fingers(20)),
            "It has too many fingers to try in which grasps it jams");
}

TEST(JamWords, SayThatATestBenchHasNoFinger) {
  EXPECT_EQ(jam_sentence({}, jamming_in(0), with_fingers(0)),
            "It has no finger that an object could hold");
}

TEST(JamWords, InACsvAreOneField) {
  EXPECT_EQ(reports::jams_field({}), "");
  EXPECT_EQ(reports::jams_field({Grasp{}}), "none");
  EXPECT_EQ(reports::jams_field({hold({1, 2}), hold({3})}), "1;2 3");
}

TEST(JamWords, InJsonAreListsOfFingers) {
  EXPECT_EQ(reports::grasps_json({Grasp{}, hold({1, 3})}).dump(), "[[],[1,3]]");
}

}  // namespace
}  // namespace reeve
