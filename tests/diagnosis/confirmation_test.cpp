// Confirmation of a search by its folds, in planted data.
#include "diagnosis/verdict/confirmation.hpp"

#include <gtest/gtest.h>

#include "causes/library.hpp"
#include "diagnosis/search/candidates.hpp"
#include "tests/diagnosis/read_dataset.hpp"
#include "tests/support/planting.hpp"

namespace reeve::testing {
namespace {

TEST(Confirmation, ForecastsWithNothingThatAFoldFindsBesidesWhatIsNamed) {
  PlantingPlan plan;
  plan.effects = {EffectKind::sensor_gain};
  plan.runs = 8;
  const MeasuredData data = read_data(plant(plan, 81).csv);
  const Dataset training = all_of(data);
  const Model nominal;
  const auto tried = candidates(survey(data), nominal.hardware, force_scale(data));
  Workers workers(1);
  const TermSearchOptions options;
  TermSearch search(training, nominal, tried, options, workers);
  Explanation found = search.run([](const char*) {});
  ASSERT_EQ(found.accepted.size(), 1U);
  std::vector<Fold> folds = cross_validated(data, readings_in(training), nominal, search, workers);
  const Forecast of_named = joined(folds, training, &Fold::forecast);
  const Effect besides{causes::find_cause("motor_offset"), {}, {20}};
  add_effect(folds[1].found.model, besides);
  folds[1].found.accepted.emplace_back().effect = besides;
  folds[1].forecast = forecast(folds[1].unseen, folds[1].found.model);
  const auto differ = [&](const Forecast& at) {
    return (at.reading_N - of_named.reading_N).cwiseAbs().maxCoeff();
  };
  const double beside_N = differ(joined(folds, training, &Fold::forecast));
  ASSERT_GT(beside_N, 1);
  Confirmation confirmation(training, nominal, options, std::move(folds), found, workers);
  EXPECT_EQ(confirmation.remove_the_others(), std::vector<std::string>{});
  // The fit without it starts elsewhere, and ends a little elsewhere.
  constexpr double hardly = 1e-2;
  EXPECT_LT(differ(joined(confirmation.folds(), training, &Fold::forecast)), hardly * beside_N);
}

}  // namespace
}  // namespace reeve::testing
