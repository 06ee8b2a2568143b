#include "reports/law_words.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "causes/library.hpp"
#include "reports/diagnosis/diagnosis_report.hpp"
#include "reports/diagnosis/diagnosis_words.hpp"
#include "reports/model_text.hpp"

namespace reeve::testing {
namespace {

Covariate over_range(const char* name, Range seen = {20, 80}) {
  Covariate x = covariate_named(name);
  x.seen = seen;
  x.middle = (seen.low + seen.high) / 2;
  return x;
}

Term law_at(Target target, const char* site, Form form = Form::linear,
            const char* covariate = "humidity_pct") {
  Term term{target, site_named(site).value(), form};
  if (form != Form::constant) term.x = over_range(covariate);
  return term;
}

std::string said(Target target, const char* site, const char* covariate, double a) {
  return law_meaning(law_at(target, site, Form::linear, covariate), {a});
}

TEST(LawMeaning, NamesWhatTheSiteHas) {
  using T = Target;
  EXPECT_EQ(said(T::exponent, "sheath", "humidity_pct", 1),
            "sheath friction grows with humidity_pct");
  EXPECT_EQ(said(T::exponent, "tube of finger 1", "cycle", -1),
            "tube friction of finger 1 falls with cycle");
  EXPECT_EQ(said(T::exponent, "bearing of held fingers in run 3", "speed_mm_s", 1),
            "bearing friction of held fingers in run 3 grows with speed_mm_s");
  EXPECT_EQ(said(T::exponent, "tube 2 of M-1-F", "load", 1),
            "friction of tube 2 of M-1-F grows with the load");
  EXPECT_EQ(said(T::force, "bearing", "speed_mm_s", 1),
            "the force that each bearing takes grows with speed_mm_s");
  EXPECT_EQ(said(T::force, "sheath 1", "load", 1),
            "the force that sheath 1 takes grows with the load");
  EXPECT_EQ(said(T::force, "motor", "speed_mm_s", 1),
            "the force lost between motor and tendon grows with speed_mm_s");
  EXPECT_EQ(said(T::gain, "T3", "supply_V", -1), "the gain of T3 falls with supply_V");
  EXPECT_EQ(said(T::gain, "motor", "supply_V", 1), "the gain of the motor grows with supply_V");
  EXPECT_EQ(said(T::offset, "all channels in group B", "T2", 1),
            "the offset of all channels in group B grows with the tension at T2");
  EXPECT_EQ(said(T::offset, "motor", "temperature_C", 1),
            "the offset of the motor grows with temperature_C");
}

std::string of(Form form, std::vector<double> values) {
  return law_meaning(law_at(Target::exponent, "sheath", form), values);
}

TEST(LawMeaning, SaysHowItChangesOverTheRangeSeen) {
  EXPECT_EQ(of(Form::constant, {0.1}), "sheath friction is greater than in the nominal model");
  EXPECT_EQ(of(Form::constant, {-0.1}), "sheath friction is smaller than in the nominal model");
  EXPECT_EQ(of(Form::linear, {0.1}), "sheath friction grows with humidity_pct");
  EXPECT_EQ(of(Form::log, {-0.1}), "sheath friction falls with humidity_pct");
  EXPECT_EQ(of(Form::power, {0.1, -2}), "sheath friction falls with humidity_pct");
  EXPECT_EQ(of(Form::power, {-0.1, -2}), "sheath friction grows with humidity_pct");
  EXPECT_EQ(of(Form::exponential, {-0.3, 20}), "sheath friction falls with humidity_pct");
  EXPECT_EQ(of(Form::quadratic, {0.1, 10}), "sheath friction grows with humidity_pct");
  EXPECT_EQ(of(Form::quadratic, {0.1, 90}), "sheath friction falls with humidity_pct");
  EXPECT_EQ(of(Form::quadratic, {0.1, 50}), "sheath friction rises and falls with humidity_pct");
  EXPECT_EQ(of(Form::sine, {0.1, 0.2, 20}), "sheath friction rises and falls with humidity_pct");
  EXPECT_EQ(of(Form::sine, {0.1, 0, 600}), "sheath friction grows with humidity_pct");
  EXPECT_EQ(of(Form::hinge, {0.1, 45.25}), "sheath friction grows with humidity_pct above 45.25");
  EXPECT_EQ(of(Form::hinge, {-0.1, 45}), "sheath friction falls with humidity_pct above 45");
  EXPECT_EQ(of(Form::step, {0.1, 45}), "sheath friction is greater where humidity_pct is above 45");
  EXPECT_EQ(of(Form::step, {-0.1, 45}),
            "sheath friction is smaller where humidity_pct is above 45");
}

Term product(const char* x, const char* y) {
  Term term = law_at(Target::offset, "T1", Form::product, x);
  term.y = over_range(y, {1, 9});
  return term;
}

TEST(LawMeaning, OfAProductNamesBothCovariates) {
  EXPECT_EQ(law_meaning(product("speed_mm_s", "load"), {0.1}),
            "the offset of T1 depends on speed_mm_s and the load together");
}

TEST(LawUnit, IsOfTheTargetOverTheCovariate) {
  const auto units = [](const Term& term) {
    std::vector<std::string> each;
    const std::size_t count = causes::law(term).parameters({}).size();
    for (std::size_t i = 0; i < count; ++i) each.push_back(law_unit(term, i));
    return each;
  };
  using Units = std::vector<std::string>;
  const auto exponent = [](Form form, const char* x) {
    return law_at(Target::exponent, "sheath", form, x);
  };
  EXPECT_EQ(units(exponent(Form::constant, "load")), Units{"1"});
  EXPECT_EQ(units(exponent(Form::linear, "humidity_pct")), Units{"1/humidity_pct"});
  EXPECT_EQ(units(exponent(Form::linear, "cycle")), Units{"1"});
  EXPECT_EQ(units(exponent(Form::log, "load")), Units{"1"});
  EXPECT_EQ(units(exponent(Form::power, "load")), (Units{"1", "1"}));
  EXPECT_EQ(units(law_at(Target::force, "tube", Form::scaling, "load")), (Units{"N", "1"}));
  EXPECT_EQ(units(exponent(Form::quadratic, "load")), (Units{"1/N/N", "N"}));
  EXPECT_EQ(units(exponent(Form::exponential, "temperature_C")), (Units{"1", "C"}));
  EXPECT_EQ(units(exponent(Form::hinge, "speed_mm_s")), (Units{"1/(mm/s)", "mm/s"}));
  EXPECT_EQ(units(exponent(Form::step, "T2")), (Units{"1", "N"}));
  EXPECT_EQ(units(exponent(Form::sine, "motor_tension_N")), (Units{"1", "1", "N"}));
  EXPECT_EQ(units(law_at(Target::force, "bearing", Form::linear, "load")), Units{"N/N"});
  EXPECT_EQ(units(law_at(Target::offset, "T1", Form::constant)), Units{"N"});
  Term two = product("speed_mm_s", "load");
  EXPECT_EQ(units(two), Units{"N/(mm/s)/N"});
  two.x.logarithmic = true;
  EXPECT_EQ(units(two), Units{"N/N"});
}

TEST(LawJson, HasTheFieldsOfTheTerm) {
  const Json json = law_json(law_at(Target::exponent, "tube of finger 1"));
  const Json expected{
      {"site", "tube of finger 1"}, {"acts_on", "exponent"}, {"covariate", "humidity_pct"},
      {"form", "linear"},           {"middle", 50.0},        {"range", {20.0, 80.0}}};
  EXPECT_EQ(json, expected);
  const Json constant = law_json(law_at(Target::gain, "T3", Form::constant));
  EXPECT_TRUE(constant["covariate"].is_null());
  EXPECT_TRUE(constant["range"].is_null());
  const Json two = law_json(product("speed_mm_s", "load"));
  EXPECT_EQ(two["covariate"], "speed_mm_s x load");
  EXPECT_EQ(two["range"], Json::parse("[[20.0, 80.0], [1.0, 9.0]]"));
  EXPECT_EQ(two["middle"], Json::parse("[50.0, 5.0]"));
  EXPECT_EQ(two["logarithmic"], Json::parse("[false, false]"));
}

// ---- of a model ----

Model with_law(const Term& term, std::vector<double> values) {
  Model model;
  add_effect(model, {&law(term), {}, std::move(values)});
  return model;
}

void set_column(Model& model, const char* column, double value) {
  model.conditions.record = std::make_shared<const Record>(Record{"", "", {{column, value}}});
}

std::vector<std::string> lines_of(const Model& model) {
  std::vector<std::string> lines;
  for (const DocumentLine& line : model_lines(model, 0)) lines.push_back(line.text);
  return lines;
}

TEST(ModelLines, SayTheLawAndTheColumnsThatItAsksFor) {
  Model model = with_law(law_at(Target::exponent, "sheath"), {0.0083});
  EXPECT_EQ(
      lines_of(model),
      std::vector<std::string>{
          "Model with sheath: phi' = phi (1 + 0.0083 (humidity_pct - 50)), at motor_tension_N "
          "10, speed_mm_s 10, cycle 0, temperature_C 20, humidity_pct 50"});
  set_column(model, "humidity_pct", 65);
  EXPECT_EQ(model_json(model, 0)["conditions"]["humidity_pct"], 65);
  EXPECT_EQ(model_json(model, 0)["outside_range"], Json::array());
  const Json effect = model_json(model, 0)["effects"][0];
  EXPECT_EQ(effect["cause"], "law");
  EXPECT_EQ(effect["subject"]["site"], "sheath");
  EXPECT_EQ(effect["values"]["a"], 0.0083);
  EXPECT_EQ(effect["in_designs"], true);
}

TEST(ModelLines, SayWhereAConditionLiesOutsideTheRangeSeen) {
  Model model = with_law(law_at(Target::exponent, "sheath"), {0.0083});
  set_column(model, "humidity_pct", 90);
  const std::string note =
      "humidity_pct = 90 lies outside 20 to 80, where the law was seen: it is held constant there";
  EXPECT_EQ(lines_of(model).at(1), "Note: " + note);
  EXPECT_EQ(model_json(model, 0)["outside_range"], Json::array({note}));
  set_column(model, "humidity_pct", 10);
  EXPECT_EQ(lines_of(model).size(), 2U);
  set_column(model, "humidity_pct", 80);
  EXPECT_EQ(lines_of(model).size(), 1U);
}

TEST(ModelLines, SayWhereLoadsReachBeyondTheRangeSeen) {
  Model model = with_law(law_at(Target::exponent, "sheath", Form::linear, "load"), {0.001});
  EXPECT_EQ(lines_of(model).size(), 1U);  // below it, as some load of each design is
  model.conditions.motor_tension_N = 100;
  EXPECT_EQ(
      lines_of(model).at(1),
      "Note: load up to 100 lies outside 20 to 80, where the law was seen: it is held constant "
      "there");
}

TEST(ModelLines, LeaveOutLawsOfTheRig) {
  Model model = with_law(law_at(Target::exponent, "sheath in run 3"), {0.0083});
  set_column(model, "humidity_pct", 90);
  const std::vector<std::string> lines = lines_of(model);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0],
            "Model with no effect on designs, at motor_tension_N 10, speed_mm_s 10, cycle 0, "
            "temperature_C 20");
  EXPECT_NE(lines[1].find("Left out"), std::string::npos);
}

