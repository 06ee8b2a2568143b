// Experiments that must be refused: what is wrong with the plan, the hidden causes, the file.
#include <gtest/gtest.h>

#include <string>

#include "tests/cli/bad_line.hpp"

namespace reeve::testing {
namespace {

TEST(BadPlan, IsNamedWithOptionAndValue) {
  const std::string levels = "expected a range such as 5:60, or a list such as 5,10,20, of numbers";
  expect_all_bad({
      {"simulate", "--routings is required"},
      {"simulate --routings TR1,TR9", "--routings: routing 'TR9': no such name in the"},
      {"simulate --routings TR1,", "--routings: routing '': the word is empty"},
      {"simulate --routings F-1-F", "the tendon with T1 is not actuated"},
      {"simulate --routings TR5,M-1-P-2-M", "'M-1-P-2-M' is given twice"},
      {"simulate --routings TR1,TR5,TR7 --runs 0", "--runs: Value 0 not in range 1 to 1000000"},
      {"simulate --routings TR1,TR5,TR7 --runs -1", "--runs: Value -1 not in range 1 to 1000000"},
      {"simulate --routings TR1,TR5,TR7 --runs 2",
       "--runs = 2: expected at least 3, one for each routing"},
      {"simulate --routings TR1,TR5,TR7 --runs 1000 --rows 1000 --repeats 2",
       "--runs = 1000, of 1000 rows and 2 repeats: expected 1000000 readings at most"},
      {"simulate --routings TR1,TR5,TR7 --rows 0", "--rows: Value 0 not in range 1 to 1000000"},
      {"simulate --routings TR1,TR5,TR7 --repeats 1.5",
       "--repeats: Value '1.5': expected a whole number"},
      {"simulate --routings TR1,TR5,TR7 --grasps 3",
       "--grasps '3': '3': expected none, or finger numbers from 1 to 2"},
      {"simulate --routings TR1,TR5,TR7 --grasps none/none",
       "--grasps 'none/none': 'none' is given twice"},
      {"simulate --routings TR1,TR5,TR7 --grasps none:2/1",
       "--grasps 'none:2/1': every grasp is measured equally"},
      {"simulate --routings TR1,TR5,TR7 --directions up",
       "--directions 'up': 'up': expected pull, release, or"},
      {"simulate --routings TR1,TR5,TR7 --directions pull,pull",
       "--directions 'pull,pull': 'pull': expected pull,"},
      {"simulate --routings TR1,TR5,TR7 --channels T9",
       "--channels: 'T9': no routing has that segment"},
      {"simulate --routings TR1,TR5,TR7 --channels t1",
       "--channels 't1': 't1': expected strands, all, or a list"},
      {"simulate --routings TR1,TR5,TR7 --channels T1,T1",
       "--channels 'T1,T1': 'T1' is given twice"},
      {"simulate --routings TR1,TR5,TR7 --channels d",
       "--channels: none of them is a segment of TR1: expected at"},
      {"simulate --routings M-F", "--channels: none of them is a segment of M-F"},
      {"simulate --routings TR1,TR5,TR7 --motor-tension 60:5",
       "--motor-tension '60:5': expected the lower end of the range first"},
      {"simulate --routings TR1,TR5,TR7 --motor-tension ''", "--motor-tension '': '': " + levels},
      {"simulate --routings TR1,TR5,TR7 --motor-tension 5:60:70", "'60:70': " + levels},
      {"simulate --routings TR1,TR5,TR7 --motor-tension 5,nan",
       "--motor-tension '5,nan': 'nan': " + levels},
      {"simulate --routings TR1,TR5,TR7 --motor-tension -1:5",
       "'-1': " + levels + " from 0 to 1000000"},
      {"simulate --routings TR1,TR5,TR7 --speed 0:100",
       "--speed '0:100': '0': " + levels + " from 0.001 to 1000000"},
      {"simulate --routings TR1,TR5,TR7 --speed 100:1", "--speed '100:1': expected the lower end"},
      {"simulate --routings TR1,TR5,TR7 --cycles 100,10", "--cycles: expected a list that rises"},
      {"simulate --routings TR1,TR5,TR7 --cycles inf", "--cycles 'inf': 'inf': " + levels},
      {"simulate --routings TR1,TR5,TR7 --sheath-angle 101", "'101': " + levels + " from 0 to 100"},
      {"simulate --routings TR1,TR5,TR7 --temperature -300",
       "'-300': " + levels + " from -273.15 to 10000"},
      {"simulate --routings TR1,TR5,TR7 --noise-relative -0.02",
       "--noise-relative '-0.02': expected a number from 0 to 1"},
      {"simulate --routings TR1,TR5,TR7 --noise-absolute nan",
       "--noise-absolute 'nan': expected a number from 0 to 1000"},
      {"simulate --routings TR1,TR5,TR7 --seed -1", "--seed"},
      {"simulate --routings TR1,TR5,TR7 --hardware negative.toml",
       "negative.toml:2:6: tube.mu = -0.1"},
      {"simulate --routings TR1,TR5,TR7 --hardware contact.toml",
       "contact.toml:1:10: hardware: contact 'a-T9'"},
      {"simulate --routings TR1 --column humidity_pct",
       "--column 'humidity_pct': expected a name that means nothing else and its values, such as "
       "humidity_pct=20:80"},
      {"simulate --routings TR1 --column =2:3", "--column '=2:3': expected a name"},
      {"simulate --routings TR1 --column speed_mm_s=2:3", "'speed_mm_s=2:3': expected a name"},
      {"simulate --routings TR1 --run-column T1_N=2:3", "--run-column 'T1_N=2:3': expected a name"},
      {"simulate --routings TR1 --run-column x=2:a", "--run-column '2:a': 'a': " + levels},
      {"simulate --routings TR1 --column x=2:3 --run-column x=4",
       "--run-column 'x=4': it is given twice"},
      {{"simulate", "--routings", "TR1", "--column", "x=1:2", "--run-column", " x =1:2"},
       "--run-column ' x =1:2': it is given twice"},
      {{"simulate", "--routings", "TR1", "--column", std::string(201, 'x') + "=1:2"},
       "x=1:2': expected a name of at most 200 bytes, and it has 201"},
      {{"simulate", "--routings", "TR1", "--column", "F\xFChrung=1:2"},
       "--column 'F?hrung=1:2': expected a name in UTF-8"},
      {"simulate --routings TR1 --model cause.toml", "cause.toml:"},
      {{"simulate", "--routings", "TR1", "--cause", "law[exponent of tube in release]", "--set",
        "a=0.3"},
       "--cause 'law[exponent of tube in release]': it changes no tension of the experiment: "
       "expected a site, grasps and --directions in which it acts"},
      {"simulate --routings TR1 --cause law[sheath] --set a=1",
       "--cause 'law[sheath]': expected law[ACTS_ON of SITE, COVARIATE, FORM]"},
      {"simulate --routings TR1,TR5,TR7 extra", "extra"},
  });
}

TEST(BadHiddenCause, IsNamedWithWhatWasExpected) {
  expect_all_bad({
      {"simulate --routings TR1,TR5,TR7 --cause wearing",
       "--cause 'wearing': unknown cause 'wearing'; expected one"},
      {"simulate --routings TR1,TR5,TR7 --cause ''",
       "--cause '': unknown cause ''; expected one of tube_friction, "},
      {"simulate --routings TR1,TR5,TR7 --cause sensor_gain[T9] --set gain=1.1",
       "--cause 'sensor_gain[T9]': this experiment has no such thing; expected "
       "sensor_gain[T1], sensor_gain[T2], sensor_gain[T3], sensor_gain[T4]"},
      {"simulate --routings TR1,TR5,TR7 --cause sensor_gain[T3 --set gain=1.1",
       "has no such thing; expected"},
      {"simulate --routings TR1,TR5,TR7 --cause seized_contact[TR2,T1-T2]",
       "has no such thing; expected"},
      {"simulate --routings TR1,TR5,TR7 --cause wear --set change=1",
       "--cause 'wear': it depends on the cycle: expected --cycles"},
      {"simulate --routings TR1,TR5,TR7 --cause speed_dependent_friction --set slope=0.1",
       "it depends on the speed: expected --speed"},
      {"simulate --routings TR1,TR5,TR7 --cause temperature",
       "it depends on the temperature: expected --temperature"},
      {"simulate --routings TR1,TR5,TR7 --cause hysteresis --directions pull",
       "pulling and releasing differ by it: expected --directions pull,release"},
      {"simulate --routings TR1,TR5,TR7 --cause load_dependent_friction",
       "its size is missing: expected exponent=VALUE, from -0.3 to 0.7"},
      {"simulate --routings TR1,TR5,TR7 --cause load_dependent_friction --set gamma=0.1",
       "unknown parameter 'gamma'; expected exponent"},
      {"simulate --routings TR1,TR5,TR7 --cause load_dependent_friction --set exponent=7",
       "exponent = '7': expected a number from -0.3 to 0.7"},
      {"simulate --routings TR1,TR5,TR7 --cause load_dependent_friction --set exponent",
       "--set 'exponent': expected a parameter and its value, such as gain=1.08"},
      {"simulate --routings TR1,TR5,TR7 --set exponent=0.1",
       "--set 'exponent=0.1': expected a --cause before it"},
      {"simulate --routings TR1,TR5,TR7 --cause seized_contact[TR5,T1-T2] "
       "--cause seized_contact[TR5,T1-T2]",
       "--cause 'seized_contact[M-1-P-2-M,T1-T2]': it is given twice"},
  });
}

TEST(BadPower, IsNamedWithWhatWasExpected) {
  expect_all_bad({
      {"simulate --routings TR1,TR5,TR7 --power 0", "--power: Value 0 not in range 1 to 100000"},
      {"simulate --routings TR1,TR5,TR7 --power 2 -o a.csv", "--output excludes --power"},
      {"simulate --routings TR1,TR5,TR7 --format json", "--format requires --power"},
      {"simulate --routings TR1,TR5,TR7 --power 2 --format csv",
       "--format: csv not in {table,json,markdown,latex}"},
  });
}

TEST(BadOutput, IsNamedAndLeavesNothing) {
  expect_all_bad({
      {"simulate --routings TR1,TR5,TR7 -o missing/a.csv",
       "file 'missing/a.csv' cannot be written: "},
      {"simulate --routings TR1,TR5,TR7 -o no_catalog", "file 'no_catalog' cannot be written: "},
      {"simulate --routings TR1,TR5,TR7 -o ''", "-o '': expected a file"},
  });
}

}  // namespace
}  // namespace reeve::testing
