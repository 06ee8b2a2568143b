// Residuals that are written down, not computed: noise of standard deviation 1, and on top of it
// whatever a test is about.
#include "diagnosis/verdict/structure.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "numerics/random.hpp"
#include "tests/diagnosis/read_dataset.hpp"

namespace reeve::testing {
namespace {

struct Setting {
  MeasuredData data;
  Dataset dataset;
  Problem problem;
  Forecast at;
  Projection projection;

  // Readings are of no account here: the nominal model's are what residuals are relative to.
  explicit Setting(const std::string& csv)
      : data(read_data(csv)),
        dataset(all_of(data)),
        problem(reeve::problem(dataset, Eigen::VectorXd::Constant(cells(), 0.05))),
        at(forecast(dataset, {})),
        projection(problem, {}, at) {}
  Setting(const Setting&) = delete;
  Setting& operator=(const Setting&) = delete;

  Eigen::Index cells() const { return static_cast<Eigen::Index>(dataset.cells.size()); }

  std::vector<StructureTest> tests() const { return structure_tests(problem, at, projection); }

  StructureResult found(const Eigen::VectorXd& left) const {
    const NullModel null_model(problem, projection, at, 7, 199);
    Workers workers(1);
    return find_structure(problem, tests(), left, null_model, workers);
  }

