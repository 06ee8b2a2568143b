#include "causes/named_law.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "causes/term.hpp"
#include "tests/support/input_error.hpp"
#include "tests/support/planned.hpp"

namespace reeve::testing {
namespace {

class NamedLaws : public ::testing::Test {
 protected:
  NamedLaws() : plan_(plan_of({"M-1-T-2-F", "M-1-P-2-M"})) {
    plan_.speed_mm_s = PlannedLevels{{}, {5, 50, 20}};
    plan_.columns = {{"humidity_pct", {{20, 80}, {}}}, {"a, b", {{1, 2}, {}}}};
    plan_.runs = 12;
  }

  Effect effect(const std::string& name, const std::vector<Setting>& settings) const {
    return effect_of({name, settings}, survey(plan_), {});
  }
  Term term(const std::string& name, std::vector<Setting> settings = {}) const {
    settings.push_back({"a", "0"});
    return *term_of(*effect(name, settings).cause);
  }
  std::string error(const std::string& name, const std::vector<Setting>& settings) const {
    return input_error([&] { effect(name, settings); });
  }

  ExperimentPlan plan_;
};

TEST_F(NamedLaws, AreReadFromWhatEffectNameSays) {
  for (const char* name :
       {"law[exponent of sheath, humidity_pct, linear]", "law[gain of T3]",
        "law[force of motor, speed_mm_s, log]", "law[exponent of tube of finger 1, load, power]",
        "law[offset of all channels, T2, hinge]", "law[exponent of tube 2 of M-1-T-2-F]",
        "law[offset of T1 in run 12, order, sine]", "law[exponent of sheath, a, b, linear]",
        "law[offset of T1, load x speed_mm_s, product]", "law[exponent of bearing, run, step]",
        "law[exponent of tube of held fingers, motor_tension_N, exponential]"}) {
    EXPECT_EQ(effect_name(effect(name, {{"a", "0.01"}})), name);
  }
}

TEST_F(NamedLaws, HaveMiddleAndRangeOfTheExperimentUnlessTheyAreSet) {
  Covariate x = term("law[exponent of sheath, humidity_pct, linear]").x;
  EXPECT_EQ(x.column, "humidity_pct");
  EXPECT_EQ(x.middle, 50);
  EXPECT_EQ(x.seen.low, 20);
  EXPECT_EQ(x.seen.high, 80);
  x = term("law[exponent of sheath, speed_mm_s, log]").x;
  EXPECT_EQ(x.kind, CovariateKind::speed);
  EXPECT_EQ(x.seen.low, 5);
  EXPECT_EQ(x.seen.high, 50);
  x = term("law[exponent of sheath, load, log]").x;
  EXPECT_EQ(x.kind, CovariateKind::load);
  EXPECT_EQ(x.seen.low, 0.6);
  EXPECT_EQ(x.seen.high, 60);
  x = term("law[offset of T1, run, step]").x;
  EXPECT_EQ(x.seen.low, 1);
  EXPECT_EQ(x.seen.high, 12);
  x = term("law[exponent of sheath, humidity_pct, linear]", {{"middle", "40"}, {"range", "30:60"}})
          .x;
  EXPECT_EQ(x.middle, 40);
  EXPECT_EQ(x.seen.low, 30);
  EXPECT_EQ(x.seen.high, 60);
}

TEST_F(NamedLaws, OfAProductHaveTwoOfEach) {
  const Term two =
      term("law[exponent of sheath, humidity_pct x load, product]",
           {{"middle", "40,10"}, {"range", "30:60,2:50"}, {"logarithmic", "false,true"}});
  EXPECT_EQ(two.x.middle, 40);
  EXPECT_EQ(two.y.middle, 10);
  EXPECT_EQ(two.x.seen.high, 60);
  EXPECT_EQ(two.y.seen.low, 2);
  EXPECT_FALSE(two.x.logarithmic);
  EXPECT_TRUE(two.y.logarithmic);
}

TEST_F(NamedLaws, HaveAllOfTheirParametersOrTheMiddleOfTheirRanges) {
  const Effect hinge =
      effect("law[exponent of sheath, humidity_pct, hinge]", {{"a", "0.01"}, {"b", "45"}});
  EXPECT_EQ(hinge.values, (std::vector<double>{0.01, 45}));
  EXPECT_EQ(effect("law[exponent of sheath, humidity_pct, hinge]", {{"a", "0.01"}}).values,
            (std::vector<double>{0.01, 40}));  // of orders of magnitude
}

// What a file of simulated readings says of a hidden law hides it again.
TEST_F(NamedLaws, SayTheirSizeAsItIsSet) {
  EXPECT_EQ(size_text(effect("law[gain of T3]", {{"a", "0.05"}}), {}), "a = 0.05");
  EXPECT_EQ(
      size_text(
          effect("law[exponent of sheath, humidity_pct, hinge]", {{"a", "0.01"}, {"b", "45"}}), {}),
      "a = 0.01, b = 45, middle = 50, range = 20:80");
  EXPECT_EQ(size_text(effect("law[exponent of sheath, humidity_pct x speed_mm_s, product]",
                             {{"a", "0.001"}, {"logarithmic", "false,true"}}),
                      {}),
            "a = 0.001, middle = 50,27.5, range = 20:80,5:50, logarithmic = false,true");
}

TEST_F(NamedLaws, ThatAreBadAreNamedWithWhatWasExpected) {
  using Settings = std::vector<Setting>;
  const auto expect = [&](const std::string& name, const Settings& settings,
                          const std::string& message) {
    const std::string found = error(name, settings);
    EXPECT_NE(found.find(message), std::string::npos) << found;
  };
  const Settings a{{"a", "0.01"}};
  expect("law[sheath]", a, "'law[sheath]': expected law[ACTS_ON of SITE, COVARIATE, FORM]");
  expect("law[", a, "expected law[ACTS_ON of SITE");
  expect("law[gain of T3, load]", a, "expected law[ACTS_ON of SITE");
  expect("law[drag of sheath]", a, "acts on 'drag'; expected one of exponent, force, gain, offset");
  expect("law[exponent of sheaths]", a, "site 'sheaths'; expected contacts, a channel");
  expect("law[gain of T9]", a, "site 'T9'; expected");
  expect("law[exponent of tube of finger 3]", a, "site 'tube of finger 3'; expected");
  expect("law[exponent of tube 9]", a, "site 'tube 9'; expected");
  expect("law[exponent of block]", a, "site 'block'; expected");
  expect("law[exponent of tube of M-1-F]", a, "routing of the experiment (M-1-T-2-F, M-1-P-2-M)");
  expect("law[exponent of tube in run 13]", a, "site 'tube in run 13'; expected");
  expect("law[exponent of tube in group B]", a, "site 'tube in group B'; expected");
  expect("law[exponent of sheath, humidity_pct, cubic]", a,
         "form 'cubic'; expected one of constant");
  expect("law[exponent of sheath, humidity, linear]", a,
         "the experiment has no covariate 'humidity'; expected load, a channel, or one of "
         "motor_tension_N, speed_mm_s, humidity_pct, a, b, order, run");
  expect("law[exponent of sheath, cycle, linear]", a, "has no covariate 'cycle'");
  expect("law[exponent of T3, humidity_pct, linear]", a,
         "site: expected contacts, which have an exponent");
  expect("law[exponent of sheath, T2, linear]", a, "covariate: expected no other channel");
  expect("law[exponent of sheath, load, product]", a, "covariate 'load': expected two of them");
  expect("law[exponent of sheath, humidity_pct, linear]", {}, "its size is missing: expected a=");
  expect("law[exponent of sheath, humidity_pct, linear]", {{"a", "9"}},
         "a = '9': expected a number");
  expect("law[exponent of sheath, humidity_pct, linear]", {{"a", "0.01"}, {"range", "80:20"}},
         "range: expected the lower end before the upper one");
  expect("law[exponent of sheath, humidity_pct, linear]", {{"a", "0.01"}, {"range", "20"}},
         "range = '20': expected the ends of a range");
  expect("law[exponent of sheath, humidity_pct, linear]", {{"a", "0.01"}, {"middle", "1,2"}},
         "middle = '1,2': expected one value");
  expect("law[exponent of sheath, humidity_pct, linear]", {{"a", "1"}, {"a", "2"}},
         "'a' is set twice");
  expect("law[exponent of sheath, humidity_pct, linear]", {{"a", "0.01"}, {"b", "2"}},
         "unknown parameter 'b'; expected a");
  expect("law[gain of T3]", {{"a", "0.01"}, {"range", "2:3"}}, "unknown parameter 'range'");
  expect("law[exponent of sheath, load x run, product]", {{"a", "0.01"}, {"logarithmic", "yes,no"}},
         "logarithmic = 'yes,no': expected true or false");
}

}  // namespace
}  // namespace reeve::testing
