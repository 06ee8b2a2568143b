// `reeve size` with what it must refuse.
#include <gtest/gtest.h>

#include "sizing/dimension.hpp"
#include "tests/cli/bad_line.hpp"
#include "tests/support/has.hpp"

namespace reeve::testing {
namespace {

TEST(BadSizing, OfBoundsIsNamedWithWhatWasExpected) {
  expect_all_bad({
      {"size TR1",
       "size: nothing to vary; expected --vary, such as --vary sheath_angle=3..9, or "
       "[vary] in the hardware file; reeve show says what motor the hand needs as it is"},
      {"size TR1 --vary tip_angle",
       "--vary 'tip_angle': expected a dimension and its bounds, such as "
       "sheath_angle[1]=3..9"},
      {"size TR1 --vary arm_mm=4..14",
       "--vary 'arm_mm=4..14': expected a hand with it: the joints of its fingers in the hardware "
       "file (docs/hand.md)"},
      {"size TR1 --vary angle=1..2",
       "--vary 'angle=1..2': dimension 'angle': expected one of sheath_angle[1], "},
      {"size TR1 --vary tip_angle=3..3",
       "--vary 'tip_angle=3..3': tip_angle has no room between 3 and 3; expected a least "
       "and a greater value; what is to stay as it is stands in the hardware file"},
      {"size TR1 --vary tip_angle=4..1",
       "--vary 'tip_angle=4..1': tip_angle = 4..1: expected the least and the greatest"},
      {"size TR1 --vary sheath_angle[2]=1..4",
       "--vary 'sheath_angle[2]=1..4': expected dimensions of M-1-T-2-F: sheath_angle[1]"},
      {"size TR1 --vary tip_angle=1..4 --vary tip_angle=1..3",
       "--vary 'tip_angle=1..3': what --vary 'tip_angle=1..4' varies is varied again"},
      {"size TR1 --vary tip_angle=1..4 --goal motor_force",
       "--goal: motor_force needs a hand; expected the joints of its fingers, or a pull wanted "
       "of them, in the file of --hardware or --model"},
      {"size TR1 --vary tip_angle=1..4 --goal score --score closure=1",
       "--score: closure needs a hand; expected"},
      {"size TR1 --vary tip_angle=1..4 --equal sheaths",
       "--equal 'sheaths': expected dimensions that are varied"},
      {"size TR1 --vary sheath_angle=3..9 --equal sheath_angle[1,9]",
       "--equal 'sheath_angle[1,9]': expected dimensions that are varied"},
      {"size TR1 --vary tip_angle=1..4 --equal thumbs",
       "--equal 'thumbs': expected tips, sheaths, strands"},
      {"size TR1 --vary sheath_angle=1..50",
       "at the upper end of the bounds and of the uncertainty's ranges: hardware: finger.1 "
       "sheath: mu * angle = 12: expected at most 10"},
  });
}

TEST(BadTarget, OfAnExplorationIsNamedWithWhatWasExpected) {
  expect_all_bad({
      {"explore --target 1=2",
       "--target '1=2': expected a pull from 0.001 to 1000 for each of the 2 fingers once, such "
       "as 1=2,others=1"},
      {"explore --target 3=2,others=1", "--target '3=2,others=1': expected a pull from"},
      {"explore --target 1=2,others=1 --shard 1/2", "--target excludes --shard"},
  });
}

TEST(BadTables, AreNamedWithWhatWasExpected) {
  expect_all_bad({
      {"rank --catalogue --columns name,speed",
       "--columns 'name,speed': there is no column 'speed'; expected any of rank, front, name, "
       "routing, alike, uniformity_mean, "},
      {"rank --catalogue --columns ,",
       "--columns ',': expected names of columns with commas between them, any of rank, front, "},
      {"rank --catalogue --columns name,,rank",
       "--columns 'name,,rank': nothing stands before or behind a comma; expected a name of a "
       "column there, or no comma"},
      {"rank --catalogue --columns rank_median", "there is no column 'rank_median'"},
      {"explore --columns motor_force", "there is no column 'motor_force'"},
      {"rank --catalogue --format csv --columns name",
       "--columns 'name': --format csv has every column; expected --format table, markdown or "
       "latex with it"},
      {"size TR1 --vary tip_angle=1..4 --columns dimension,routing",
       "--columns 'dimension,routing': there is no column 'routing'; expected any of "
       "dimension, unit, "},
      {"size TR1 --vary tip_angle=1..4 --columns speed",
       "there is no column 'speed'; expected any of dimension, "},
      {"size TR1 --vary tip_angle=1..4 --columns sized --format latex --text-width 19mm",
       "--text-width '19mm': expected a length from 20mm to 2000mm with its unit"},
      {"rank --catalogue --columns name,efficiency_mean_p5",
       "there is no column 'efficiency_mean_p5'; expected --uncertainty, with which there is one"},
      {"rank --catalogue --columns cost", "expected --cost, with which there is one"},
      {"rank --catalogue --columns motor_force",
       "expected a hand in the hardware file, for bands also --uncertainty, "
       "with which there is one"},
      {"rank --catalogue --uncertainty --columns rank_range",
       "there is no column 'rank_range'; expected any of rank, front, name, "},
      {"rank --catalogue --text-width 88mm",
       "--text-width '88mm': expected a whole number of characters from 20 to 1000"},
      {"rank --catalogue --format json --text-width 88",
       "--text-width '88': expected --format table or latex with it"},
      {"rank --catalogue --format latex --text-width 30mm --columns name,routing,uniformity_mean",
       "--text-width '30 mm': expected "},
      {"show TR1 --cost no.toml", "no.toml"},
      {"show TR1 --cost ''", "--cost '': expected a TOML file"},
  });
}

TEST(BadSizing, OfBoundsInAFileIsNamedWithItsPlace) {
  expect_all_bad({
      {"size TR1 --hardware vary.toml",
       "vary.toml:2:1: vary: tip_angle = 4..1: expected the least and the greatest"},
      {"size TR1 --hardware vary_name.toml",
       "vary_name.toml:2:1: vary: dimension 'angle': expected one of sheath_angle[1]"},
      {"size TR1 --hardware vary_finger.toml",
       "vary_finger.toml:2:1: vary: expected dimensions of M-1-T-2-F: sheath_angle[1]"},
      {"size TR1 --hardware vary_same.toml",
       "vary_same.toml:3:10: vary: equal 'all': expected tips, sheaths, strands"},
  });
}

TEST(BadSizing, OfAGoalIsNamedWithWhatWasExpected) {
  expect_all_bad({
      {"size TR1 --vary tip_angle=1..4 --goal speed",
       "--goal 'speed': unknown objective 'speed'; expected one of "},
      {"size TR1 --vary tip_angle=1..4 --goal sheaths",
       "--goal 'sheaths': 'sheaths' is a count, which no dimension changes"},
      {"size TR1 --vary tip_angle=1..4 --goal uniformity*travel",
       "--goal 'uniformity*travel': of 'travel' lower"},
      {"size TR1 --vary tip_angle=1..4 --target 1=2",
       "--target '1=2': expected a pull from 0.001 to 1000 for each of "
       "the 2 fingers once, such as 1=2,others=1"},
      {"size TR1 --vary tip_angle=1..4 --target 1=2,2=1 --goal uniformity", "excludes"},
      {"size TR1 --vary tip_angle=1..4 --grasps 3",
       "--grasps '3': '3': expected none, or finger numbers from 1 to 2"},
      {"size TR1 --vary tip_angle=1..4 --score speed",
       "--score 'speed': unknown objective 'speed'"},
      {"size TR1 --vary tip_angle=1..4 --score reliability=1",
       "--score 'reliability=1': expected --goal score with it; the goal is another"},
      {"size TR1 --vary tip_angle=1..4 --score reliability=1 --target 1=2,2=1",
       "--score 'reliability=1': expected --goal score with it; the goal is another"},
      {"size TR1 --vary tip_angle=1..4 --draws 0", "--draws: Value 0 not in range 1 to 10000"},
      {"size TR1 --vary tip_angle=1..4 --starts 0", "--starts: Value 0 not in range 1 to 1000"},
      {"size --from '' --vary tip_angle=1..4", "--from: Value '': expected a file or folder"},
      {"size TR1 --vary tip_angle=1..4 --seed -1", "--seed: Value -1 is negative"},
      {"size TR1 --vary tip_angle=1..4 --format csv",
       "--format: csv not in {table,json,markdown,latex}"},
  });
}

TEST(BadSizing, OfRoutingsIsNamed) {
  const Arguments vary("--vary tip_angle=1..4");
  const auto line = [&](Arguments options, const std::string& message) {
    options.insert(options.begin(), "size");
    options.insert(options.end(), vary.begin(), vary.end());
    return BadLine{options, message};
  };
  expect_all_bad({
      line({},
           "size: nothing to size; expected routings, or --from with the folder of an "
           "exploration"),
      line("TR9", "routing 'TR9': no such name in the catalogue"),
      line("TR1 M-1-T-2-F", "routing 'M-1-T-2-F' is given twice"),
      line("M-1-P-2-F F-2-P-1-M", "routing 'F-2-P-1-M' is given twice, as M-1-P-2-F"),
      line("TR1 M-1-F", "routing 'M-1-F': it has 1 finger: expected as many as 'M-1-T-2-F' has: 2"),
      line("M-F", "routing 'M-F': it has no fingers, so there is nothing to size it for"),
      line("TR1 --top 3", "--top requires --from"),
      line("--from missing", "--from: missing/designs.csv: cannot be read: No such file"),
      line("--from explored",
           "--from: explored/designs.csv:3: routing 'M-1-Q', column 5: unknown token 'Q'"),
      line("--from explored --top 1",
           "--from: explored: there is no summary.json, which is written last; expected the folder "
           "of an exploration that was written to its end"),
      line("TR1 --save-hardware missing/h.toml",
           "--save-hardware 'missing/h.toml': expected a file that can be written"),
      line("TR1 --save-hardware explored",
           "--save-hardware 'explored': expected the name of a file, not a folder"),
  });
}

TEST(SizeHelp, NamesAllThatCanBeSizedOrStayEqual) {
  const std::string help = reeve("size --help").out;
  for (const QuantityRow& row : quantity_table()) {
    EXPECT_TRUE(has(help, row.name)) << row.name;
    EXPECT_TRUE(has(help, *row.plural == '\0' ? "" : std::string(" ") + row.plural + ","))
        << row.plural;
  }
}

}  // namespace
}  // namespace reeve::testing