TEST(AbsentFingers, AreSaidOfLawsToo) {
  const Model model = with_law(law_at(Target::exponent, "tube of finger 3"), {0.01});
  EXPECT_EQ(model_notes(model, 3).size(), 0U);
  EXPECT_EQ(
      model_notes(model, 2),
      std::vector<std::string>{"law[exponent of tube of finger 3, humidity_pct, linear] of the "
                               "model changes nothing: no routing here has a finger 3"});
}

// ---- of a diagnosis ----

NamedCause named_law() {
  NamedCause cause;
  cause.effect = {&law(law_at(Target::exponent, "sheath")), {}, {0.0083}};
  cause.name = effect_name(cause.effect);
  cause.parameters = {{"a", "1", 0.0083, 0.0079, 0.0087, 0, {}, false}};
  return cause;
}

TEST(CauseSentence, OfALawIsItsMeaningItsFormulaAndItsIntervals) {
  EXPECT_EQ(cause_sentence(named_law()),
            "sheath friction grows with humidity_pct: phi' = phi (1 + 0.0083 (humidity_pct - 50)), "
            "95 % interval of a 0.0079 to 0.0087");
  NamedCause hinge = named_law();
  hinge.effect = {&law(law_at(Target::exponent, "sheath", Form::hinge)), {}, {0.01, 45}};
  hinge.parameters = {{"a", "1", 0.01, 0.008, 0.012, 0, {}, false},
                      {"b", "", 45, 40, 50, std::nullopt, {}, false}};
  EXPECT_EQ(cause_sentence(hinge),
            "sheath friction grows with humidity_pct above 45: phi' = phi (1 + 0.01 max(0, "
            "humidity_pct - 45)), 95 % intervals of a 0.0080 to 0.0120, of b 40 to 50");
}

