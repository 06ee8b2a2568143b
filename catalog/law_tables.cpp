#include "catalog/law_tables.hpp"

#include <fmt/format.h>

#include <optional>
#include <string_view>

#include "causes/term.hpp"
#include "core/error.hpp"
#include "core/notation.hpp"

namespace reeve::catalog {
namespace {

constexpr std::string_view known_sites =
    "a site in quotes: tube, sheath, bearing or block (also: tube 2, tube of finger 1, of held "
    "fingers, of closing fingers, of fingers, of the hand, in release, of M-1-F), a channel such as "
    "T3, all channels, or motor, each also in run 3 or in group B";

template <typename Enum>
Enum read_name(const TomlNode& table, std::string_view key, const std::string& known,
               std::optional<Enum> (*named)(const std::string&)) {
  const TomlNode& node = table.require(key, known);
  if (const auto found = named(node.text())) return *found;
  node.fail_expected(known);
}

Site read_site(const TomlNode& table, const Catalogue& catalogue) {
  const TomlNode& node = table.require("site", known_sites);
  auto site = site_named(node.text());
  if (!site) node.fail_expected(known_sites);
  if (site->routing.empty()) return *site;
  if (const Routing* named = catalogue.find_routing(site->routing)) {
    site->routing = to_word(*named);
    return *site;
  }
  try {
    parse_routing(site->routing);
  } catch (const InputError& error) {
    node.fail_at_value(error.at(node.name).fault());
  }
  return *site;
}

Range read_range(const TomlNode& node) {
  constexpr std::string_view expected = "the ends of a range, such as [20, 80]";
  if (node.kind != TomlKind::array || node.children.size() != 2) node.fail_expected(expected);
  return {node.children[0].finite_number(), node.children[1].finite_number()};
}

void read_covariate(const TomlNode& name, const TomlNode& middle, const TomlNode& range,
                    Covariate& covariate) {
  covariate = covariate_named(name.text());
  covariate.middle = middle.finite_number();
  covariate.seen = read_range(range);
}

// The values at a key of a product, one of each factor.
const std::vector<TomlNode>& read_two(const TomlNode& table, std::string_view key,
                                      std::string_view expected) {
  const TomlNode& node = table.require(key, expected);
  if (node.items().size() != 2) node.fail_expected(expected);
  return node.items();
}

void read_covariates(const TomlNode& table, Term& term) {
  if (term.form == Form::constant) return;
  if (term.form != Form::product) {
    read_covariate(table.require("covariate", "a column of the data in quotes, or \"load\""),
                   table.require("middle", "the covariate's middle"),
                   table.require("range", "the ends of a range, such as [20, 80]"), term.x);
    return;
  }
  const auto& names = read_two(table, "covariate", "two covariates, such as [\"load\", \"cycle\"]");
  const auto& middles = read_two(table, "middle", "two numbers");
  const auto& ranges = read_two(table, "range", "two ranges, such as [[20, 80], [1, 9]]");
  const auto& logarithms = read_two(table, "logarithmic", "two of true and false");
  for (std::size_t i = 0; i < 2; ++i) {
    Covariate& covariate = i == 0 ? term.x : term.y;
    read_covariate(names[i], middles[i], ranges[i], covariate);
    covariate.logarithmic = logarithms[i].truth();
  }
}

std::vector<std::string_view> allowed_keys(Form form) {
  std::vector<std::string_view> keys{"acts_on", "site", "form"};
  if (form != Form::constant) keys.insert(keys.end(), {"covariate", "middle", "range"});
  if (form == Form::product) keys.emplace_back("logarithmic");
  return keys;
}

double read_value(const TomlNode& table, const Parameter& parameter) {
  const auto [low, high] = valid_range(parameter);
  return table.require(parameter.name, fmt::format("a number from {} to {}", low, high))
      .number_between(low, high);
}

std::string range_toml(const Range& range) {
  return fmt::format("[{}, {}]", range.low, range.high);
}

std::string covariates_toml(const Term& term) {
  const Covariate& x = term.x;
  const Covariate& y = term.y;
  if (term.form == Form::constant) return "";
  if (term.form != Form::product) {
    return fmt::format("covariate = {}\nmiddle = {}\nrange = {}\n", toml_text(covariate_name(x)),
                       x.middle, range_toml(x.seen));
  }
  return fmt::format(
      "covariate = [{}, {}]\nmiddle = [{}, {}]\nrange = [{}, {}]\nlogarithmic = [{}, {}]\n",
      toml_text(covariate_name(x)), toml_text(covariate_name(y)), x.middle, y.middle,
      range_toml(x.seen), range_toml(y.seen), x.logarithmic, y.logarithmic);
}

}  // namespace

Effect read_law(const TomlNode& table, const Catalogue& catalogue) {
  Term term;
  term.target = read_name(table, "acts_on", "one of " + target_names(), target_named);
  term.site = read_site(table, catalogue);
  term.form = read_name(table, "form", "one of " + form_names(), form_named);
  std::vector<std::string_view> keys = allowed_keys(term.form);
  read_covariates(table, term);
  if (const auto found = fault(term)) table.find(found->key)->fail_expected(found->expected);
  Effect effect{&law(term), {}, {}};
  const std::vector<Parameter> parameters = effect.cause->parameters({});
  for (const Parameter& parameter : parameters) keys.emplace_back(parameter.name);
  table.allow_only(keys);
  for (const Parameter& parameter : parameters) {
    effect.values.push_back(read_value(table, parameter));
  }
  return effect;
}

std::string law_toml(const Effect& effect) {
  const Term& term = *term_of(*effect.cause);
  std::string text =
      fmt::format("\n[[law]]\nacts_on = \"{}\"\nsite = {}\nform = \"{}\"\n",
                  target_name(term.target), toml_text(site_name(term.site)), form_name(term.form)) +
      covariates_toml(term);
  const std::vector<Parameter> parameters = effect.cause->parameters({});
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    text += fmt::format("{} = {}\n", parameters[i].name, effect.values[i]);
  }
  return text;
}

}  // namespace reeve::catalog
