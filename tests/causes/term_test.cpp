// Terms against closed forms: on a bench (M-F: a sheath between a and h1), on M-1-T-2-F, and beside
// the causes that have a name of their own.
#include "causes/term.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "tests/causes/rig.hpp"
#include "tests/causes/terms.hpp"
#include "tests/support/random_routing.hpp"

namespace reeve {
namespace {

using testing::at;
using testing::bearing;
using testing::bench;
using testing::channel;
using testing::constant;
using testing::contacts;
using testing::Dice;
using testing::effect;
using testing::effect_of;
using testing::humidity;
using testing::load;
using testing::logarithmic;
using testing::model_with;
using testing::of_channel;
using testing::of_form;
using testing::of_kind;
using testing::pi;
using testing::sheath;
using testing::Solved;
using testing::solved;
using testing::Trial;
using testing::tube;

Model model_of(const Term& term, std::vector<double> values) {
  return model_with({effect_of(term, std::move(values))});
}

void record(Conditions& conditions, std::vector<NamedValue> columns, const char* run = "",
            const char* group = "") {
  conditions.record =
      std::make_shared<const Record>(Record{run, group, {columns.begin(), columns.end()}});
}

double at_humidity(Model model, double humidity_pct) {
  record(model.conditions, {{"order", 0.5}, {"humidity_pct", humidity_pct}});
  return bench(model);
}

struct FormCase {
  Form form;
  std::vector<double> values;
  double (*f)(double x);
};

const std::vector<FormCase>& form_cases() {
  static const std::vector<FormCase> cases{
      {Form::constant, {0.3}, [](double) { return 0.3; }},
      {Form::linear, {0.01}, [](double x) { return 0.01 * (x - 50); }},
      {Form::log, {0.5}, [](double x) { return 0.5 * std::log(x / 50); }},
      {Form::power, {0.7, 1.5}, [](double x) { return 0.7 * (std::pow(x / 50, 1.5) - 1); }},
      {Form::scaling, {0.7, 1.5}, [](double x) { return 0.7 * std::pow(x / 50, 1.5); }},
      {Form::quadratic, {0.0005, 35}, [](double x) { return 0.0005 * (x - 35) * (x - 35); }},
      {Form::exponential, {0.6, 40}, [](double x) { return 0.6 * (1 - std::exp(-x / 40)); }},
      {Form::hinge, {0.02, 45}, [](double x) { return x > 45 ? 0.02 * (x - 45) : 0; }},
      {Form::step, {0.4, 45}, [](double x) { return x > 45 ? 0.4 : 0; }},
      {Form::sine, {0.2, -0.1, 30}, [](double x) {
         return 0.2 * std::sin(pi * x / 15) - 0.1 * std::cos(pi * x / 15);
       }}};
  return cases;
}

TEST(TermForm, ChangesTheExponentByItsLawOfTheColumn) {
  for (const FormCase& c : form_cases()) {
    const Model model = model_of(of_form(c.form), c.values);
    for (const double x : {20.0, 33.0, 50.0, 62.0, 80.0}) {
      EXPECT_NEAR(at_humidity(model, x), std::exp(-sheath * (1 + c.f(x))), 1e-9)
          << form_name(c.form) << " at " << x;
    }
  }
}

TEST(TermForm, IsHeldConstantOutsideTheRangeSeen) {
  for (const FormCase& c : form_cases()) {
    const Model model = model_of(of_form(c.form), c.values);
    EXPECT_NEAR(at_humidity(model, -100), std::exp(-sheath * (1 + c.f(20))), 1e-9)
        << form_name(c.form);
    EXPECT_NEAR(at_humidity(model, 1000), std::exp(-sheath * (1 + c.f(80))), 1e-9)
        << form_name(c.form);
  }
}

TEST(TermForm, OfAColumnThatIsNotRecordedIsThatOfTheMiddle) {
  for (const FormCase& c : form_cases()) {
    Model model = model_of(of_form(c.form), c.values);
    const double expected = std::exp(-sheath * (1 + c.f(50)));
    EXPECT_NEAR(bench(model), expected, 1e-9) << form_name(c.form);
    record(model.conditions, {{"humidity", 70}});
    EXPECT_NEAR(bench(model), expected, 1e-9) << form_name(c.form);
  }
}

TEST(TermForm, ThatIsCentredChangesNothingWhereItsColumnIsNotRecorded) {
  for (const Form form : {Form::linear, Form::log, Form::power}) {
    EXPECT_NEAR(bench(model_of(of_form(form), {0.7, 1.5})), std::exp(-sheath), 1e-9);
  }
}

TEST(TermForm, ProductIsOfTwoFactorsEachLinearOrLogarithmicAndClampedByItself) {
  Covariate speed = of_kind(CovariateKind::speed, 10, {2, 40});
  Term term = of_form(Form::product);
  term.y = logarithmic(speed);
  Model model = model_of(term, {0.01});
  record(model.conditions, {{"humidity_pct", 60}});
  model.conditions.speed_mm_s = 20;
  EXPECT_NEAR(bench(model), std::exp(-sheath * (1 + 0.01 * 10 * std::log(2.0))), 1e-9);
  record(model.conditions, {{"humidity_pct", 95}});
  model.conditions.speed_mm_s = 1;
  EXPECT_NEAR(bench(model), std::exp(-sheath * (1 + 0.01 * 30 * std::log(0.2))), 1e-9);
  model.conditions.record = nullptr;
  EXPECT_NEAR(bench(model), std::exp(-sheath), 1e-9);

  term.x = logarithmic(humidity());
  term.y = speed;
  model = model_of(term, {0.02});
  record(model.conditions, {{"humidity_pct", 70}});
  model.conditions.speed_mm_s = 25;
  EXPECT_NEAR(bench(model), std::exp(-sheath * (1 + 0.02 * std::log(1.4) * 15)), 1e-9);
}

TEST(TermForm, HasAsManyParametersAsItsNumberSaysTheFirstNominallyZero) {
  std::vector<FormCase> cases = form_cases();
  cases.push_back({Form::product, {1}, nullptr});
  for (const FormCase& c : cases) {
    Term term = of_form(c.form);
    term.y = load(10);
    const std::vector<Parameter> parameters = law(term).parameters({});
    ASSERT_EQ(parameters.size(), c.values.size()) << form_name(c.form);
    EXPECT_EQ(parameters.front().nominal, 0);
    for (const Parameter& parameter : parameters) {
      EXPECT_LT(parameter.range.low, parameter.range.high) << form_name(c.form);
    }
  }
}

TEST(TermTarget, ExponentScalesTubesAndSheathsAndIsAddedAtBearings) {
  const Solved scaled =
      solved(model_of(constant(Target::exponent, contacts(ContactKind::tube)), {0.5}), "M-1-T-2-F");
  EXPECT_NEAR(scaled["T4"], std::exp(-sheath - 1.5 * 3 * tube), 1e-9);
  const Solved added = solved(
      model_of(constant(Target::exponent, contacts(ContactKind::bearing)), {0.1}), "M-1b-B-2b-F");
  EXPECT_NEAR(added["T4"], std::exp(-sheath - 3 * (bearing + 0.1)), 1e-9);
}

TEST(TermTarget, ExponentIsNotBelowZero) {
  EXPECT_NEAR(bench(model_of(constant(Target::exponent, contacts(ContactKind::sheath)), {-1.5})), 1,
              1e-9);
  const Solved s = solved(
      model_of(constant(Target::exponent, contacts(ContactKind::bearing)), {-0.1}), "M-1b-B-2b-F");
  EXPECT_NEAR(s["T4"], std::exp(-sheath), 1e-9);
}

TEST(TermTarget, ForceIsTakenOfTheLowerTensionInEitherDirection) {
  const Model model = model_of(constant(Target::force, contacts(ContactKind::sheath)), {0.4});
  EXPECT_NEAR(10 * bench(model), 10 * std::exp(-sheath) - 0.4, 1e-8);
  EXPECT_NEAR(10 * bench(model, Direction::release), 10.4 * std::exp(sheath), 1e-7);
}

TEST(TermTarget, ForceThatHelpsLeavesNoMoreThanThereWas) {
  EXPECT_NEAR(bench(model_of(constant(Target::force, contacts(ContactKind::sheath)), {-50})), 1,
              1e-9);
}

double tendon_N(const Model& model, Direction direction) {
  return at_tendon(model, direction, model.conditions).motor_tension_N;
}

TEST(TermTarget, OfTheMotorChangesWhatArrivesAtTheTendon) {
  const Site motor = at(SitePlace::motor);
  const auto after = [&](Target target, Direction direction) {
    Model model = model_of(constant(target, motor), {0.3});
    model.conditions.motor_tension_N = 20;
    return tendon_N(model, direction);
  };
  EXPECT_NEAR(after(Target::force, Direction::pull), 19.7, 1e-9);
  EXPECT_NEAR(after(Target::force, Direction::release), 20.3, 1e-9);
  for (const Direction direction : {Direction::pull, Direction::release}) {
    EXPECT_NEAR(after(Target::offset, direction), 20.3, 1e-9);
    EXPECT_NEAR(after(Target::gain, direction), 26, 1e-9);
  }
}

std::array<double, 2> read_two(const Model& model, double T1, double T2,
                               Direction direction = Direction::pull) {
  std::array<Sensor, 2> sensors{{{parse_segment("T1"), T1}, {parse_segment("T2"), T2}}};
  read(model, direction, model.conditions, sensors);
  return {sensors[0].reading_N, sensors[1].reading_N};
}

TEST(TermTarget, OfChannelsChangesWhatTheyRead) {
  using Two = std::array<double, 2>;
  const Term gain = constant(Target::gain, channel("T2"));
  EXPECT_EQ(read_two(model_of(gain, {0.5}), 8, 4), (Two{8, 6}));
  const Term offset = constant(Target::offset, channel("T1"));
  EXPECT_EQ(read_two(model_of(offset, {-0.5}), 8, 4), (Two{7.5, 4}));
  const Term all = constant(Target::gain, at(SitePlace::channels));
  EXPECT_EQ(read_two(model_of(all, {0.5}), 8, 4), (Two{12, 6}));
}

TEST(TermTarget, OfMoreChannelsThanEightChangesEach) {
  std::vector<Sensor> sensors;
  for (int i = 1; i <= 12; ++i) sensors.push_back({{SegmentKind::strand, i, (i + 1) / 2}, 1.0 * i});
  read(model_of(constant(Target::offset, at(SitePlace::channels)), {0.5}), Direction::pull, {},
       sensors);
  for (int i = 1; i <= 12; ++i) {
    EXPECT_EQ(sensors[static_cast<std::size_t>(i - 1)].reading_N, i + 0.5);
  }
}

TEST(TermCovariate, OfAnotherChannelIsWhatItReadsAtTheSameTime) {
  Term term{Target::offset, channel("T1"), Form::linear,
            of_kind(CovariateKind::tension, 5, {0, 20})};
  term.x.segment = parse_segment("T2");
  const Model model = model_of(term, {0.1});
  EXPECT_NEAR(read_two(model, 8, 9)[0], 8.4, 1e-12);
  EXPECT_NEAR(read_two(model, 8, 90)[0], 9.5, 1e-12);
  EXPECT_NEAR(reading(model, parse_segment("T1"), 8), 8, 1e-12);  // without T2
}

// Both from what there was before either changed.
TEST(TermCovariate, OfAnotherChannelIsSeenBeforeTheTermChangesIt) {
  Term term{Target::offset, at(SitePlace::channels), Form::linear,
            of_kind(CovariateKind::tension, 0, {0, 20})};
  term.x.segment = parse_segment("T1");
  const std::array<double, 2> read = read_two(model_of(term, {0.5}), 8, 4);
  EXPECT_NEAR(read[0], 12, 1e-12);
  EXPECT_NEAR(read[1], 8, 1e-12);
}

TEST(TermCovariate, LoadOfAChannelIsItsOwnTension) {
  const Term term{Target::gain, channel("T1"), Form::linear, load(5, {0, 10})};
  const Model model = model_of(term, {0.02});
  EXPECT_NEAR(read_two(model, 8, 8)[0], 8 * 1.06, 1e-12);
  EXPECT_NEAR(read_two(model, 80, 8)[0], 80 * 1.1, 1e-12);
  EXPECT_FALSE(reads_linearly(model));
  EXPECT_TRUE(reads_linearly(model_of(constant(Target::gain, channel("T1")), {0.02})));
}

TEST(TermCovariate, OfTheConditionsIsWhatTheySay) {
  const auto exponent = [](const Covariate& x, const Conditions& conditions) {
    Model model = model_of(of_form(Form::linear, x), {0.02});
    model.conditions = conditions;
    return -std::log(bench(model)) / sheath;
  };
  using K = CovariateKind;
  const Conditions conditions{30, 25, 40, 35};
  EXPECT_NEAR(exponent(of_kind(K::motor, 20, {0, 100}), conditions), 1.2, 1e-9);
  EXPECT_NEAR(exponent(of_kind(K::speed, 20, {0, 100}), conditions), 1.1, 1e-9);
  EXPECT_NEAR(exponent(of_kind(K::cycle, 20, {0, 100}), conditions), 1.4, 1e-9);
  EXPECT_NEAR(exponent(of_kind(K::temperature, 20, {0, 100}), conditions), 1.3, 1e-9);
}

// T1, T2, T3, T4 in turn, each contact behind the one before it.
TEST(TermCovariate, LoadOfAContactIsTheHigherTensionBesideIt) {
  for (const FormCase& c : form_cases()) {
    if (c.form == Form::step) continue;
    Term term = of_form(c.form, load(50, {20, 80}));
    term.site = contacts(ContactKind::tube);
    Model model = model_of(term, c.values);
    model.conditions.motor_tension_N = 300;
    const Solved s = solved(model, "M-1-T-2-F");
    ASSERT_TRUE(s.converged) << form_name(c.form);
    double high = 300 * std::exp(-sheath);
    for (const char* strand : {"T2", "T3", "T4"}) {
      high *= std::exp(-tube * std::max(0.0, 1 + c.f(std::clamp(high, 20.0, 80.0))));
      EXPECT_NEAR(300 * s[strand], high, 1e-6) << form_name(c.form) << " " << strand;
    }
  }
}

// T_h1 = T_M e^{phi (1 + a (T_h1 - x0))}
TEST(TermCovariate, LoadOfAContactIsThatOfTheHandSideWhenReleasing) {
  const Model model = model_of(of_form(Form::linear, load(20)), {0.01});
  const double h1 = 10 * bench(model, Direction::release);
  EXPECT_NEAR(h1, 10 * std::exp(sheath * (1 + 0.01 * (h1 - 20))), 1e-6);
}

// What each segment of M-1-T-2-F, finger 1 held, says of the contact before it: sheath, tip 1,
// join, tip 2; relative to what the plain exponents leave.
std::array<double, 4> factors(const Site& site, Conditions conditions = {}) {
  Model model = model_of(constant(Target::exponent, site), {0.5});
  model.conditions = std::move(conditions);
  const Solved s = solved(model, "M-1-T-2-F", hold({1}));
  const auto factor = [](double low, double high, double phi) {
    return std::round(-std::log(low / high) / phi * 1e6) / 1e6;
  };
  return {factor(s["T1"], 1, sheath), factor(s["T2"], s["T1"], tube),
          factor(s["T3"], s["T2"], tube), factor(s["T4"], s["T3"], tube)};
}

TEST(TermSite, RestrictsWhichContactsATermActsOn) {
  using Four = std::array<double, 4>;
  EXPECT_EQ(factors(contacts(ContactKind::sheath)), (Four{1.5, 1, 1, 1}));
  EXPECT_EQ(factors(contacts(ContactKind::tube)), (Four{1, 1.5, 1.5, 1.5}));
  EXPECT_EQ(factors(contacts(ContactKind::bearing)), (Four{1, 1, 1, 1}));
  Site site = contacts(ContactKind::tube);
  site.finger = 2;
  EXPECT_EQ(factors(site), (Four{1, 1, 1, 1.5}));
  site.kind = ContactKind::sheath;
  site.finger = 1;
  EXPECT_EQ(factors(site), (Four{1.5, 1, 1, 1}));
  site = contacts(ContactKind::tube);
  site.held = true;
  EXPECT_EQ(factors(site), (Four{1, 1.5, 1, 1}));
  site.held = false;
  EXPECT_EQ(factors(site), (Four{1, 1, 1, 1.5}));
  site = contacts(ContactKind::tube);
  site.direction = Direction::pull;
  EXPECT_EQ(factors(site), (Four{1, 1.5, 1.5, 1.5}));
  site.direction = Direction::release;
  EXPECT_EQ(factors(site), (Four{1, 1, 1, 1}));
  site = contacts(ContactKind::tube);
  site.with_sheaths = true;
  EXPECT_EQ(factors(site), (Four{1.5, 1.5, 1.5, 1.5}));
  site = contacts(ContactKind::tube);
  site.number = 1;
  EXPECT_EQ(factors(site), (Four{1, 1, 1.5, 1}));
  site = contacts(ContactKind::tube);
  site.routing = "M-1-T-2-F";
  EXPECT_EQ(factors(site), (Four{1, 1.5, 1.5, 1.5}));
  site.routing = "M-1-T-2-M";
  EXPECT_EQ(factors(site), (Four{1, 1, 1, 1}));
}

TEST(TermSite, RestrictsInWhichRunsAndGroupsATermActs) {
  const auto acts = [](const Site& site, const char* run, const char* group) {
    Conditions conditions;
    record(conditions, {}, run, group);
    return factors(site, conditions)[0] != 1;
  };
  Site site = contacts(ContactKind::sheath);
  EXPECT_TRUE(acts(site, "3", "A"));
  site.runs = {"3"};
  EXPECT_TRUE(acts(site, "3", "A"));
  EXPECT_FALSE(acts(site, "4", "A"));
  site.group = "A";
  EXPECT_TRUE(acts(site, "3", "A"));
  EXPECT_FALSE(acts(site, "3", "B"));
  EXPECT_EQ(factors(site)[0], 1);  // no record
  site.runs = {};
  EXPECT_TRUE(acts(site, "4", "A"));
}

TEST(TermSite, OfARunRestrictsMotorAndChannelsLikewise) {
  Site site = at(SitePlace::motor);
  site.runs = {"3"};
  Model motor = model_of(constant(Target::gain, site), {0.5});
  site = channel("T1");
  site.runs = {"3"};
  Model sensor = model_of(constant(Target::gain, site), {0.5});
  for (const char* run : {"3", "4"}) {
    const bool here = *run == '3';
    record(motor.conditions, {}, run);
    record(sensor.conditions, {}, run);
    EXPECT_EQ(tendon_N(motor, Direction::pull), here ? 15 : 10);
    EXPECT_EQ(read_two(sensor, 8, 4)[0], here ? 12 : 8);
  }
}

TEST(TermSite, OfADirectionRestrictsMotorAndChannelsLikewise) {
  Site site = at(SitePlace::motor);
  site.direction = Direction::release;
  const Model motor = model_of(constant(Target::gain, site), {0.5});
  EXPECT_EQ(tendon_N(motor, Direction::pull), 10);
  EXPECT_EQ(tendon_N(motor, Direction::release), 15);
  site = channel("T1");
  site.direction = Direction::release;
  const Model sensor = model_of(constant(Target::gain, site), {0.5});
  EXPECT_EQ(read_two(sensor, 8, 4, Direction::pull)[0], 8);
  EXPECT_EQ(read_two(sensor, 8, 4, Direction::release)[0], 12);
}

TEST(TermSite, OfAFingerTellsTheFingersApart) {
  Site site = contacts(ContactKind::tube);
  EXPECT_TRUE(treats_fingers_alike(model_of(constant(Target::exponent, site), {0.1}), 2));
  site.finger = 3;
  const Model model = model_of(constant(Target::exponent, site), {0.1});
  EXPECT_TRUE(treats_fingers_alike(model, 2));
  EXPECT_FALSE(treats_fingers_alike(model, 3));
}

// ---- one grammar: what the library names is a term, too ----

struct Twin {
  Effect named;
  Effect term;
};

std::vector<Twin> twins() {
  const Site sheaths = contacts(ContactKind::sheath);
  const Site motor = at(SitePlace::motor);
  using K = CovariateKind;
  const Covariate cycle = of_kind(K::cycle, 0, {0, 1e4});
  const Covariate warmth = of_kind(K::temperature, 20, {-10, 60});
  const Covariate speed = of_kind(K::speed, 10, {0.1, 1000});
  const Covariate from_rest = of_kind(K::speed, 0, {0, 1000});
  return {
      {effect("sheath_friction", {0.27}), effect_of(constant(Target::exponent, sheaths), {0.5})},
      {effect("wear", {-0.4, 500}), effect_of(of_form(Form::exponential, cycle), {-0.4, 500})},
      {effect("temperature", {0.01}), effect_of(of_form(Form::linear, warmth), {-0.01})},
      {effect("speed_dependent_friction", {0.1}), effect_of(of_form(Form::log, speed), {0.1})},
      {effect("load_dependent_friction", {0.2}),
       effect_of(of_form(Form::power, load(10, {1e-3, 1e4})), {1, -0.2})},
      {effect("bending_stiffness", {0.3}), effect_of(constant(Target::force, sheaths), {0.3})},
      {effect("constant_loss", {2}), effect_of(constant(Target::force, motor), {2})},
      {effect("viscous_loss", {0.05}),
       effect_of({Target::force, motor, Form::linear, from_rest}, {0.05})},
      {effect("motor_gain", {1.2}), effect_of(constant(Target::gain, motor), {0.2})},
      {effect("motor_offset", {-1.5}), effect_of(constant(Target::offset, motor), {-1.5})}};
}

TEST(OneGrammar, TermsDoWhatTheCausesOfTheLibraryDo) {
  for (const Twin& twin : twins()) {
    const auto of = [&](const Effect& effect, Direction direction, const Conditions& conditions) {
      Model model = model_with({effect});
      model.conditions = at_tendon(model, direction, conditions);
      return model.conditions.motor_tension_N * bench(model, direction);
    };
    for (int seed = 0; seed < 20; ++seed) {
      Dice dice(static_cast<std::uint64_t>(seed));
      const Conditions conditions{dice.real(10, 60), dice.log_real(1, 100), dice.real(0, 2000),
                                  dice.real(0, 40)};
      for (const Direction direction : {Direction::pull, Direction::release}) {
        const double expected = of(twin.named, direction, conditions);
        EXPECT_NEAR(of(twin.term, direction, conditions), expected, 1e-7 * expected)
            << effect_name(twin.named);
      }
    }
  }
}

TEST(OneGrammar, TermsAtBearingsDoWhatBearingDragDoes) {
  const Model named = model_with({effect("bearing_drag", {0.2})});
  const Model term = model_of(constant(Target::force, contacts(ContactKind::bearing)), {0.2});
  for (const Direction direction : {Direction::pull, Direction::release}) {
    const Solved expected = solved(named, "M-1b-B-2b-F", {}, direction);
    const Solved found = solved(term, "M-1b-B-2b-F", {}, direction);
    EXPECT_EQ(found.state.tension, expected.state.tension);
  }
}

TEST(OneGrammar, TermsOfChannelsDoWhatGainOffsetDriftAndPretensionDo) {
  Covariate order;
  order.kind = CovariateKind::column;
  order.column = "order";
  order.seen = {0, 1};
  Conditions conditions;
  conditions.order = 0.7;
  record(conditions, {{"order", 0.7}});
  const auto same = [&](const Effect& named, const Effect& term) {
    Model of_named = model_with({named});
    Model of_term = model_with({term});
    of_named.conditions = of_term.conditions = conditions;
    const auto expected = read_two(of_named, 8, 4);
    const auto found = read_two(of_term, 8, 4);
    EXPECT_NEAR(found[0], expected[0], 1e-12) << effect_name(named);
    EXPECT_NEAR(found[1], expected[1], 1e-12) << effect_name(named);
    EXPECT_NE(found[0], 8) << effect_name(named);
  };
  const Subject T1 = of_channel("T1");
  same(effect("sensor_gain", {1.08}, T1), effect_of(constant(Target::gain, channel("T1")), {0.08}));
  same(effect("sensor_offset", {0.4}, T1),
       effect_of(constant(Target::offset, channel("T1")), {0.4}));
  same(effect("drift", {3}, T1),
       effect_of({Target::offset, channel("T1"), Form::linear, order}, {3}));
  same(effect("pretension", {2}),
       effect_of(constant(Target::offset, at(SitePlace::channels)), {2}));
}

// Over all routings, grasps and directions, laws of the size that rigs have. A step of the load
// has no solution where the tension behind it falls below the step again.
TEST(TermsOfLoad, AreSolvedForNearlyAllRoutings) {
  std::size_t unconverged = 0;
  for (std::uint64_t seed = 1; seed <= 1500; ++seed) {
    const Trial trial = testing::random_trial(seed);
    Dice dice(seed + 1'000'000);
    const ContactKind kind = dice.chance(0.5) ? ContactKind::tube : ContactKind::sheath;
    Model model{trial.hardware};
    model.conditions.motor_tension_N = dice.log_real(5, 200);
    const Covariate x = load(20, {0.5, 100});
    const auto add = [&](Form form, std::vector<double> values) {
      add_effect(model, effect_of({Target::exponent, contacts(kind), form, x}, std::move(values)));
    };
    switch (seed % 6) {
      case 0:
        add(Form::linear, {dice.real(-0.005, 0.01)});
        break;
      case 1:
        add(Form::log, {dice.real(-0.15, 0.15)});
        break;
      case 2:
        add(Form::power, {dice.real(0, 1), dice.real(-0.3, 0.3)});
        break;
      case 3:
        add(Form::exponential, {dice.real(-0.5, 0.5), dice.real(5, 50)});
        break;
      case 4:
        add(Form::hinge, {dice.real(0, 0.01), dice.real(5, 50)});
        break;
      default:
        add(Form::sine, {dice.real(-0.1, 0.1), dice.real(-0.1, 0.1), dice.real(30, 60)});
    }
    const Solved s = solved(model, trial.routing, trial.grasp, trial.direction);
    for (const double tension : s.state.tension) EXPECT_TRUE(std::isfinite(tension));
    unconverged += s.converged ? 0 : 1;
  }
  EXPECT_LE(unconverged, 2);
}

}  // namespace
}  // namespace reeve
