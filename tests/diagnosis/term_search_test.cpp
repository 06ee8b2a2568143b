// Laws beyond the library, on readings of TR1 with finger 1 held, which are written down by the
// paper's equations: each tension is the one before it times e^{-phi}. Noise and idle columns are
// drawn here.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "causes/term.hpp"
#include "core/error.hpp"
#include "diagnosis/diagnose.hpp"
#include "diagnosis/fit/evidence.hpp"
#include "diagnosis/fit/set_readings.hpp"
#include "diagnosis/search/law_forms.hpp"
#include "diagnosis/search/levers.hpp"
#include "numerics/random.hpp"
#include "tests/diagnosis/read_dataset.hpp"

namespace reeve::testing {
namespace {

constexpr double phi_sheath = 0.18 * 2 * std::numbers::pi;
constexpr double phi_tube = 0.18 * std::numbers::pi;

struct Row {
  int run = 0;
  double supply_V = 5;
  double humidity_pct = 50;
  double motor_N = 10;
};

// What a strand's sensor reads over what it should.
using Factor = std::function<double(const Row&, int strand)>;

double drawn_humidity(int, std::uint64_t drawn) { return 20 + 60 * uniform(1, 3, drawn); }

std::string readings(
    const Factor& factor, int first_run = 0,
    const std::function<double(int run, std::uint64_t drawn)>& humidity_pct = drawn_humidity) {
  std::string text = "run,routing,held,motor_tension_N,humidity_pct,supply_V,T1_N,T2_N,T3_N,T4_N\n";
  std::uint64_t drawn = 0;
  for (int run = first_run; run < first_run + 12; ++run) {
    for (const double motor_N : {8.0, 12.0, 18.0, 27.0, 35.0, 50.0}) {
      const Row row{run, 4.5 + uniform(1, 2, drawn), humidity_pct(run, drawn), motor_N};
      text += fmt::format("r{},M-1-T-2-F,1,{},{:.2f},{:.4f}", run, motor_N, row.humidity_pct,
                          row.supply_V);
      double tension_N = motor_N * std::exp(-phi_sheath);
      for (int strand = 0; strand < 4; ++strand) {
        const double read_N = tension_N * factor(row, strand) * (1 + 0.01 * normal(1, 4, drawn++));
        text += fmt::format(",{:.5f}", read_N);
        tension_N *= std::exp(-phi_tube);
      }
      text += "\n";
    }
  }
  return text;
}

DiagnosisResult diagnosed(const std::string& text, int threads = 1,
                          std::vector<Effect> terms = {}) {
  DiagnoseOptions options;
  options.terms = std::move(terms);
  options.threads = threads;
  return diagnose(read_data(text), {}, options);
}

DiagnosisResult diagnosed(const std::string& text, const Hardware& hardware) {
  return diagnose(read_data(text), {hardware}, {});
}

double as_said(const Row&, int) { return 1; }

// The gain of T3 follows the supply voltage, and is right at 5.1 V.
double as_supplied(const Row& row, int strand) {
  return strand == 2 ? 1 + 0.2 * (row.supply_V - 5.1) : 1;
}

TEST(TermSearch, FindsTheSiteTheCovariateAndTheSizeOfALaw) {
  const DiagnosisResult result = diagnosed(readings(as_supplied));
  ASSERT_EQ(result.causes.size(), 1U);
  const NamedCause& law = result.causes.front();
  const Term* term = term_of(*law.effect.cause);
  ASSERT_NE(term, nullptr);
  EXPECT_EQ(causes::site_name(term->site), "T3");
  EXPECT_EQ(term->target, causes::Target::gain);
  EXPECT_EQ(covariate_name(term->x), "supply_V");
  EXPECT_EQ(term->form, causes::Form::linear);
  EXPECT_NEAR(law.effect.values.front(), 0.2, 0.02);
  EXPECT_NEAR(term->x.middle, 5.1, 0.05);
  EXPECT_GT(*law.evidence, 100);
  EXPECT_EQ(*law.folds, 1);
  ASSERT_TRUE(result.held_out.has_value());
  EXPECT_LT(result.held_out->rms_after_N, result.held_out->rms_before_N);
}

// A tube of the fingertip rubs more and less as it turns with what the column counts.
TEST(TermSearch, FindsAWaveOfOneContact) {
  const DiagnosisResult result = diagnosed(readings([](const Row& row, int strand) {
    const double wave = 0.25 * std::sin(2 * std::numbers::pi * row.humidity_pct / 20);
    return strand < 2 ? 1 : std::exp(-phi_tube * wave);
  }));
  ASSERT_EQ(result.causes.size(), 1U);
  const NamedCause& law = result.causes.front();
  EXPECT_EQ(law.name, "law[exponent of tube 2 of M-1-T-2-F, humidity_pct, sine]");
  EXPECT_NEAR(std::hypot(law.effect.values[0], law.effect.values[1]), 0.25, 0.02);
  EXPECT_NEAR(law.effect.values[2], 20, 0.5);
}

// Tubes are as the hardware says at 30 %, and drawn at 20 to 80 %.
TEST(TermSearch, SaysWhereTheHardwareIsRightBesideALaw) {
  const DiagnosisResult result = diagnosed(readings([](const Row& row, int strand) {
    return std::exp(-phi_tube * strand * 0.01 * (row.humidity_pct - 30));
  }));
  ASSERT_EQ(result.causes.size(), 1U);
  const NamedCause& law = result.causes.front();
  EXPECT_EQ(law.name, "law[exponent of tube, humidity_pct, linear]");
  EXPECT_NEAR(law.effect.values.front(), 0.01, 0.001);
  EXPECT_NEAR(term_of(*law.effect.cause)->x.middle, 30, 1.5);
}

TEST(TermSearch, FindsALawOfOneGroup) {
  MeasuredData data = read_data(readings([](const Row& row, int strand) {
    return row.run % 2 == 1 && strand == 2 ? 1 + 0.2 * (row.supply_V - 5) : 1;
  }));
  data.groups = {"old", "new"};
  for (Reading& reading : data.readings) reading.group = reading.run % 2;
  const DiagnosisResult result = diagnose(data, {}, {});
  ASSERT_EQ(result.causes.size(), 1U);
  EXPECT_EQ(result.causes.front().name, "law[gain of T3 in group new, supply_V, linear]");
  EXPECT_NEAR(result.causes.front().effect.values.front(), 0.2, 0.02);
}

// With finger 1 held, the tendons of both routings run towards their first end at M, and each
// tension follows from the one before it. The motor pulls M-1-P-2-F at three segments.
std::string readings_of_two_routings(double more_at_sheaths) {
  std::string text = "run,routing,held,motor_tension_N,T1_N,T2_N,T3_N,T4_N\n";
  std::uint64_t drawn = 0;
  const auto add = [&](int run, const char* word, double motor_N, std::array<double, 4> tensions) {
    text += fmt::format("r{},{},1,{}", run, word, motor_N);
    for (const double tension_N : tensions) {
      text += fmt::format(",{:.5f}", tension_N * (1 + 0.01 * normal(1, 5, drawn++)));
    }
    text += "\n";
  };
  const double tube = std::exp(-phi_tube);
  for (int run = 0; run < 12; ++run) {
    for (const double motor_N : {8.0, 12.0, 18.0, 27.0, 35.0, 50.0}) {
      if (run % 2 == 0) {
        const double first = motor_N * std::exp(-phi_sheath);
        add(run, "M-1-T-2-F", motor_N,
            {first, first * tube, first * tube * tube, first * std::pow(tube, 3)});
      } else {
        const double sheath = std::exp(-phi_sheath * (1 + more_at_sheaths));
        const double pulley = std::exp(-0.001 * std::numbers::pi);
        const double before_pulley = sheath * tube * sheath;
        const double at_end = motor_N / (1 + before_pulley * (1 + pulley));
        const double third = at_end * before_pulley * pulley * sheath;
        add(run, "M-1-P-2-F", motor_N,
            {at_end * sheath, at_end * sheath * tube, third, third * tube});
      }
    }
  }
  return text;
}

TEST(TermSearch, FindsTheSheathsOfOneRouting) {
  EXPECT_TRUE(diagnosed(readings_of_two_routings(0)).causes.empty());
  const DiagnosisResult result = diagnosed(readings_of_two_routings(0.25));
  ASSERT_EQ(result.causes.size(), 1U);
  EXPECT_EQ(result.causes.front().name, "law[exponent of sheath of M-1-P-2-F]");
  EXPECT_NEAR(result.causes.front().effect.values.front(), 0.25, 0.02);
}

// With finger 1 held, tensions fall from one contact to the next when the motor pulls, and rise as
// much when it releases.
std::string readings_of_both_directions(double more_at_tubes, bool is_pull, double gain_of_T3 = 1) {
  std::string text = "run,routing,held,direction,motor_tension_N,T1_N,T2_N,T3_N,T4_N\n";
  std::uint64_t drawn = 0;
  for (int run = 0; run < 6; ++run) {
    for (const double motor_N : {8.0, 12.0, 18.0, 27.0, 35.0, 50.0}) {
      for (const bool pulls : {true, false}) {
        text += fmt::format("r{},M-1-T-2-F,1,{},{}", run, pulls ? "pull" : "release", motor_N);
        double tension_N = motor_N * std::exp(pulls ? -phi_sheath : phi_sheath);
        for (int strand = 0; strand < 4; ++strand) {
          const double gain = pulls == is_pull && strand == 2 ? gain_of_T3 : 1;
          text += fmt::format(",{:.5f}", gain * tension_N * (1 + 0.01 * normal(1, 6, drawn++)));
          const double phi = phi_tube * (pulls == is_pull ? 1 + more_at_tubes : 1);
          tension_N *= std::exp(pulls ? -phi : phi);
        }
        text += "\n";
      }
    }
  }
  return text;
}

TEST(TermSearch, FindsTubesThatHoldMoreInRelease) {
  EXPECT_TRUE(diagnosed(readings_of_both_directions(0, false)).causes.empty());
  const DiagnosisResult result = diagnosed(readings_of_both_directions(0.3, false));
  ASSERT_EQ(result.causes.size(), 1U);
  EXPECT_EQ(result.causes.front().name, "law[exponent of tube in release]");
  EXPECT_NEAR(result.causes.front().effect.values.front(), 0.3, 0.02);
}

TEST(TermSearch, FindsTubesThatHoldMoreInPull) {
  const DiagnosisResult result = diagnosed(readings_of_both_directions(0.3, true));
  ASSERT_EQ(result.causes.size(), 1U);
  EXPECT_EQ(result.causes.front().name, "law[exponent of tube in pull]");
  EXPECT_NEAR(result.causes.front().effect.values.front(), 0.3, 0.02);
}

TEST(TermSearch, FindsASensorThatReadsMoreInRelease) {
  const DiagnosisResult result = diagnosed(readings_of_both_directions(0, false, 1.08));
  ASSERT_EQ(result.causes.size(), 1U);
  EXPECT_EQ(result.causes.front().name, "law[gain of T3 in release]");
  EXPECT_NEAR(result.causes.front().effect.values.front(), 0.08, 0.01);
}

// The gain is 4 and the search ends at 3: what it finds there may be another law in truth.
TEST(TermSearch, NamesNoLawAtTheEndOfItsRange) {
  const DiagnosisResult result = diagnosed(readings_of_both_directions(0, false, 4));
  EXPECT_TRUE(result.causes.empty());
  EXPECT_EQ(result.not_confirmed, std::vector<std::string>{"law[gain of T3 in release]"});
}

TEST(TermSearch, FindsOneLawOfTubesAndSheaths) {
  const DiagnosisResult result = diagnosed(readings([](const Row& row, int strand) {
    return std::exp(-(phi_sheath + strand * phi_tube) * 0.004 * (row.humidity_pct - 50));
  }));
  EXPECT_EQ(result.causes.front().name, "law[exponent of tube and sheath, humidity_pct, linear]");
  EXPECT_NEAR(result.causes.front().effect.values.front(), 0.004, 0.0004);
}

// Nothing moves a value that the hardware gives of fingers but a law of it.
TEST(TermSearch, FindsSheathsWhoseFingersHaveValuesOfTheirOwn) {
  Hardware hardware;
  for (const int finger : {1, 2}) {
    hardware.fingers.emplace_back().finger = finger;
    hardware.fingers.back().sheath_mu = 0.12;
  }
  const DiagnosisResult result = diagnosed(readings_of_two_routings(0), hardware);
  ASSERT_EQ(result.causes.size(), 1U);
  EXPECT_EQ(result.causes.front().name, "law[exponent of sheath]");
  EXPECT_NEAR(result.causes.front().effect.values.front(), 0.5, 0.02);
}

TEST(TermSearch, FindsTipsThatHaveValuesOfTheirOwn) {
  Hardware hardware;
  for (const int finger : {1, 2}) {
    hardware.fingers.emplace_back().finger = finger;
    hardware.fingers.back().tip_mu = 0.12;
  }
  const DiagnosisResult result = diagnosed(readings(as_said), hardware);
  ASSERT_EQ(result.causes.size(), 1U);
  EXPECT_EQ(result.causes.front().name, "law[exponent of tube of fingers]");
  EXPECT_NEAR(result.causes.front().effect.values.front(), 0.5, 0.03);
}

// With finger 1 held, finger 2 closes: e^{-phi} T1 = T3, and the block carries both.
TEST(TermSearch, FindsBlocksThatHaveALawOfTheirOwn) {
  const double at_block = std::exp(-0.08 * std::numbers::pi);
  std::string text = "run,routing,held,motor_tension_N,T1_N,T3_N,Th1_N\n";
  std::uint64_t drawn = 0;
  for (int run = 0; run < 12; ++run) {
    for (const double motor_N : {8.0, 12.0, 18.0, 27.0, 35.0, 50.0}) {
      const double hand_N = motor_N * std::exp(-phi_sheath);
      text += fmt::format("r{},M-Y1+1x-Y1-2x,1,{}", run, motor_N);
      for (const double part : {1 / (1 + at_block), at_block / (1 + at_block), 1.0}) {
        text += fmt::format(",{:.5f}", hand_N * part * (1 + 0.01 * normal(1, 7, drawn++)));
      }
      text += "\n";
    }
  }
  Hardware hardware;
  hardware.block = ContactLaw{0.05, std::numbers::pi};
  const DiagnosisResult result = diagnosed(text, hardware);
  ASSERT_EQ(result.causes.size(), 1U);
  EXPECT_EQ(result.causes.front().name, "law[exponent of block]");
  EXPECT_NEAR(result.causes.front().effect.values.front(), 0.03 * std::numbers::pi, 0.01);
}

TEST(TermSearch, FindsASensorThatReadsTheOtherWayRound) {
  const DiagnosisResult result =
      diagnosed(readings([](const Row&, int strand) { return strand == 2 ? -1 : 1; }));
  ASSERT_EQ(result.causes.size(), 1U);
  EXPECT_EQ(result.causes.front().name, "sensor_gain[T3]");
  EXPECT_NEAR(result.causes.front().effect.values.front(), -1, 0.01);
}

// Above 27 N the motor pulls more than is read of it, and so do all strands.
TEST(TermSearch, FindsAMotorSensorThatBendsAboveALoad) {
  const DiagnosisResult result = diagnosed(readings([](const Row& row, int) {
    return (row.motor_N + 0.4 * std::max(0.0, row.motor_N - 27)) / row.motor_N;
  }));
  ASSERT_EQ(result.causes.size(), 1U);
  EXPECT_EQ(result.causes.front().name, "law[offset of motor, motor_tension_N, hinge]");
  EXPECT_NEAR(result.causes.front().effect.values[0], 0.4, 0.05);
  EXPECT_NEAR(result.causes.front().effect.values[1], 27, 1);
}

// The tubes that join two fingers are parts of the hand, whichever routing is led round them.
TEST(TermSearch, FindsTheTubesOfTheHandWhateverTheirRouting) {
  const double at_hand = std::exp(-1.4 * phi_tube);
  const double at_finger = std::exp(-phi_tube);
  std::string text = "run,routing,held,motor_tension_N,T1_N,T2_N,T3_N,T4_N,T5_N,T6_N\n";
  std::uint64_t drawn = 0;
  for (int run = 0; run < 12; ++run) {
    const int count = run % 2 == 0 ? 4 : 6;
    for (const double motor_N : {8.0, 12.0, 18.0, 27.0, 35.0, 50.0}) {
      text += fmt::format("r{},{},1,{}", run, count == 4 ? "M-1-T-2-F" : "M-1-T-2-T-3-F", motor_N);
      double tension_N = motor_N * std::exp(-phi_sheath);
      for (int strand = 0; strand < count; ++strand) {
        text += fmt::format(",{:.5f}", tension_N * (1 + 0.01 * normal(1, 6, drawn++)));
        tension_N *= strand % 2 == 0 ? at_finger : at_hand;
      }
      text += count == 4 ? ",,\n" : "\n";
    }
  }
  const DiagnosisResult result = diagnosed(text);
  ASSERT_EQ(result.causes.size(), 1U);
  EXPECT_EQ(result.causes.front().name, "law[exponent of tube of the hand]");
  EXPECT_NEAR(result.causes.front().effect.values.front(), 0.4, 0.03);
}

// The gain of T3 in the grammar, from a wrong value and a wrong crossing on.
Effect suspected_gain(const std::string& column) {
  Term term;
  term.target = causes::Target::gain;
  term.site.place = causes::SitePlace::channel;
  term.site.channel = parse_segment("T3");
  term.form = causes::Form::linear;
  term.x = causes::covariate_named(column);
  term.x.middle = 5;
  term.x.seen = {4.5, 5.5};
  return {&law(term), {}, {0.001}};
}

TEST(TermSearch, FindsAWeakLawThatTheUserNames) {
  const std::string text = readings(
      [](const Row& row, int strand) { return strand == 2 ? 1 + 0.0165 * (row.supply_V - 5) : 1; });
  EXPECT_TRUE(diagnosed(text).causes.empty());
  const DiagnosisResult result = diagnosed(text, 1, {suspected_gain("supply_V")});
  ASSERT_EQ(result.causes.size(), 1U);
  EXPECT_EQ(result.causes.front().name, "law[gain of T3, supply_V, linear]");
  EXPECT_NEAR(result.causes.front().effect.values.front(), 0.0165, 0.01);
}

TEST(TermSearch, RefusesATermOfAColumnThatTheReadingsLack) {
  EXPECT_THROW(diagnosed(readings(as_supplied), 1, {suspected_gain("supply_mV")}), InputError);
}

// A sensor reads less where it is moist. Each step is between two of 72 humidities.
TEST(TermSearch, FindsTheValueAtWhichAStepIs) {
  for (const double at : {47.0, 53.0, 61.3}) {
    const DiagnosisResult result = diagnosed(readings([&](const Row& row, int strand) {
      return strand == 2 && row.humidity_pct > at ? 0.7 : 1.0;
    }));
    EXPECT_TRUE(result.apart.empty());
    ASSERT_EQ(result.causes.size(), 1U);
    const NamedCause& law = result.causes.front();
    const Term* term = term_of(*law.effect.cause);
    ASSERT_NE(term, nullptr);
    EXPECT_EQ(term->form, causes::Form::step);
    EXPECT_NEAR(law.effect.values[0], -0.3, 0.01);
    EXPECT_NEAR(law.effect.values[1], at, 1);
    EXPECT_LE(law.parameters[1].low, at);
    EXPECT_GE(law.parameters[1].high, at);
    EXPECT_LT(law.parameters[1].high - law.parameters[1].low, 5);
  }
}

// The run was moist, too, and no other was.
// Mountings change the sheath by 1.5 % and each tube by 2 %. A step between runs widens the scatter
// of sheaths alone; narrowed together with that of tubes, what explains the step would cost theirs.
TEST(ScatterShape, LetsTheWidestScatterOfContactsBeNarrowedAlone) {
  const auto mounted = [](int run, std::uint32_t contact) {
    return normal(5, 11 + contact, static_cast<std::uint64_t>(run));
  };
  const auto data_with_step = [&](double step) {
    return read_data(readings([&](const Row& row, int strand) {
      double exponent = phi_sheath * (0.015 * mounted(row.run, 0) - (row.run >= 8 ? step : 0.0));
      for (int tube = 1; tube <= strand; ++tube) {
        exponent += phi_tube * 0.02 * mounted(row.run, static_cast<std::uint32_t>(tube));
      }
      return std::exp(-exponent);
    }));
  };
  const MeasuredData parted = data_with_step(0.25);
  const MeasuredData explained = data_with_step(0);
  const Dataset with_step = all_of(parted);
  const Dataset without_step = all_of(explained);
  Workers workers(1);
  const ScatterShape shape = scatter_shape(with_step, {}, std::nullopt, workers);
  EXPECT_EQ(likelihood(with_step, shape, forecast(with_step, {})).level.widest, 1);
  EXPECT_LT(likelihood(without_step, shape, forecast(without_step, {})).level.widest, 1);
}

TEST(TermSearch, TakesAStepThatPartsOneRunForThatRunApart) {
  const DiagnosisResult result = diagnosed(
      readings([](const Row& row, int strand) { return strand == 2 && row.run == 5 ? 0.7 : 1.0; },
               0, [](int run, std::uint64_t) { return run == 5 ? 80.0 : 40.0 + run; }));
  EXPECT_TRUE(result.causes.empty());
  ASSERT_EQ(result.apart.size(), 1U);
}

// A sheath passes its friction on to all strands. Far from small, so that what it does is far from
// proportional to it.
double as_sheath_with_both(const Row& row, int) {
  return std::exp(-phi_sheath * 0.03 * (row.humidity_pct - 35) * (row.supply_V - 4.7));
}

TEST(TermSearch, FindsWhereALargeProductOfTwoColumnsIsZero) {
  const DiagnosisResult result = diagnosed(readings(as_sheath_with_both));
  ASSERT_EQ(result.causes.size(), 1U);
  const Term* term = term_of(*result.causes.front().effect.cause);
  ASSERT_NE(term, nullptr);
  EXPECT_EQ(term->form, causes::Form::product);
  const bool supply_first = covariate_name(term->x) == "supply_V";
  EXPECT_NEAR((supply_first ? term->y : term->x).middle, 35, 0.2);
  EXPECT_NEAR((supply_first ? term->x : term->y).middle, 4.7, 0.01);
}

TEST(TermSearch, FindsTheExponentOfAForceThatGrowsWithTheLoad) {
  std::string text = "run,routing,held,motor_tension_N,T1_N,T2_N,T3_N,T4_N\n";
  std::uint64_t drawn = 0;
  for (int run = 0; run < 12; ++run) {
    for (const double motor_N : {20.0, 40.0, 80.0, 160.0}) {
      text += fmt::format("r{},M-1-T-2-F,1,{}", run, motor_N);
      double tension_N = motor_N * std::exp(-phi_sheath);
      for (int strand = 0; strand < 4; ++strand) {
        text += fmt::format(",{:.5f}", tension_N * (1 + 0.005 * normal(1, 5, drawn++)));
        tension_N = tension_N * std::exp(-phi_tube) - 0.12 * std::sqrt(tension_N);
      }
      text += "\n";
    }
  }
  // A logarithm beside another friction coefficient would do nearly the same.
  Hardware hardware;
  hardware.tube.known = true;
  DiagnoseOptions options;
  options.threads = 1;
  const DiagnosisResult result = diagnose(read_data(text), hardware, options);
  ASSERT_EQ(result.causes.size(), 1U);
  const Effect& law = result.causes.front().effect;
  EXPECT_EQ(effect_name(law), "law[force of tube, load, scaling]");
  EXPECT_NEAR(law.values[1], 0.5, 0.1);
  EXPECT_NEAR(law.values[0], 0.12 * std::sqrt(term_of(*law.cause)->x.middle), 0.02);
}

TEST(TermSearch, FindsNothingInNoiseAlone) {
  const DiagnosisResult result = diagnosed(readings([](const Row&, int) { return 1.0; }));
  EXPECT_EQ(result.verdict, Verdict::none);
  EXPECT_TRUE(result.causes.empty());
  EXPECT_TRUE(result.apart.empty());
}

TEST(TermSearch, NamesARunThatStandsApart) {
  const DiagnosisResult result = diagnosed(
      readings([](const Row& row, int strand) { return row.run == 7 && strand == 1 ? 1.3 : 1.0; }));
  EXPECT_EQ(result.verdict, Verdict::unexplained);
  ASSERT_EQ(result.apart.size(), 1U);
  EXPECT_EQ(result.apart.front().runs, std::vector<std::string>{"r7"});
  EXPECT_TRUE(result.causes.empty());
}

// Two bad mountings may look like great scatter of all of them.
TEST(TermSearch, NamesRunsThatStandApartTogether) {
  const auto mounted = [](const Row& row, int strand) {
    return 1 + 0.004 * normal(2, strand, static_cast<std::uint64_t>(row.run));
  };
  EXPECT_TRUE(diagnosed(readings(mounted)).apart.empty());
  const DiagnosisResult result = diagnosed(readings([&](const Row& row, int strand) {
    const bool is_bad = strand == 1 && (row.run == 3 || row.run == 7);
    return mounted(row, strand) * (is_bad ? 0.95 : 1.0);
  }));
  EXPECT_EQ(result.verdict, Verdict::unexplained);
  EXPECT_TRUE(result.causes.empty());
  ASSERT_EQ(result.apart.size(), 1U);
  EXPECT_EQ(result.apart.front().runs, (std::vector<std::string>{"r3", "r7"}));
  EXPECT_NEAR(result.apart.front().effect.values.front(), -0.05, 0.01);
}

// Mountings that scatter by 2 % would have to scatter by 12 % to explain it. The sheath is the
// first contact behind the motor, so what differs might as well be the gain of either side.
TEST(TermSearch, NamesAMountingThatStandsApart) {
  const DiagnosisResult result = diagnosed(readings([](const Row& row, int) {
    const double more = 0.02 * normal(1, 7, static_cast<std::uint64_t>(row.run));
    return std::exp(-phi_sheath * (row.run == 7 ? more + 0.4 : more));
  }));
  EXPECT_EQ(result.verdict, Verdict::unexplained);
  EXPECT_TRUE(result.causes.empty());
  ASSERT_EQ(result.apart.size(), 1U);
  EXPECT_EQ(result.apart.front().runs, std::vector<std::string>{"r7"});
  EXPECT_NE(result.apart.front().text.find("exponent of sheath in run r7"), std::string::npos)
      << result.apart.front().text;
}

// The place of a reading in the file says no more of it than its run does, and a later file has
// runs of higher numbers.
TEST(TermSearch, SaysFromWhichRunOnASensorIsOff) {
  const auto off = [](const Row& row, int strand) {
    return row.run >= 7 && strand == 2 ? 1.12 : 1;
  };
  const DiagnosisResult result = diagnosed(readings(off));
  EXPECT_EQ(result.verdict, Verdict::cause);
  ASSERT_EQ(result.causes.size(), 1U);
  EXPECT_EQ(result.causes.front().name, "law[gain of T3, run, step]");
  EXPECT_NEAR(result.causes.front().effect.values[0], 0.12, 0.01);

  const MeasuredData later = read_data(readings(off, 30));
  const Dataset all = dataset(later, {0, 40, 71});
  const Forecast at = forecast(all, result.model);
  for (std::size_t i = 0; i < all.cells.size(); ++i) {
    const double measured_N = all.cells[i].measured_N;
    EXPECT_NEAR(at.reading_N[static_cast<Eigen::Index>(i)], measured_N, 0.05 * measured_N);
  }
}

TEST(TermSearch, IsTheSameForAnyNumberOfThreads) {
  const std::string text = readings(as_supplied);
  const DiagnosisResult one = diagnosed(text, 1);
  const DiagnosisResult three = diagnosed(text, 3);
  ASSERT_EQ(one.causes.size(), 1U);
  ASSERT_EQ(three.causes.size(), 1U);
  EXPECT_EQ(one.causes.front().effect.values, three.causes.front().effect.values);
  EXPECT_EQ(one.held_out->log_likelihood_gain, three.held_out->log_likelihood_gain);
}

const Lever* lever_of(const std::vector<Lever>& levers, causes::Target target,
                      const std::string& site) {
  for (const Lever& lever : levers) {
    if (lever.target == target && causes::site_name(lever.site) == site) return &lever;
  }
  return nullptr;
}

// The reference solves T2 = T1 e^{-phi} - F, and so on, by hand.
TEST(Levers, AreTheDerivativesOfTheEquations) {
  const MeasuredData data = read_data(
      "run,routing,held,motor_tension_N,T1_N,T2_N,T3_N,T4_N\n"
      "a,M-1-T-2-F,1,20,6,3,2,1\n");
  Dataset all = all_of(data);
  const Forecast at = forecast(all, {});
  Workers workers(1);
  const std::vector<Lever> all_levers = levers(all, {}, at, workers);
  const Lever* sheath = lever_of(all_levers, causes::Target::exponent, "sheath");
  const Lever* tubes = lever_of(all_levers, causes::Target::force, "tube");
  const Lever* gain = lever_of(all_levers, causes::Target::gain, "motor");
  ASSERT_TRUE(sheath != nullptr && tubes != nullptr && gain != nullptr);
  // By a force that grows with the root of the load.
  Eigen::Vector4d by_root = Eigen::Vector4d::Zero();
  for (const ContactShare& share : tubes->shares) {
    by_root[share.cell] += share.by_value_N * std::sqrt(share.load_N);
  }
  double force = 0, root_force = 0;
  for (Eigen::Index i = 0; i < 4; ++i) {
    const double tension_N = 20 * std::exp(-phi_sheath - static_cast<double>(i) * phi_tube);
    EXPECT_NEAR(at.reading_N[i], tension_N, 1e-6);
    EXPECT_NEAR(sheath->by_value_N[i], -phi_sheath * tension_N, 1e-5);
    EXPECT_NEAR(tubes->by_value_N[i], force, 1e-5);
    EXPECT_NEAR(gain->by_value_N[i], tension_N, 1e-5);
    force = force * std::exp(-phi_tube) - 1;
    EXPECT_NEAR(by_root[i], root_force, 1e-5);
    root_force = root_force * std::exp(-phi_tube) - std::sqrt(tension_N);
  }
}

std::vector<Lever> levers_of(const std::string& text) {
  const MeasuredData data = read_data(text);
  const Dataset all = all_of(data);
  Workers workers(1);
  return levers(all, {}, forecast(all, {}), workers);
}

// The hand has one sheath, and three tubes of which one is in no finger.
TEST(Levers, OfTheSameContactsAreOne) {
  const std::vector<Lever> all_levers = levers_of(
      "run,routing,held,motor_tension_N,T1_N,T2_N,T3_N,T4_N\n"
      "a,M-1-T-2-F,1,20,6,3,2,1\n");
  const auto has = [&](const std::string& site) {
    return lever_of(all_levers, causes::Target::exponent, site) != nullptr;
  };
  EXPECT_TRUE(has("sheath"));
  EXPECT_FALSE(has("sheath 1 of M-1-T-2-F"));
  EXPECT_TRUE(has("tube"));
  EXPECT_TRUE(has("tube of finger 1"));
  EXPECT_FALSE(has("tube 1 of M-1-T-2-F"));
}

// The first strand lies before all tubes.
TEST(Levers, OfTubesAndSheathsAreOfSheathsWhereNoTubeIsSeen) {
  const std::vector<Lever> all_levers = levers_of(
      "run,routing,held,motor_tension_N,T1_N\n"
      "a,M-1-T-2-F,1,20,6\n");
  EXPECT_NE(lever_of(all_levers, causes::Target::force, "sheath"), nullptr);
  EXPECT_EQ(lever_of(all_levers, causes::Target::force, "tube and sheath"), nullptr);
}

// 0.3 ln(T / 8), from 2 N to 32 N.
Effect log_force_of_tubes() {
  Term term;
  term.target = causes::Target::force;
  term.form = causes::Form::log;
  term.x = causes::covariate_named("load");
  term.x.middle = 8;
  term.x.seen = {2, 32};
  return {&law(term), {}, {0.3}};
}

TEST(OtherForms, BeginNearTheLawButForAConstant) {
  const auto forms = other_forms(log_force_of_tubes());
  const auto root = std::find_if(forms.begin(), forms.end(), [](const LawForm& form) {
    const Term& term = *term_of(*form.effect.cause);
    return term.form == causes::Form::scaling && term.target == causes::Target::force;
  });
  ASSERT_NE(root, forms.end());
  EXPECT_EQ(root->more_price, 2);
  const auto flat = std::find_if(root->starts.begin(), root->starts.end(),
                                 [](const auto& start) { return start[1] == 0.3; });
  ASSERT_NE(flat, root->starts.end());
  const auto rise = [&](double from_N, double to_N) {
    const Term& term = *term_of(*root->effect.cause);
    return causes::law_value(term, to_N, 0, flat->data()) -
           causes::law_value(term, from_N, 0, flat->data());
  };
  EXPECT_NEAR(rise(2, 32), 0.3 * std::log(16.0), 0.05);
  EXPECT_NEAR(rise(4, 16), 0.3 * std::log(4.0), 0.05);
}

TEST(OtherForms, OfOneDirectionIsTheOther) {
  Term term;
  term.site.direction = Direction::pull;
  const auto forms = other_forms({&law(term), {}, {0.25}});
  ASSERT_EQ(forms.size(), 1U);
  EXPECT_EQ(effect_name(forms[0].effect), "law[exponent of tube in release]");
  EXPECT_NEAR(forms[0].starts[0][0], -0.2, 1e-12);
}

TEST(OtherForms, OfALoadAreForcesAndExponents) {
  const auto forms = other_forms(log_force_of_tubes());
  const auto count = [&](causes::Target target) {
    return std::count_if(forms.begin(), forms.end(), [&](const LawForm& form) {
      return term_of(*form.effect.cause)->target == target;
    });
  };
  EXPECT_EQ(count(causes::Target::force), 6);     // all but log
  EXPECT_EQ(count(causes::Target::exponent), 7);  // linear, log, power, scaling and three more
}

TEST(LawForm, IsImpossibleIfContactsGiveForce) {
  const Term& term = *term_of(*log_force_of_tubes().cause);
  EXPECT_FALSE(is_possible(term, {0.3}));  // below 8 N
  Term taken = term;
  taken.x.middle = 2;
  EXPECT_TRUE(is_possible(taken, {0.3}));
  EXPECT_FALSE(is_possible(taken, {-0.3}));
}

TEST(Evidence, IsRobustAgainstOneWildReading) {
  const MeasuredData data = read_data(readings([](const Row&, int) { return 1.0; }));
  Dataset all = all_of(data);
  Workers workers(1);
  const ScatterShape shape = scatter_shape(all, {}, std::nullopt, workers);
  const Forecast at = forecast(all, {});
  const double scale = likelihood(all, shape, at).scale;
  MeasuredData wild = data;
  *wild.readings[10].tension_N[1] *= 2;
  Dataset with_one = all_of(wild);
  EXPECT_NEAR(likelihood(with_one, shape, at).scale, scale, 0.15 * scale);
}

// Weights that hang where the sensor is, each a run: the hand holds W = (T - 2.5 N) e^{-phi}, and T
// is read with 0.4 N of noise.
std::string weights_csv() {
  std::string text = "run,routing,motor_tension_N,Th1_N\n";
  std::uint64_t drawn = 0;
  for (const double weight_N : {5.0, 10.0, 15.0, 20.0, 30.0, 40.0, 50.0}) {
    for (int i = 0; i < 8; ++i) {
      const double motor_N = weight_N * std::exp(0.3) + 2.5 + 0.4 * normal(1, 9, drawn++);
      text += fmt::format("{} N,M-F,{:.4f},{}\n", weight_N, motor_N, weight_N);
    }
  }
  return text;
}

TEST(SetReadings, AreThoseThatDoNotFollowTheMotorTensionsScatter) {
  const MeasuredData data = read_data(weights_csv());
  const auto set = set_readings(all_of(data));
  ASSERT_TRUE(set.has_value());
  EXPECT_NEAR(set->motor_N, 0.4, 0.1);
  EXPECT_TRUE(set->one_of_each_run);
  EXPECT_TRUE(set->several);
  EXPECT_FALSE(set_readings(all_of(read_data(readings([](const Row&, int) { return 1.0; })))));
}

TEST(SetReadings, OfARunForEachWeightTellFrictionAndLoss) {
  const DiagnosisResult result = diagnosed(weights_csv());
  EXPECT_TRUE(std::any_of(result.indistinguishable.begin(), result.indistinguishable.end(),
                          [](const std::vector<std::string>& names) {
                            return std::find(names.begin(), names.end(), "constant_loss") !=
                                   names.end();
                          }));
  ASSERT_EQ(result.calibration.size(), 1U);
  EXPECT_NEAR(2 * std::numbers::pi * result.calibration[0].parameter.value, 0.3, 0.05);
  EXPECT_LT(result.held_out->rms_after_N, result.held_out->rms_before_N / 4);
}

TEST(RobustMisfit, IsThatOfSquaresWithinAndOfLogarithmsBeyond) {
  EXPECT_DOUBLE_EQ(robust_misfit(Eigen::Vector2d(1, -3)), 10);
  EXPECT_DOUBLE_EQ(robust_misfit(Eigen::VectorXd::Constant(1, 7)),
                   3.5 * 3.5 * (1 + 2 * std::log(2)));
}

TEST(FreeCrossing, IsALawThatHoldsItOnceFitted) {
  Term term;
  term.target = causes::Target::gain;
  term.site.place = causes::SitePlace::channels;
  term.form = causes::Form::linear;
  term.x = causes::covariate_named("supply_V");
  term.x.seen = {4, 6};
  term.x.middle = 5.5;
  const Effect free{&causes::law_with_free_crossing(term), {}, {0.2, 5}};
  EXPECT_EQ(free.cause->parameters({}).size(), 2U);
  const Effect held = causes::with_crossing_held(free);
  ASSERT_EQ(held.values, std::vector<double>{0.2});
  EXPECT_EQ(term_of(*held.cause)->x.middle, 5);
  const double law[] = {0.2};
  EXPECT_DOUBLE_EQ(causes::law_value(*term_of(*held.cause), 5.5, 0, law), 0.1);
}

}  // namespace
}  // namespace reeve::testing
