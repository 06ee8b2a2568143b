// Designs over a coefficient: curves and crossings in closed form, and against evaluating them one
// value after another.
#include "search/uncertainty/sweep.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "causes/library.hpp"
#include "core/error.hpp"
#include "core/notation.hpp"
#include "search/evaluate/evaluation.hpp"
#include "tests/search/uncertain.hpp"
#include "tests/support/published_words.hpp"

namespace reeve::testing {
namespace {

constexpr double pi = std::numbers::pi;

SweepOptions sweeping(const std::string& range, GraspSet grasps = single_grasps(2)) {
  SweepOptions options;
  options.uncertainty = options_for(21);
  options.uncertainty.grasps = std::move(grasps);
  options.over = parse_sweep(range);
  return options;
}

Sweep swept(const std::vector<std::string>& words, const SweepOptions& options) {
  return sweep(parsed(words), options).value();
}

Hardware hardware_with(Coefficient coefficient, double value) {
  Hardware hardware;
  switch (coefficient) {
    case Coefficient::mu:
      hardware.tube.mu = hardware.sheath.mu = value;
      break;
    case Coefficient::tube_mu:
      hardware.tube.mu = value;
      break;
    case Coefficient::sheath_mu:
      hardware.sheath.mu = value;
      break;
    case Coefficient::bearing_mu:
      hardware.bearing.mu = value;
      break;
    case Coefficient::sheath_angle:
      hardware.sheath.angle_rad = value;
      break;
  }
  return hardware;
}

TEST(Sweep, GoesFromEndToEndThroughWhatTheDesignsAreThere) {
  for (const char* text : {"mu=0.02..0.3", "tube_mu=0..0.5", "sheath_mu=0.1..0.2",
                           "bearing_mu=0..0.05", "sheath_angle=1..9"}) {
    const SweepOptions options = sweeping(text);
    const Sweep result = swept(published_words(), options);
    ASSERT_EQ(result.at.size(), 29U);
    EXPECT_EQ(result.at.front(), options.over.range.low);
    EXPECT_EQ(result.at.back(), options.over.range.high);
    for (std::size_t k = 0; k < result.at.size(); ++k) {
      DesignEvaluator evaluator(hardware_with(options.over.coefficient, result.at[k]),
                                single_grasps(2));
      for (std::size_t i = 0; i < published_words().size(); ++i) {
        const ObjectiveValues values = evaluator.evaluate(parse_routing(published_words()[i]));
        ASSERT_EQ(result.designs[i].size(), 2U);
        EXPECT_EQ(result.designs[i][0].values[k], value(values, Objective::uniformity_mean));
        EXPECT_EQ(result.designs[i][1].values[k], value(values, Objective::efficiency_mean));
        EXPECT_TRUE(result.designs[i][0].bands.empty());
      }
    }
  }
}

// With finger 1 held the tendon slides round the block: T1/T3 is e^(-phi) of it.
TEST(Sweep, OfBearingsTakesBlocksAlongUnlessTheyHaveAnotherCoefficient) {
  const auto require = [](std::optional<ContactLaw> block, double per_mu, double constant) {
    SweepOptions options = sweeping("bearing_mu=0..0.1", paper_grasps());
    options.uncertainty.nominal.hardware.bearing.mu = 0.05;
    options.uncertainty.nominal.hardware.block = block;
    const Sweep result = swept({"M-Y1+1x-Y1-2x"}, options);
    for (std::size_t k = 0; k < result.at.size(); ++k) {
      EXPECT_NEAR(result.designs[0][0].values[k], std::exp(-per_mu * result.at[k] - constant),
                  2e-10);
    }
  };
  require(std::nullopt, pi, 0);
  require(ContactLaw{0.05, 2}, 2, 0);
  require(ContactLaw{0.02, 2}, 0, 0.04);
}

// TR1's uniformity is e^(-3 pi mu_t), whatever the sheaths do.
TEST(SweepBands, AreOfWhatElseIsUncertain) {
  SweepOptions options = sweeping("sheath_mu=0.02..0.3");
  options.draws = true;
  options.uncertainty.nominal.hardware.scatter = {0, 0};
  std::vector<double> mu;
  for (std::uint64_t d = 0; d < 21; ++d) {
    mu.push_back(draw_model(options.uncertainty, d).hardware.tube.mu);
  }
  std::sort(mu.begin(), mu.end());
  const Sweep over_sheaths = swept({"M-1-T-2-F"}, options);
  for (const Band& band : over_sheaths.designs[0][0].bands) {
    EXPECT_NEAR(band.low, std::exp(-3 * pi * mu[19]), 2e-10);
    EXPECT_NEAR(band.median, std::exp(-3 * pi * mu[10]), 2e-10);
    EXPECT_NEAR(band.high, std::exp(-3 * pi * mu[1]), 2e-10);
  }
  for (const char* text : {"mu=0.02..0.3", "tube_mu=0.02..0.3"}) {
    options.over = parse_sweep(text);
    const SweepCurve curve = swept({"M-1-T-2-F"}, options).designs[0][0];
    ASSERT_EQ(curve.bands.size(), 29U);
    for (std::size_t k = 0; k < 29; ++k) {
      EXPECT_TRUE(curve.bands[k].is_point());
      EXPECT_EQ(curve.bands[k].median, curve.values[k]);
      EXPECT_NEAR(curve.values[k], std::exp(-3 * pi * (0.02 + 0.01 * static_cast<double>(k))),
                  2e-10);
    }
  }
}

// With finger 1 held, T4/T1 of TR1 is e^(-3 phi_t), and of TR4 e^(-2 phi_t - 2 phi_s - phi_b):
// equal where mu_t theta = 2 mu_s 2 theta + mu_b theta.
TEST(SweepLeads, ChangeHandsWhereTheClosedFormsCross) {
  struct Case {
    const char* range;
    double crossing;
    std::size_t first_below;  // 0: TR1, 1: TR4
  };
  const double mu = 0.18;
  for (const Case& one : {Case{"sheath_mu=0.01..0.3", (mu - 0.001) / 4, 1},
                          Case{"tube_mu=0.5..0.9", 4 * mu + 0.001, 0},
                          Case{"sheath_angle=0.2..9", pi * (mu - 0.001) / (2 * mu), 1}}) {
    SweepOptions options = sweeping(one.range, paper_grasps());
    options.uncertainty.order = {Objective::uniformity_mean};
    const std::vector<SweepLead> leads = swept({"M-1-T-2-F", "M-1-P-2-F"}, options).leads;
    ASSERT_EQ(leads.size(), 2U) << one.range;
    EXPECT_EQ(leads[0].first, std::vector<std::size_t>{one.first_below});
    EXPECT_EQ(leads[1].first, std::vector<std::size_t>{1 - one.first_below});
    EXPECT_EQ(leads[0].from, options.over.range.low);
    EXPECT_NEAR(leads[0].to, one.crossing, 1e-7) << one.range;
    EXPECT_EQ(leads[1].from, leads[0].to);
    EXPECT_EQ(leads[1].to, options.over.range.high);
  }
}

TEST(SweepLeads, AreOneWhereOneDesignAlwaysLeads) {
  const std::vector<SweepLead> leads = swept(published_words(), sweeping("mu=0.02..0.3")).leads;
  ASSERT_EQ(leads.size(), 1U);
  EXPECT_EQ(leads[0].first, std::vector<std::size_t>{6});
  EXPECT_EQ(leads[0].from, 0.02);
  EXPECT_EQ(leads[0].to, 0.3);
}

// Without friction of the sheaths a pulley on the carriage is as good as one at the hand; with any,
// it is not. That both are first at the very end is no lead.
TEST(SweepLeads, BeginAtTheEndEvenIfDesignsAreEqualThere) {
  SweepOptions options = sweeping("sheath_mu=0..0.3", paper_grasps());
  options.uncertainty.order = {Objective::uniformity_mean};
  const Sweep result = swept({"M-1-P-2-F", "M-1-B-2-F"}, options);
  EXPECT_EQ(result.places[0].front(), 1U);
  EXPECT_EQ(result.places[0].back(), 2U);
  ASSERT_EQ(result.leads.size(), 1U);
  EXPECT_EQ(result.leads[0].first, std::vector<std::size_t>{1});
  EXPECT_EQ(result.leads[0].from, 0);
  EXPECT_EQ(result.leads[0].to, 0.3);
}

TEST(SweepLeads, AreSharedByEqualDesigns) {
  const Sweep result = swept({"1-T-2-P-1", "M-1-T-2-F", "F-1-P-2-F"}, sweeping("mu=0.02..0.3"));
  ASSERT_EQ(result.leads.size(), 1U);
  EXPECT_EQ(result.leads[0].first, (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ(result.places[0].front(), 1U);
  EXPECT_EQ(result.places[1].front(), 3U);
  EXPECT_EQ(result.places[2].front(), 1U);
}

// By the authors' score three designs lead in turn; whoever does is asked at points in between.
TEST(SweepLeads, AreThoseOfRankingAnywhereBetweenTheirEnds) {
  SweepOptions options = sweeping("mu=0.02..0.3", paper_grasps());
  options.uncertainty.order = Order({Objective::score}, true);
  const std::vector<SweepLead> leads = swept(published_words(), options).leads;
  ASSERT_EQ(leads.size(), 3U);
  const auto score = [&](std::size_t design, double mu) {
    DesignEvaluator evaluator(hardware_with(Coefficient::mu, mu), paper_grasps());
    return value(evaluator.evaluate(parse_routing(published_words()[design])), Objective::score);
  };
  for (const SweepLead& lead : leads) {
    for (const double share : {0.001, 0.3, 0.7, 0.999}) {
      const double mu = lead.from + share * (lead.to - lead.from);
      double best = score(0, mu);
      for (std::size_t i = 1; i < 7; ++i) best = std::max(best, score(i, mu));
      for (std::size_t i = 0; i < 7; ++i) {
        const bool leads_here =
            std::find(lead.first.begin(), lead.first.end(), i) != lead.first.end();
        EXPECT_EQ(score(i, mu) == best, leads_here) << published_words()[i] << " at " << mu;
      }
    }
  }
}

TEST(Sweep, ReplacesTheEffectsOnWhatItVaries) {
  SweepOptions options = sweeping("mu=0.02..0.3");
  const Sweep plain = swept({"M-1-T-2-F"}, options);
  Model& model = options.uncertainty.nominal;
  for (const Cause* cause : cause_library()) {
    const std::string name = cause->name();
    if (name == "tube_friction" || name == "sheath_friction") {
      add_effect(model, {cause, {}, {0.5}});
    }
  }
  ASSERT_EQ(model.effects.size(), 2U);
  EXPECT_EQ(swept({"M-1-T-2-F"}, options).designs[0][1].values, plain.designs[0][1].values);
  options.over = parse_sweep("tube_mu=0.02..0.3");
  const Sweep tubes = swept({"M-1-T-2-F"}, options);
  EXPECT_LT(tubes.designs[0][1].values[16], plain.designs[0][1].values[16]);  // rough sheaths
  EXPECT_EQ(tubes.designs[0][0].values, plain.designs[0][0].values);
}

TEST(Sweep, DoesNotDependOnThreads) {
  SweepOptions options = sweeping("sheath_mu=0.02..0.3");
  options.draws = true;
  options.steps = 4;
  const Sweep one = swept(published_words(), options);
  options.uncertainty.threads = 3;
  const Sweep three = swept(published_words(), options);
  for (std::size_t i = 0; i < 7; ++i) {
    for (std::size_t k = 0; k < one.at.size(); ++k) {
      EXPECT_EQ(one.designs[i][1].bands[k].low, three.designs[i][1].bands[k].low);
      EXPECT_EQ(one.designs[i][1].bands[k].high, three.designs[i][1].bands[k].high);
    }
  }
}

TEST(Sweep, StoppedIsNothing) {
  const std::atomic<bool> stop{true};
  EXPECT_FALSE(sweep(parsed(published_words()), sweeping("mu=0..0.3"), {{}, &stop}).has_value());
}

TEST(Sweep, NeedsARankedObjectiveThatFrictionMoves) {
  SweepOptions options = sweeping("mu=0..0.3");
  options.uncertainty.order = {Objective::sheaths};
  EXPECT_THROW(validate(options), InputError);
  options.uncertainty.order = {Objective::sheaths, Objective::uniformity_mean};
  EXPECT_NO_THROW(validate(options));
  EXPECT_EQ(swept_objectives(options.uncertainty.order),
            std::vector<Objective>{Objective::uniformity_mean});
}

TEST(Sweep, StaysWithinWhatAHardwareCanBe) {
  SweepOptions options = sweeping("sheath_angle=1..50");
  EXPECT_NO_THROW(validate(options));  // 0.18 * 50
  options.draws = true;
  EXPECT_NO_THROW(validate(options));  // 0.20 * 50
  options.uncertainty.ranges.sheath_mu.high = 0.21;
  EXPECT_THROW(validate(options), InputError);
}

TEST(ParseSweep, ReadsACoefficientAndItsRange) {
  const CoefficientRange range = parse_sweep(" sheath_angle = 1 .. 9.5 ");
  EXPECT_EQ(range.coefficient, Coefficient::sheath_angle);
  EXPECT_EQ(range.range.low, 1);
  EXPECT_EQ(range.range.high, 9.5);
  for (const char* text :
       {"", "mu", "mu=", "mu=0.1", "mu=0.3..0.1", "mu=0.1..0.1", "mu=-1..1", "mu=0..1.5", "mu=a..b",
        "mu=0..nan", "friction=0..1", "mu=0..0.3,tube_mu=0..1"}) {
    EXPECT_THROW(parse_sweep(text), InputError) << text;
  }
}

}  // namespace
}  // namespace reeve::testing