  Eigen::VectorXd residuals(const std::function<double(const Cell&, const Reading&)>& extra,
                            std::uint64_t seed = 1) const {
    Eigen::VectorXd result(cells());
    for (Eigen::Index i = 0; i < cells(); ++i) {
      const Cell& cell = dataset.cells[static_cast<std::size_t>(i)];
      result[i] = normal(seed, 0x57, static_cast<std::uint64_t>(i)) +
                  extra(cell, data.readings[cell.reading]);
    }
    return result;
  }
};

constexpr double surely = 1.0 / 200;  // no replicate is as far

const StructureTest* test_about(const std::vector<StructureTest>& tests, const std::string& about) {
  const auto found = std::find_if(tests.begin(), tests.end(),
                                  [&](const StructureTest& test) { return test.about == about; });
  return found == tests.end() ? nullptr : &*found;
}

// `row(i)` gives "routing,held,direction,motor_tension_N", and T1, T2 follow.
std::string two_strands(int rows, const std::function<std::string(int)>& row) {
  std::string csv = "run,routing,held,direction,motor_tension_N,T1_N,T2_N\n";
  for (int i = 0; i < rows; ++i) csv += fmt::format("r,{},3,2\n", row(i));
  return csv;
}

std::string at_loads(int i) { return fmt::format("{}", 10 + 7 * (i % 5)); }

TEST(Structure, OfNoiseIsNone) {
  const Setting setting(two_strands(40, [](int i) {
    return fmt::format("M-1-T-2-F,{},pull,{}", i % 2 == 0 ? "1" : "2", at_loads(i));
  }));
  int alarms = 0;
  constexpr int sets = 60;
  for (std::uint64_t seed = 1; seed <= sets; ++seed) {
    const auto noise = setting.residuals([](const Cell&, const Reading&) { return 0.0; }, seed);
    alarms += setting.found(noise).p_value <= 0.2 ? 1 : 0;
  }
  EXPECT_NEAR(alarms, 0.2 * sets, 3 * std::sqrt(0.2 * 0.8 * sets));
}

// Where the scales of rows are free, what all readings of a row do together is no pattern.
TEST(Structure, IgnoresWhatFreeScalesAbsorb) {
  std::string csv = "run,routing,held,T1_N,T2_N,T3_N,T4_N\n";
  for (int i = 0; i < 30; ++i) csv += fmt::format("r,1-P-2-P-1,{},3,2,4,5\n", 1 + i % 2);
  const Setting setting(csv);
  const auto tests = setting.tests();
  for (const StructureTest& test : tests) {
    for (Eigen::Index c = 0; c < test.patterns.cols(); ++c) {
      Eigen::VectorXd beside = test.patterns.col(c);
      take_out_scales(setting.problem, setting.at, beside);
      EXPECT_LT((beside - test.patterns.col(c)).norm(), 1e-9) << test.about << ' ' << c;
    }
  }
  const StructureTest* order = test_about(tests, "order of the rows");
  ASSERT_NE(order, nullptr);
  EXPECT_EQ(order->patterns.norm(), 0);
}

// One grasp both ways: that pulling reads more and releasing less follows the grasp's direction.
TEST(Structure, TellsPullingFromReleasing) {
  const Setting setting(two_strands(40, [](int i) {
    return fmt::format("M-1-T-2-F,1,{},{}", i % 2 == 0 ? "pull" : "release", at_loads(i / 2));
  }));
  ASSERT_NE(test_about(setting.tests(), "grasp"), nullptr);
  const StructureResult result = setting.found(setting.residuals(
      [](const Cell&, const Reading& r) { return r.direction == Direction::pull ? 1.0 : -1.0; }));
  const auto grasp = std::find_if(result.findings.begin(), result.findings.end(),
                                  [](const auto& finding) { return finding.about == "grasp"; });
  ASSERT_NE(grasp, result.findings.end());
  EXPECT_DOUBLE_EQ(grasp->p_value, surely);
  EXPECT_DOUBLE_EQ(result.p_value, surely);
}

TEST(Structure, FollowsTheStrandsTheRoutingsAndTheGrasps) {
  const Setting setting(two_strands(48, [](int i) {
    return fmt::format("{},{},pull,{}", i % 2 == 0 ? "M-1-T-2-F" : "M-1-P-2-M",
                       i % 4 < 2 ? "1" : "2", at_loads(i / 4));
  }));
  const std::vector<std::pair<std::string, std::function<double(const Cell&, const Reading&)>>>
      cases{{"strand", [](const Cell& cell, const Reading&) { return cell.channel == 0 ? 2 : -2; }},
            {"routing", [](const Cell&, const Reading& r) { return r.routing == 0 ? 2 : -2; }},
            {"grasp", [](const Cell&, const Reading& r) { return r.grasp.holds(1) ? 2 : -2; }}};
  for (const auto& [about, extra] : cases) {
    const StructureResult result = setting.found(setting.residuals(extra));
    EXPECT_EQ(result.findings.front().about, about);
    EXPECT_DOUBLE_EQ(result.p_value, surely);
  }
}

TEST(Structure, IsNotSoughtInGroupsThatDoNotExist) {
  const Setting setting(two_strands(40, [](int i) { return "M-1-T-2-F,1,pull," + at_loads(i); }));
  const auto tests = setting.tests();
  EXPECT_EQ(test_about(tests, "routing"), nullptr);
  EXPECT_EQ(test_about(tests, "grasp"), nullptr);
  EXPECT_NE(test_about(tests, "strand"), nullptr);
}

// Eight fingers, each grasp three times: 16 groups a grasp.
std::string many_grasps(int grasps) {
  std::string csv = "run,routing,held,motor_tension_N";
  std::string values;
  for (int strand = 1; strand <= 16; ++strand) {
    csv += fmt::format(",T{}_N", strand);
    values += ",1";
  }
  csv += '\n';
  for (int row = 0; row < 3 * grasps; ++row) {
    const int g = row % grasps;
    csv += fmt::format("r,M-1-T-2-T-3-T-4-T-5-T-6-T-7-T-8-F,{},{}{}\n",
                       g < 8 ? std::to_string(g + 1) : fmt::format("1;{}", g - 6),
                       10 + 5 * (row / grasps), values);
  }
  return csv;
}

TEST(Structure, IsLookedForInAtMost200Groups) {
  const std::string about = "routing, grasp and strand";
  const auto twelve = Setting(many_grasps(12)).tests();
  ASSERT_NE(test_about(twelve, about), nullptr);
  EXPECT_EQ(test_about(Setting(many_grasps(13)).tests(), about), nullptr);
  // 192 groups are told apart by one number each; 12 grasps by two.
  EXPECT_LE(test_about(twelve, about)->patterns.cols(), 192);
  EXPECT_EQ(test_about(twelve, "grasp")->patterns.cols(), 24);
  EXPECT_EQ(test_about(Setting(many_grasps(13)).tests(), "grasp")->patterns.cols(), 13);
}

TEST(Structure, PatternsAreOrthonormalPairByPair) {
  const Setting setting(
      two_strands(9, [](int i) { return "M-1-T-2-F,1,pull," + at_loads(i * i); }));
  for (const StructureTest& test : setting.tests()) {
    const Eigen::Index step = test.scan ? 2 : test.patterns.cols();
    for (Eigen::Index c = 0; c < test.patterns.cols(); c += step) {
      const Eigen::MatrixXd part = test.patterns.middleCols(c, step);
      const Eigen::MatrixXd gram = part.transpose() * part;
      EXPECT_TRUE(gram.isApprox(Eigen::MatrixXd::Identity(step, step), 1e-9)) << test.about;
    }
  }
}

TEST(Structure, FollowsTheOrderOfEightRowsOrMore) {
  const auto rows = [](int count) {
    return Setting(two_strands(count, [](int i) { return "M-1-T-2-F,1,pull," + at_loads(i); }))
        .tests();
  };
  EXPECT_EQ(test_about(rows(7), "order of the rows"), nullptr);
  EXPECT_NE(test_about(rows(8), "order of the rows"), nullptr);
}

TEST(Structure, FollowsDriftsAndWavesAlongTheOrderOfTheRows) {
  const Setting setting(
      two_strands(60, [](int i) { return "M-1-T-2-F,1,pull," + at_loads(7 * i % 5); }));
  for (const double turns : {0.5, 1.0, 6.0}) {
    const StructureResult result =
        setting.found(setting.residuals([&](const Cell& cell, const Reading&) {
          return 2 *
                 std::cos(2 * std::numbers::pi * turns * static_cast<double>(cell.reading) / 60);
        }));
    EXPECT_EQ(result.findings.front().about, "order of the rows") << turns;
    EXPECT_DOUBLE_EQ(result.p_value, surely);
  }
}

// From the first reading to the last: 20 of them, two strands each.
TEST(Structure, LooksForADriftAsAWaveOfHalfATurn) {
  const Setting setting(two_strands(20, [](int) { return "M-1-T-2-F,1,pull,20"; }));
  const auto tests = setting.tests();
  const StructureTest* order = test_about(tests, "order of the rows");
  ASSERT_NE(order, nullptr);
  EXPECT_EQ(order->patterns.cols(), 20);  // ten frequencies
  Eigen::VectorXd drift(40);
  for (Eigen::Index i = 0; i < 40; ++i) {
    drift[i] =
        setting.at.reading_N[i] * std::cos(std::numbers::pi * static_cast<double>(i / 2) / 20);
  }
  drift.normalize();
  EXPECT_NEAR(order->patterns.col(0).dot(drift), 1, 1e-9);
}

std::string with_conditions(int rows) {
  std::string csv =
      "run,routing,motor_tension_N,speed_mm_s,cycle,temperature_C,humidity,T1_N,T2_N\n";
  for (int i = 0; i < rows; ++i) {
    const auto level = [&](std::uint32_t stream) {
      return 0.5 + uniform(3, stream, static_cast<std::uint64_t>(i));
    };
    csv += fmt::format("r,M-1-T-2-F,{},{},{},{},{},3,2\n", 20 * level(1), 10 * level(2),
                       100 * level(3), 20 * level(4), 50 * level(5));
  }
  return csv;
}

TEST(Structure, FollowsWhatTheRowsSayOfTheirConditions) {
  const Setting setting(with_conditions(60));
  const std::vector<std::pair<std::string, std::function<double(const Reading&)>>> cases{
      // What is linear in the load, a strand by itself explains as well.
      {"load",
       [](const Reading& r) { return 5 * std::pow(std::log(*r.motor_tension_N / 20), 2) - 0.5; }},
      {"speed", [](const Reading& r) { return std::log(*r.speed_mm_s / 10); }},
      {"cycle", [](const Reading& r) { return *r.cycle / 100 - 1; }},
      {"temperature", [](const Reading& r) { return *r.temperature_C / 20 - 1; }},
      {"column 'humidity'", [](const Reading& r) { return *r.covariates[0] / 50 - 1; }}};
  for (const auto& [about, level] : cases) {
    const StructureResult result = setting.found(setting.residuals(
        [&level = level](const Cell&, const Reading& r) { return 8 * level(r); }));
    EXPECT_EQ(result.findings.front().about, about);
    EXPECT_DOUBLE_EQ(result.p_value, surely);
  }
}

// Far from the mean means many standard errors: 0.5 of 40 readings is 3.2, 1.5 of 4 is 3.
TEST(Structure, IsWhereTheMeanResidualIsFarthestInStandardErrors) {
  const Setting setting(two_strands(44, [](int i) {
    return fmt::format("M-1-T-2-F,1,{},{}", i < 40 ? "pull" : "release", at_loads(i));
  }));
  const auto where = [&](double many, double few) {
    Eigen::VectorXd left = Eigen::VectorXd::Zero(setting.cells());
    for (Eigen::Index i = 0; i < left.size(); ++i) {
      const Cell& cell = setting.dataset.cells[static_cast<std::size_t>(i)];
      const bool pull = setting.data.readings[cell.reading].direction == Direction::pull;
      if (cell.channel == 0 && pull) left[i] = many;
      if (cell.channel == 1 && !pull) left[i] = few;
    }
    return setting.found(left).where;
  };
  EXPECT_EQ(where(0.5, 1.5), "T1 of M-1-T-2-F, held 1 (reads more)");
  EXPECT_EQ(where(-0.5, 1.5), "T1 of M-1-T-2-F, held 1 (reads less)");
  EXPECT_EQ(where(0.45, 1.5), "T2 of M-1-T-2-F, held 1, release (reads more)");
  EXPECT_EQ(where(0.45, -1.5), "T2 of M-1-T-2-F, held 1, release (reads less)");
}

// On a bench no grasp is worth a word.
TEST(Structure, OnABenchNamesNoGrasp) {
  const Setting setting(
      two_strands(44, [](int i) { return fmt::format("M-1-F,,pull,{}", at_loads(i)); }));
  const Eigen::VectorXd left = Eigen::VectorXd::Constant(setting.cells(), 0.5);
  EXPECT_EQ(setting.found(left).where, "T1 of M-1-F (reads more)");
}

TEST(LeastReplicates, LetAPValueFallToHalfOfTheSmallestThreshold) {
  EXPECT_EQ(least_replicates(0.02), 400U);
  EXPECT_EQ(least_replicates(0.0005), 16000U);
  for (const double alpha : {0.5, 0.03, 0.0123, 0.0001}) {
    const auto least = static_cast<double>(least_replicates(alpha));
    EXPECT_LT(1 / (least + 1), structure_share_of_alpha * alpha / 2) << alpha;
    EXPECT_GE(1 / (least - 1), structure_share_of_alpha * alpha / 2) << alpha;
  }
}

}  // namespace
}  // namespace reeve::testing
