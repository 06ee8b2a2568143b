#include "catalog/law_tables.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "catalog/model_file.hpp"
#include "causes/term.hpp"
#include "tests/catalog/mistake.hpp"
#include "tests/support/random_routing.hpp"
#include "tests/support/temporary_folder.hpp"

namespace reeve {
namespace {

using testing::Dice;
using testing::Mistake;
using testing::TemporaryFolder;

Model model_with_laws(const std::string& text) {
  const TemporaryFolder folder;
  return read_model_file(folder.write("m.toml", text)).model;
}

std::string error_in_laws(const std::string& text) {
  const TemporaryFolder folder;
  return folder.error_of([&] { read_model_file(folder.write("m.toml", text)); });
}

const std::string humid_sheath =
    "[[law]]\nacts_on = \"exponent\"\nsite = \"sheath\"\nform = \"linear\"\n"
    "covariate = \"humidity_pct\"\nmiddle = 50\nrange = [20, 80]\na = 0.0083\n";

TEST(LawTable, IsReadAsItsTerm) {
  const Model model = model_with_laws(humid_sheath + "[conditions]\nhumidity_pct = 60\n");
  ASSERT_EQ(model.effects.size(), 1U);
  const Term* term = term_of(*model.effects[0].cause);
  ASSERT_NE(term, nullptr);
  EXPECT_EQ(term->target, Target::exponent);
  EXPECT_EQ(term->site.kind, ContactKind::sheath);
  EXPECT_EQ(term->form, Form::linear);
  EXPECT_EQ(term->x.kind, CovariateKind::column);
  EXPECT_EQ(term->x.column, "humidity_pct");
  EXPECT_EQ(term->x.middle, 50);
  EXPECT_EQ(term->x.seen.low, 20);
  EXPECT_EQ(term->x.seen.high, 80);
  EXPECT_EQ(model.effects[0].values, std::vector<double>{0.0083});
  ASSERT_TRUE(model.conditions.record);
  EXPECT_EQ(covariate_value(term->x, model.conditions, 0), 60);
}

TEST(LawTable, OfAProductHasTwoCovariates) {
  const Model model = model_with_laws(
      "[[law]]\nacts_on = \"gain\"\nsite = \"T2\"\nform = \"product\"\n"
      "covariate = [\"load\", \"supply_V\"]\nmiddle = [10, 24]\nrange = [[1, 40], [20, 28]]\n"
      "logarithmic = [true, false]\na = -0.01\n");
  const Term& term = *term_of(*model.effects.at(0).cause);
  EXPECT_EQ(term.x.kind, CovariateKind::load);
  EXPECT_TRUE(term.x.logarithmic);
  EXPECT_EQ(term.x.seen.high, 40);
  EXPECT_EQ(term.y.column, "supply_V");
  EXPECT_FALSE(term.y.logarithmic);
  EXPECT_EQ(term.y.middle, 24);
  EXPECT_FALSE(belongs_to_designs(model.effects[0]));
}

TEST(LawTable, TakesNamesOfTheCatalogueInASite) {
  const TemporaryFolder folder;
  const Catalogue catalogue = read_catalogue(std::filesystem::path(REEVE_CATALOG_DIR));
  const auto file = folder.write("m.toml",
                                 "[[law]]\nacts_on = \"exponent\"\nsite = \"tube 2 of tr5\"\n"
                                 "form = \"constant\"\na = 0.5\n");
  const Model model = read_model_file(file, catalogue).model;
  EXPECT_EQ(term_of(*model.effects.at(0).cause)->site.routing, "M-1-P-2-M");
  EXPECT_TRUE(names_routings(model));
}

TEST(LawTable, OfARunAGroupAChannelOrTheMotorIsOfNoDesign) {
  const auto is_of_designs = [](const char* target, const std::string& site) {
    const Model model =
        model_with_laws(std::string("[[law]]\nacts_on = \"") + target + "\"\nsite = \"" + site +
                        "\"\nform = \"constant\"\na = 0.5\n");
    return belongs_to_designs(model.effects.at(0));
  };
  EXPECT_TRUE(is_of_designs("exponent", "tube of finger 1"));
  EXPECT_TRUE(is_of_designs("force", "bearing"));
  EXPECT_FALSE(is_of_designs("exponent", "tube in run 3"));
  EXPECT_FALSE(is_of_designs("force", "sheath in group B"));
  EXPECT_FALSE(is_of_designs("gain", "T3"));
  EXPECT_FALSE(is_of_designs("offset", "all channels"));
  EXPECT_FALSE(is_of_designs("force", "motor"));
}

Covariate random_covariate(Dice& dice, bool of_channels) {
  const std::vector<std::string> names{
      "load",          "motor_tension_N", "speed_mm_s", "cycle",
      "temperature_C", "order",           "rh [%]",     "column load",
      "a \"b\" \\ c",  "humidity\tpct",   "Δ"};
  Covariate x = of_channels && dice.chance(0.2)
                    ? covariate_named("T2")
                    : covariate_named(names[static_cast<std::size_t>(dice.integer(0, 10))]);
  x.seen.low = dice.log_real(1e-3, 10);
  x.seen.high = x.seen.low + dice.log_real(1e-3, 1e4);
  x.middle = dice.real(x.seen.low, x.seen.high);
  return x;
}

Effect random_law(Dice& dice) {
  const std::vector<const char*> sites{"tube",
                                       "sheath of finger 2",
                                       "bearing of closing fingers",
                                       "sheath in release",
                                       "block 3 of M-1-F",
                                       "motor",
                                       "tube in run left glove",
                                       "sheath in run 3 in group B",
                                       "motor in group \"C\"",
                                       "T3",
                                       "all channels in run \\n 1",
                                       "a in group 7"};
  Term term;
  term.site = site_named(sites[static_cast<std::size_t>(dice.integer(0, 10))]).value();
  const bool of_contacts = term.site.place == SitePlace::contacts;
  const bool of_motor = term.site.place == SitePlace::motor;
  const bool first = dice.chance(0.5);
  term.target = of_contacts ? (first ? Target::exponent : Target::force)
                            : (first ? Target::gain : Target::offset);
  term.form = static_cast<Form>(dice.integer(0, 9));
  if (term.form != Form::constant) term.x = random_covariate(dice, !of_contacts && !of_motor);
  if (term.form == Form::product) {
    term.y = random_covariate(dice, !of_contacts && !of_motor);
    term.x.logarithmic = dice.chance(0.5);
    term.y.logarithmic = dice.chance(0.5);
  }
  Effect effect{&law(term), {}, {}};
  for (const Parameter& parameter : effect.cause->parameters({})) {
    effect.values.push_back(dice.real(parameter.range.low, parameter.range.high));
  }
  return effect;
}

// Equal laws are one and the same cause, so that all of a term is compared.
TEST(LawTable, ReadsBackWhatIsWrittenBitByBit) {
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    Dice dice(seed);
    Model model;
    Record record;
    for (int i = 0; i < 3; ++i) {
      add_effect(model, random_law(dice));
      for (const Covariate& x : covariates(model.effects.back())) {
        if (x.kind != CovariateKind::column) continue;
        bool is_new = true;
        for (const NamedValue& value : record.columns) is_new &= value.name != x.column;
        if (is_new) record.columns.push_back({x.column, dice.real(-1e3, 1e3)});
      }
    }
    model.conditions.record = std::make_shared<const Record>(record);
    const std::string text = model_toml(model, {});
    SCOPED_TRACE(text);
    const Model back = model_with_laws(text);
    ASSERT_EQ(back.effects.size(), model.effects.size());
    for (std::size_t i = 0; i < model.effects.size(); ++i) {
      EXPECT_EQ(back.effects[i].cause, model.effects[i].cause);
      EXPECT_EQ(back.effects[i].values, model.effects[i].values);
      for (const Covariate& x : covariates(model.effects[i])) {
        EXPECT_EQ(covariate_value(x, back.conditions, 0), covariate_value(x, model.conditions, 0));
      }
    }
    EXPECT_EQ(model_toml(back, {}), text);
    if (HasFailure()) return;
  }
}

std::string with(const std::string& from, const std::string& to) {
  std::string text = humid_sheath;
  text.replace(text.find(from), from.size(), to);
  return text;
}

TEST(BadLawTable, NamesThePlaceOfAMistake) {
  const std::string sites =
      "a site in quotes: tube, sheath, bearing or block (also: tube 2, tube of finger 1, of held "
      "fingers, of closing fingers, of fingers, of the hand, in release, of M-1-F), a channel such as "
      "T3, all channels, or motor, each also in run 3 or in group B";
  const std::vector<Mistake> mistakes = {
      {"[[law]]\n",
       "m.toml:1:1: missing key 'acts_on' in 'law[1]': expected one of " + target_names()},
      {with("\"exponent\"", "\"torque\""),
       "m.toml:2:11: law[1].acts_on = \"torque\": expected one of exponent, force, gain, offset"},
      {with("\"sheath\"", "\"sheaths\""),
       "m.toml:3:8: law[1].site = \"sheaths\": expected " + sites},
      {with("\"sheath\"", "\"sheath of M-1-Q\""),
       "m.toml:3:8: law[1].site: routing 'M-1-Q', column 5: unknown token 'Q': expected M, F, T, "
       "B, P, a finger such as 1, 2b or 3x, a block such as Y1 or Y1k, or a bar such as W1"},
      {with("\"sheath\"", "\"T3\""),
       "m.toml:3:8: law[1].site = \"T3\": expected contacts, which have an exponent"},
      {with("\"linear\"", "\"cubic\""),
       "m.toml:4:8: law[1].form = \"cubic\": expected one of " + form_names()},
      {with("\"linear\"", "\"constant\""),
       "m.toml:5:1: unknown key 'law[1].covariate': expected one of acts_on, site, form, a"},
      {with("\"humidity_pct\"", "5"),
       "m.toml:5:13: law[1].covariate = 5: expected a text in quotes, not empty"},
      {with("\"humidity_pct\"", "\"T2\""),
       "m.toml:5:13: law[1].covariate = \"T2\": expected no other channel, but for a law of "
       "channels"},
      {with("middle = 50\n", ""),
       "m.toml:1:1: missing key 'middle' in 'law[1]': expected the covariate's middle"},
      {with("50", "nan"), "m.toml:6:10: law[1].middle = nan: expected a finite number"},
      {with("[20, 80]", "80"),
       "m.toml:7:9: law[1].range = 80: expected the ends of a range, such as [20, 80]"},
      {with("[20, 80]", "[20, \"x\"]"),
       "m.toml:7:14: law[1].range[2] = \"x\": expected a finite number"},
      {with("[20, 80]", "[80, 20]"),
       "m.toml:7:9: law[1].range = (an array): expected the lower end before the upper one"},
      {with("a = 0.0083\n", ""),
       "m.toml:1:1: missing key 'a' in 'law[1]': expected a number from "
       "-0.16666666666666666 to 0.16666666666666666"},
      {with("0.0083", "0.2"),
       "m.toml:8:5: law[1].a = 0.2: expected a number from -0.16666666666666666 to "
       "0.16666666666666666"},
      {with("a = 0.0083", "a = 0.0083\nb = 2"),
       "m.toml:9:1: unknown key 'law[1].b': expected one of acts_on, site, form, covariate, "
       "middle, range, a"},
      {humid_sheath + humid_sheath,
       "m.toml:9:1: law[2]: law[exponent of sheath, humidity_pct, linear] is given twice: "
       "expected each effect once"},
      {with("\"humidity_pct\"", "[\"humidity_pct\", \"load\"]"),
       "m.toml:5:13: law[1].covariate = (an array): expected a text in quotes, not empty"},
      {with("\"linear\"", "\"product\""),
       "m.toml:5:13: law[1].covariate = \"humidity_pct\": expected an array"},
      {"[law]\n", "m.toml:1:1: law = (a table): expected tables headed [[law]]"},
      {humid_sheath + "[conditions]\nhumidity = 60\n",
       "m.toml:10:1: unknown key 'conditions.humidity': expected one of motor_tension_N, "
       "speed_mm_s, cycle, temperature_C, humidity_pct; did you mean humidity_pct?"},
      {humid_sheath + "[conditions]\nhumidity_pct = \"wet\"\n",
       "m.toml:10:16: conditions.humidity_pct = \"wet\": expected a finite number"},
  };
  for (const Mistake& mistake : mistakes) EXPECT_EQ(error_in_laws(mistake.text), mistake.message);
}

}  // namespace
}  // namespace reeve
