#include "causes/named_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

#include "causes/term.hpp"
#include "core/error.hpp"
#include "core/nearest_name.hpp"
#include "core/text.hpp"

namespace reeve::causes {
namespace {

constexpr std::string_view law_start = "law[";

// The parts of "exponent of sheath, humidity_pct, linear".
struct LawText {
  std::string target;
  std::string site;
  std::string covariate;
  std::string form;
};

LawText parts_of(const std::string& name) {
  constexpr std::string_view of = " of ";
  constexpr std::string_view comma = ", ";
  const std::string inside = name.substr(law_start.size(), name.size() - law_start.size() - 1);
  const std::size_t site = inside.find(of);
  const std::size_t first = inside.find(comma);
  const std::size_t last = inside.rfind(comma);
  const bool is_constant = first == std::string::npos;
  if (name.back() != ']' || site >= first || (!is_constant && first == last)) {
    throw InputError({.expected = "law[ACTS_ON of SITE, COVARIATE, FORM], or law[ACTS_ON of SITE] "
                                  "of a constant"});
  }
  const std::size_t after_of = site + of.size();
  LawText text{inside.substr(0, site), inside.substr(after_of), "", form_name(Form::constant)};
  if (is_constant) return text;
  text.site = inside.substr(after_of, first - after_of);
  text.covariate = inside.substr(first + comma.size(), last - first - comma.size());
  text.form = inside.substr(last + comma.size());
  return text;
}

template <typename Enum>
Enum named_value(const std::string& text, const char* what, const std::string& names,
                 std::optional<Enum> (*named)(const std::string&)) {
  if (const auto found = named(text)) return *found;
  throw InputError(
      {.what = what, .value = text, .expected = "one of " + names, .form = InputForm::unknown});
}

std::vector<std::string> routings_of(const Survey& survey) {
  std::vector<std::string> words;
  for (const SurveyedRouting& routing : survey.routings) words.push_back(routing.word);
  return words;
}

bool has_runs(const std::vector<std::string>& runs, const Survey& survey) {
  return std::ranges::all_of(runs, [&](const std::string& run) {
    const auto number = whole_number_in(run);
    return number && *number >= 1 && static_cast<std::size_t>(*number) <= survey.runs;
  });
}

bool has_site(const Site& site, const Survey& survey) {
  if (!site.group.empty() || !has_runs(site.runs, survey)) return false;
  if (site.place == SitePlace::channel) {
    return std::ranges::find(survey.channels, site.channel) != survey.channels.end();
  }
  if (site.place != SitePlace::contacts) return true;
  return std::ranges::any_of(survey.routings, [&](const SurveyedRouting& routing) {
    if (!site.routing.empty() && routing.word != site.routing) return false;
    std::size_t number = 0;
    for (const Contact& contact : routing.network->contacts) {
      if (!acts_on(site, contact.kind)) continue;
      const bool is_it = (site.finger == 0 || contact.finger == site.finger) &&
                         (!site.number || *site.number == number);
      if (is_it) return true;
      ++number;
    }
    return false;
  });
}

Site site_of(const std::string& name, const Survey& survey) {
  const auto site = site_named(name);
  if (site && has_site(*site, survey)) return *site;
  throw InputError({.what = "site",
                    .value = name,
                    .expected = fmt::format("contacts, a channel, a run or a routing of the "
                                            "experiment ({}), such as \"tube of finger 1\"",
                                            fmt::join(routings_of(survey), ", ")),
                    .form = InputForm::unknown});
}

// Returns the range that the experiment gives a covariate; nothing if it has no such column.
std::optional<Range> range_in(const Survey& survey, const Covariate& covariate) {
  const bool of_tension = is_of_tensions(covariate);
  const std::string name = of_tension ? "motor_tension_N" : covariate_name(covariate);
  for (const SurveyedColumn& column : survey.columns) {
    if (column.name != name) continue;
    constexpr double least = 0.01;  // share of the greatest motor tension
    return of_tension ? Range{least * column.range.high, column.range.high} : column.range;
  }
  return std::nullopt;
}

Covariate covariate_of(const std::string& name, const Survey& survey) {
  Covariate covariate = covariate_named(name);
  const auto range = range_in(survey, covariate);
  if (!range) {
    std::vector<std::string> names;
    for (const SurveyedColumn& column : survey.columns) names.push_back(column.name);
    throw InputError({.what = "the experiment has no covariate",
                      .value = name,
                      .expected = fmt::format("load, a channel, or one of {}{}",
                                              fmt::join(names, ", "), did_you_mean(name, names)),
                      .form = InputForm::unknown});
  }
  covariate.seen = *range;
  covariate.middle = (range->low + range->high) / 2;
  return covariate;
}

Term term_of_text(const LawText& text, const Survey& survey) {
  Term term;
  term.target = named_value(text.target, "acts on", target_names(), target_named);
  term.site = site_of(text.site, survey);
  term.form = named_value(text.form, "form", form_names(), form_named);
  if (term.form == Form::constant) return term;
  if (term.form != Form::product) {
    term.x = covariate_of(text.covariate, survey);
    return term;
  }
  constexpr std::string_view times = " x ";
  const std::size_t at = text.covariate.find(times);
  if (at == std::string::npos) {
    throw InputError({.what = "covariate",
                      .value = text.covariate,
                      .expected = "two of them, such as load x speed_mm_s"});
  }
  term.x = covariate_of(text.covariate.substr(0, at), survey);
  term.y = covariate_of(text.covariate.substr(at + times.size()), survey);
  return term;
}

double read_number(const std::string& text, const Setting& setting, const char* expected) {
  if (const auto number = number_in(text)) return *number;
  throw InputError(
      {.what = setting.key, .value = setting.value, .expected = expected, .form = InputForm::cell});
}

void set(const Setting& setting, const std::string& text, Covariate& covariate) {
  if (setting.key == "middle") {
    covariate.middle = read_number(text, setting, "a number, one for each covariate");
  } else if (setting.key == "range") {
    constexpr const char* expected = "the ends of a range for each covariate, such as 20:80";
    const std::size_t colon = std::min(text.find(':'), text.size());
    covariate.seen = {
        read_number(text.substr(0, colon), setting, expected),
        read_number(text.substr(std::min(colon + 1, text.size())), setting, expected)};
  } else {
    if (text != "true" && text != "false") {
      throw InputError({.what = setting.key,
                        .value = setting.value,
                        .expected = "true or false, one for each covariate",
                        .form = InputForm::cell});
    }
    covariate.logarithmic = text == "true";
  }
}

// Takes the settings of the covariates into the term, and returns the others.
std::vector<Setting> set_covariates(Term& term, const std::vector<Setting>& settings) {
  std::vector<Setting> left;
  for (const Setting& setting : settings) {
    const bool is_of_product = setting.key == "logarithmic" && term.form == Form::product;
    const bool is_of_covariate = setting.key == "middle" || setting.key == "range";
    if (!is_of_product && !(is_of_covariate && term.form != Form::constant)) {
      left.push_back(setting);
      continue;
    }
    const std::vector<std::string> texts = comma_separated(setting.value);
    const std::size_t count = term.form == Form::product ? 2 : 1;
    if (texts.size() != count) {
      throw InputError({.what = setting.key,
                        .value = setting.value,
                        .expected = count == 2 ? "two values, with a comma" : "one value",
                        .form = InputForm::cell});
    }
    set(setting, texts[0], term.x);
    if (count == 2) set(setting, texts[1], term.y);
  }
  return left;
}

}  // namespace

bool is_law_name(const std::string& name) { return name.starts_with(law_start); }

NamedLaw law_of(const NamedEffect& named, const Survey& survey) {
  Term term = term_of_text(parts_of(named.name), survey);
  NamedLaw result;
  result.settings = set_covariates(term, named.settings);
  if (const auto found = fault(term)) {
    throw InputError({.what = found->key, .expected = found->expected});
  }
  result.cause = &law(term);
  return result;
}

}  // namespace reeve::causes