TEST(LawsOfADiagnosis, StandBesideItsCausesWithAllTheirParts) {
  DiagnosisReport report;
  report.result.verdict = Verdict::cause;
  NamedCause wear;
  wear.name = "wear";
  wear.effect = {find_cause("wear"), {}, {0.1, 100}};
  wear.meaning = "friction of tubes and sheaths runs in (or out) with the cycles";
  report.result.causes = {wear, named_law()};
  const Json json = Json::parse(diagnosis_json(report));
  ASSERT_EQ(json["causes"].size(), 1U);
  EXPECT_EQ(json["causes"][0]["name"], "wear");
  ASSERT_EQ(json["laws"].size(), 1U);
  const Json& law = json["laws"][0];
  std::string keys;
  for (const auto& [key, value] : law.items()) keys += key + " ";
  EXPECT_EQ(
      keys,
      "name explained parameters held_out only_run p_value evidence probability folds runner_up "
      "partial_residuals site acts_on covariate form middle range formula text ");
  EXPECT_EQ(law["name"], "law[exponent of sheath, humidity_pct, linear]");
  EXPECT_EQ(law["site"], "sheath");
  EXPECT_EQ(law["formula"], "phi' = phi (1 + 0.0083 (humidity_pct - 50))");
  EXPECT_EQ(law["parameters"][0]["unit"], "1/humidity_pct");
  EXPECT_EQ(law["parameters"][0]["high"], 0.0087);
  const std::string sentence =
      "Sheath friction grows with humidity_pct: phi' = phi (1 + 0.0083 (humidity_pct - 50)), 95 % "
      "interval of a 0.0079 to 0.0087.";
  EXPECT_EQ(law["text"], sentence);

  report.result.causes = {named_law()};
  EXPECT_EQ(diagnosis_answer(report).find(sentence + "\n"), 0U);
}

}  // namespace
}  // namespace reeve::testing
