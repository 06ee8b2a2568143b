// Leads where the truth is written down: one run reads more at one strand, or all runs follow a
// column.
#include "diagnosis/verdict/leads.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <string>

#include "diagnosis/fit/evidence.hpp"
#include "tests/diagnosis/pattern_bench.hpp"

namespace reeve::testing {
namespace {

Sample all_in_training(const Dataset& dataset) {
  Sample part;
  part.training = dataset;
  return part;
}

Scatter bench_scatter() {
  Scatter scatter;
  scatter.noise.absolute_N = bench_noise_N;
  return scatter;
}

TEST(Leads, NameTheRunThatStandsApartFirst) {
  const BenchPlan plan{8, 6, 3, bench_noise_N};
  const Bench bench(plan, [](std::size_t run) { return run == 5 ? Pattern{0.5} : Pattern{}; });
  Workers workers(1);
  const std::vector<Lead> found =
      leads(all_in_training(bench.dataset), bench.problem, Model{}, bench_scatter(), workers);
  ASSERT_FALSE(found.empty());
  EXPECT_LE(found.size(), most_leads);
  const Term* term = causes::term_of(*found.front().effect.cause);
  ASSERT_NE(term, nullptr);
  EXPECT_EQ(term->site.runs, std::vector<std::string>{"r5"});
  EXPECT_TRUE(is_of_one_place(found.front().effect));
  EXPECT_GT(found.front().evidence, 50);
  ASSERT_TRUE(found.front().partial.has_value());
  for (const PartialPoint& point : found.front().partial->points) {
    EXPECT_EQ(bench.data.runs[bench.data.readings[point.reading].run], "r5");
  }
}

TEST(Leads, OfNoiseAloneAreNone) {
  const Bench bench(Pattern{}, BenchPlan{8, 6, 3, bench_noise_N});
  Workers workers(1);
  EXPECT_TRUE(
      leads(all_in_training(bench.dataset), bench.problem, Model{}, bench_scatter(), workers)
          .empty());
}

// An eccentric pulley that turns 20 times.
TEST(Leads, FindAWaveOfManyPeriods) {
  constexpr int rows = 200, rows_of_a_period = 10;
  const double T1_N = 20 * std::exp(-0.18 * 2 * std::numbers::pi);  // behind the sheath
  std::string text = "run,routing,motor_tension_N,T1_N\n";
  for (int i = 0; i < rows; ++i) {
    const double wave = std::sin(2 * std::numbers::pi * i / rows_of_a_period);
    text += fmt::format("A,M-1-F,20,{}\n", T1_N + 0.5 * wave + 0.1 * numerics::normal(3, 1, i));
  }
  const MeasuredData data = read_data(text);
  const Dataset dataset = all_of(data);
  Scatter scatter;
  scatter.noise.absolute_N = 0.1;
  Workers workers(1);
  const std::vector<Lead> found =
      leads(all_in_training(dataset), problem(dataset, Eigen::VectorXd::Constant(rows, 0.1)),
            Model{}, scatter, workers);
  ASSERT_FALSE(found.empty());
  const Effect& wave = found.front().effect;
  ASSERT_EQ(causes::term_of(*wave.cause)->form, Form::sine);
  EXPECT_NEAR(wave.values[2] * (rows - 1), rows_of_a_period, 0.1);
}

// A sheath whose exponent grows by 2 over the column is far from any law to first order.
TEST(Leads, HaveTheEvidenceOfTheirFit) {
  constexpr int rows = 100;
  constexpr double most_price = 30;  // nats
  const double phi = 0.18 * 2 * std::numbers::pi;
  std::string text = "run,routing,motor_tension_N,humidity_pct,T1_N\n";
  for (int i = 0; i < rows; ++i) {
    const double T1_N = 20 * std::exp(-phi - 0.02 * i);
    text += fmt::format("A,M-1-F,20,{},{}\n", i, T1_N + 0.1 * numerics::normal(3, 1, i));
  }
  const MeasuredData data = read_data(text);
  const Dataset dataset = all_of(data);
  const Problem readings = problem(dataset, Eigen::VectorXd::Constant(rows, 0.1));
  Scatter scatter;
  scatter.noise.absolute_N = 0.1;
  Workers workers(1);
  const std::vector<Lead> found =
      leads(all_in_training(dataset), readings, Model{}, scatter, workers);
  ASSERT_FALSE(found.empty());
  for (const Lead& lead : found) {
    Model with_it;
    add_effect(with_it, lead.effect);
    const double gain = (misfit(readings, Model{}) - misfit(readings, with_it)) / 2;
    EXPECT_LT(lead.evidence, gain) << effect_name(lead.effect);
    EXPECT_GT(lead.evidence, gain - most_price) << effect_name(lead.effect);
  }
}

// At one load a gain of T1 is an offset of T1.
TEST(Leads, ThatChangeReadingsAlikeAreOne) {
  const Bench bench(Pattern{0.5}, BenchPlan{8, 6, 3, bench_noise_N});
  Workers workers(1);
  const std::vector<Lead> found =
      leads(all_in_training(bench.dataset), bench.problem, Model{}, bench_scatter(), workers);
  ASSERT_FALSE(found.empty());
  std::set<std::string> names;
  for (const Lead& lead : found) {
    EXPECT_GE(lead.evidence, least_evidence);
    EXPECT_TRUE(names.insert(effect_name(lead.effect)).second);
    for (const Effect& alike : lead.alike) {
      EXPECT_TRUE(names.insert(effect_name(alike)).second) << effect_name(alike);
    }
  }
  EXPECT_FALSE(found.front().alike.empty());
}

TEST(Leads, OfOnePlaceAreThoseOfARunASensorOrAContact) {
  const auto effect = [](const Term& term) { return Effect{&causes::law(term), {}, {0.1}}; };
  Term term;
  EXPECT_FALSE(is_of_one_place(effect(term)));
  term.site.number = 1;
  EXPECT_TRUE(is_of_one_place(effect(term)));
  term.site.number.reset();
  term.site.runs = {"r1"};
  EXPECT_TRUE(is_of_one_place(effect(term)));
  Term gain;
  gain.target = Target::gain;
  gain.site.place = SitePlace::channels;
  EXPECT_FALSE(is_of_one_place(effect(gain)));
  gain.site.place = SitePlace::channel;
  EXPECT_TRUE(is_of_one_place(effect(gain)));
}

}  // namespace
}  // namespace reeve::testing
