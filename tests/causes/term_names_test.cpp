// Names of laws, sites and covariates, which are read back, and the formulas of laws.
#include <gtest/gtest.h>

#include <cstddef>
#include <optional>
#include <vector>

#include "causes/library.hpp"
#include "causes/term.hpp"
#include "tests/causes/terms.hpp"

namespace reeve {
namespace {

using testing::at;
using testing::channel;
using testing::constant;
using testing::contacts;
using testing::effect_of;
using testing::humidity;
using testing::load;
using testing::logarithmic;
using testing::of_form;
using testing::of_kind;

TEST(Law, IsOneAndTheSameForEqualTerms) {
  const Term term = of_form(Form::linear);
  EXPECT_EQ(&law(term), &law(of_form(Form::linear)));
  Term other = term;
  other.x.seen.high = 81;
  EXPECT_NE(&law(term), &law(other));
  other = term;
  other.site.runs = {"3"};
  EXPECT_NE(&law(term), &law(other));
  EXPECT_EQ(term_of(law(term))->x.column, "humidity_pct");
  EXPECT_EQ(term_of(*find_cause("wear")), nullptr);
}

TEST(Law, IsNamedByTargetSiteCovariateAndForm) {
  EXPECT_EQ(effect_name(effect_of(of_form(Form::linear), {0.01})),
            "law[exponent of sheath, humidity_pct, linear]");
  EXPECT_EQ(effect_name(effect_of(constant(Target::gain, channel("T3")), {0.01})),
            "law[gain of T3]");
  Term product = of_form(Form::product);
  product.y = load(10);
  EXPECT_EQ(effect_name(effect_of(product, {0.01})),
            "law[exponent of sheath, humidity_pct x load, product]");
}

TEST(Law, IsWrittenAsAFormula) {
  const auto written = [](Form form, std::vector<double> values) {
    return formula(of_form(form), values);
  };
  EXPECT_EQ(written(Form::constant, {0.3}), "phi' = phi (1 + 0.3)");
  EXPECT_EQ(written(Form::linear, {0.0083}), "phi' = phi (1 + 0.0083 (humidity_pct - 50))");
  EXPECT_EQ(written(Form::log, {0.5}), "phi' = phi (1 + 0.5 ln(humidity_pct / 50))");
  EXPECT_EQ(written(Form::power, {0.7, 1.5}), "phi' = phi (1 + 0.7 ((humidity_pct / 50)^1.5 - 1))");
  EXPECT_EQ(written(Form::scaling, {0.7, 1.5}), "phi' = phi (1 + 0.7 (humidity_pct / 50)^1.5)");
  EXPECT_EQ(written(Form::quadratic, {0.5, 35}), "phi' = phi (1 + 0.5 (humidity_pct - 35)^2)");
  EXPECT_EQ(written(Form::exponential, {0.6, 40}),
            "phi' = phi (1 + 0.6 (1 - exp(-humidity_pct / 40)))");
  EXPECT_EQ(written(Form::hinge, {0.02, 45}), "phi' = phi (1 + 0.02 max(0, humidity_pct - 45))");
  EXPECT_EQ(written(Form::step, {0.4, 45}), "phi' = phi (1 + 0.4 [humidity_pct > 45])");
  EXPECT_EQ(written(Form::sine, {0.2, -0.1, 30}),
            "phi' = phi (1 + 0.2 sin(2 pi humidity_pct / 30) - 0.1 cos(2 pi humidity_pct / 30))");
  Term product = of_form(Form::product);
  product.y = logarithmic(load(10));
  EXPECT_EQ(formula(product, {0.01}), "phi' = phi (1 + 0.01 (humidity_pct - 50) ln(load / 10))");
  EXPECT_EQ(formula(constant(Target::exponent, contacts(ContactKind::bearing)), {0.1}),
            "phi' = phi + 0.1");
  EXPECT_EQ(formula(constant(Target::force, contacts(ContactKind::tube)), {0.1}),
            "T_low = T_high exp(-phi) - 0.1");
  EXPECT_EQ(formula(constant(Target::force, at(SitePlace::motor)), {0.1}), "T_M' = T_M - 0.1");
  EXPECT_EQ(formula(constant(Target::gain, at(SitePlace::motor)), {0.1}), "T_M' = T_M (1 + 0.1)");
  EXPECT_EQ(formula(constant(Target::offset, channel("T3")), {0.1}), "T' = T + 0.1");
}

TEST(Law, IsWrittenWithTheSignsOfItsNumbers) {
  Covariate cold = humidity();
  cold.middle = -5;
  EXPECT_EQ(formula(of_form(Form::linear, cold), {-0.01}),
            "phi' = phi (1 - 0.01 (humidity_pct + 5))");
  EXPECT_EQ(formula(constant(Target::offset, channel("T3")), {-0.1}), "T' = T - 0.1");
  Term force{Target::force, contacts(ContactKind::tube), Form::sine, humidity()};
  EXPECT_EQ(formula(force, {-0.2, 0.1, 30}),
            "T_low = T_high exp(-phi) + 0.2 sin(2 pi humidity_pct / 30) - "
            "0.1 cos(2 pi humidity_pct / 30)");
}

Site site_of(const char* name) { return site_named(name).value(); }

TEST(SiteName, IsReadBack) {
  for (const char* name : {"motor",
                           "all channels",
                           "T3",
                           "a",
                           "h1",
                           "tube",
                           "sheath",
                           "bearing",
                           "block",
                           "tube of finger 1",
                           "tube of held fingers",
                           "sheath of closing fingers",
                           "bearing of fingers",
                           "tube 2 of the hand in pull of M-1-T-2-F",
                           "tube in release",
                           "tube and sheath",
                           "tube and sheath of finger 2 in pull",
                           "T3 in release",
                           "motor in pull in run 2",
                           "all channels in release",
                           "sheath of held fingers in pull of M-1-F in run 2",
                           "bearing 3",
                           "tube 2 of M-1-T-2-F",
                           "sheath of finger 2 of held fingers of M-1-T-2-M in run 3",
                           "tube in run left glove in group B",
                           "T3 in run 7",
                           "motor in group winch 2",
                           "all channels in run a in run b",
                           "motor in runs m7, m8, m9 in group B",
                           "T1 in group a in run b",
                           "T1 in group a in group b"}) {
    const auto site = site_named(name);
    ASSERT_TRUE(site) << name;
    EXPECT_EQ(site_name(*site), name);
  }
  const Site site =
      site_of("tube 2 of finger 3 of closing fingers in release of M-1-T-2-F in run 4 in group C");
  EXPECT_EQ(site.place, SitePlace::contacts);
  EXPECT_EQ(site.kind, ContactKind::tube);
  EXPECT_EQ(site.number, std::size_t{1});
  EXPECT_EQ(site.finger, 3);
  EXPECT_EQ(site.held, false);
  EXPECT_EQ(site.direction, Direction::release);
  EXPECT_EQ(site.routing, "M-1-T-2-F");
  EXPECT_EQ(site.runs, std::vector<std::string>{"4"});
  EXPECT_EQ(site.group, "C");
  EXPECT_EQ(site_of("T3 in runs 4, 7").runs, (std::vector<std::string>{"4", "7"}));
  EXPECT_EQ(site_of("T3").channel, parse_segment("T3"));
  // The blank before a name is the mark's, even if the name goes on like another mark.
  EXPECT_EQ(site_of("T3 in run in group C").runs, std::vector<std::string>{"in group C"});
  EXPECT_EQ(site_of("T3 in runs in group C, 4").runs,
            (std::vector<std::string>{"in group C", "4"}));
}

TEST(SiteName, OfNothingIsNoSite) {
  for (const char* name :
       {"", "tubes", "T", "T0", "motors", "tube of finger 0", "tube of ", "tube of finger x",
        "tube 0", "sheath of finger 99999999999999999999", "motor of finger 1", "T3 in runs 4, ",
        "channels", "tube of finger 1 2", "tube in run ", "tube 01", "T3 in group ",
        "T3 of finger 1", "tube and sheath 2"}) {
    EXPECT_FALSE(site_named(name)) << name;
  }
}

TEST(CovariateName, IsReadBack) {
  using K = CovariateKind;
  EXPECT_EQ(covariate_named("load").kind, K::load);
  EXPECT_EQ(covariate_named("T2").segment, parse_segment("T2"));
  EXPECT_EQ(covariate_named("motor_tension_N").kind, K::motor);
  EXPECT_EQ(covariate_named("speed_mm_s").kind, K::speed);
  EXPECT_EQ(covariate_named("cycle").kind, K::cycle);
  EXPECT_EQ(covariate_named("temperature_C").kind, K::temperature);
  EXPECT_EQ(covariate_named("humidity_pct").column, "humidity_pct");
  for (const char* name : {"load", "T2", "motor_tension_N", "speed_mm_s", "cycle", "temperature_C",
                           "humidity_pct", "rh", "order", "column load", "column column x"}) {
    EXPECT_EQ(covariate_name(covariate_named(name)), name);
  }
  for (const char* column : {"load", "a", "column", "column x", "supply_V"}) {
    Covariate x;
    x.kind = K::column;
    x.column = column;
    const Covariate back = covariate_named(covariate_name(x));
    EXPECT_EQ(back.kind, K::column) << column;
    EXPECT_EQ(back.column, column);
  }
}

TEST(TermFault, NamesTheTargetCovariateOrFormThatDoesNotFit) {
  const auto at_site = [](Target target, const char* site) {
    return fault(constant(target, site_of(site))).has_value();
  };
  EXPECT_TRUE(at_site(Target::exponent, "T3"));
  EXPECT_TRUE(at_site(Target::exponent, "motor"));
  EXPECT_TRUE(at_site(Target::force, "all channels"));
  EXPECT_TRUE(at_site(Target::gain, "tube"));
  EXPECT_TRUE(at_site(Target::offset, "sheath"));
  EXPECT_FALSE(at_site(Target::exponent, "tube"));
  EXPECT_FALSE(at_site(Target::force, "motor"));
  EXPECT_FALSE(at_site(Target::force, "bearing"));
  EXPECT_FALSE(at_site(Target::gain, "motor"));
  EXPECT_FALSE(at_site(Target::offset, "T3"));

  const auto of_x = [](Form form, Range seen, double middle) {
    Covariate x = humidity();
    x.seen = seen;
    x.middle = middle;
    return fault(of_form(form, x)).has_value();
  };
  EXPECT_FALSE(of_x(Form::linear, {-5, 5}, 0));
  EXPECT_TRUE(of_x(Form::linear, {5, 5}, 5));
  EXPECT_TRUE(of_x(Form::linear, {6, 5}, 5));
  EXPECT_TRUE(of_x(Form::log, {0, 5}, 1));
  EXPECT_TRUE(of_x(Form::power, {1, 5}, 0));
  EXPECT_FALSE(of_x(Form::power, {1, 5}, 2));
  EXPECT_TRUE(of_x(Form::exponential, {-5, 0}, -2));
  EXPECT_FALSE(of_x(Form::exponential, {0, 5}, 2));

  Term tension = of_form(Form::linear, of_kind(CovariateKind::tension, 5, {0, 10}));
  EXPECT_STREQ(fault(tension).value().key, "covariate");
  tension = {Target::gain, channel("T1"), Form::linear, tension.x};
  EXPECT_FALSE(fault(tension));
  Term product = of_form(Form::product);
  product.y = logarithmic(load(10, {0, 20}));
  EXPECT_STREQ(fault(product).value().key, "range");
  product.y.seen.low = 1;
  EXPECT_FALSE(fault(product));
}

}  // namespace
}  // namespace reeve
