#include "diagnosis/search/law_reference.hpp"

#include <gtest/gtest.h>

#include "causes/library.hpp"

namespace reeve::testing {
namespace {

using causes::Effect;
using causes::Form;
using causes::Term;

constexpr double mu_of_hardware = 0.12, mu_fitted = 0.15;

Effect law_of(Form form, std::vector<double> values) {
  Term term;
  term.site.kind = ContactKind::sheath;
  term.form = form;
  term.x = causes::covariate_named("humidity_pct");
  term.x.middle = 50;
  term.x.seen = {20, 80};
  return {&causes::law(term), {}, std::move(values)};
}

// At each x, by the formulas of the header.
void expect_same_friction(const Effect& before, const Effect& after) {
  const Term& f = *causes::term_of(*before.cause);
  const Term& g = *causes::term_of(*after.cause);
  for (const double x : {20.0, 31.0, 50.0, 80.0}) {
    EXPECT_NEAR(mu_of_hardware * (1 + causes::law_value(g, x, 0, after.values.data())),
                mu_fitted * (1 + causes::law_value(f, x, 0, before.values.data())), 1e-12);
  }
  EXPECT_NEAR(causes::law_value(g, g.x.middle, 0, after.values.data()), 0, 1e-12);
}

TEST(LawReference, MovesToWhereTheHardwareIsRight) {
  for (const Effect& law : {law_of(Form::linear, {0.01}), law_of(Form::log, {0.5}),
                            law_of(Form::power, {1.2, 0.4}), law_of(Form::power, {-0.8, -1.1})}) {
    const auto moved = diagnosis::law_from(mu_of_hardware, mu_fitted, law);
    ASSERT_TRUE(moved);
    expect_same_friction(law, *moved);
  }
  // 0.15 (1 + 0.01 (x - 50)) = 0.12 at x = 30.
  const auto linear = diagnosis::law_from(mu_of_hardware, mu_fitted, law_of(Form::linear, {0.01}));
  EXPECT_NEAR(causes::term_of(*linear->cause)->x.middle, 30, 1e-9);
  EXPECT_NEAR(linear->values[0], 0.0125, 1e-12);
}

TEST(LawReference, StaysWhereTheHardwareIsNowhereRight) {
  EXPECT_FALSE(diagnosis::law_from(mu_of_hardware, mu_fitted, law_of(Form::linear, {0.001})));
  EXPECT_FALSE(diagnosis::law_from(mu_of_hardware, mu_fitted, law_of(Form::power, {0.1, 0.2})));
}

TEST(LawReference, IsOfAllContactsOfTheCoefficient) {
  const Effect sheaths{causes::find_cause("sheath_friction"), {}, {mu_fitted}};
  Term term = *causes::term_of(*law_of(Form::linear, {0.01}).cause);
  EXPECT_TRUE(diagnosis::is_law_of(term, sheaths));
  term.site.finger = 1;
  EXPECT_FALSE(diagnosis::is_law_of(term, sheaths));
  term.site.finger = 0;
  term.site.kind = ContactKind::tube;
  EXPECT_FALSE(diagnosis::is_law_of(term, sheaths));
}

}  // namespace
}  // namespace reeve::testing
