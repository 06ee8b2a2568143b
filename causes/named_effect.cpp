#include "causes/named_effect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "causes/library.hpp"
#include "causes/named_law.hpp"
#include "causes/term.hpp"
#include "core/error.hpp"
#include "core/nearest_name.hpp"
#include "core/text.hpp"

namespace reeve::causes {
namespace {

std::string name_of(const Cause& cause, const Subject& subject) {
  return effect_name(Effect{&cause, subject, {}});
}

std::string cause_part(const std::string& name) { return name.substr(0, name.find('[')); }

// "TR1,T1-T2" of "seized_contact[TR1,T1-T2]".
std::string_view subject_part(std::string_view name) {
  const std::size_t bracket = name.find('[');
  if (bracket == std::string_view::npos || name.back() != ']') return {};
  return name.substr(bracket + 1, name.size() - bracket - 2);
}

const Cause& cause_of(const std::string& name) {
  const std::string cause_name = cause_part(name);
  if (const Cause* cause = find_cause(cause_name)) return *cause;
  throw InputError({.what = "unknown cause",
                    .value = cause_name,
                    .expected = fmt::format("one of {}{}", cause_names(),
                                            did_you_mean(cause_name, cause_list())),
                    .form = InputForm::unknown});
}

constexpr std::array lacks{
    Lack{&Survey::has_speed, "it depends on the speed", "it to be given"},
    Lack{&Survey::has_cycle, "it depends on the cycle", "it to be given"},
    Lack{&Survey::has_temperature, "it depends on the temperature", "it to be given"},
    Lack{&Survey::has_motor_tension, "it is about the motor tension", "it to be given"},
    Lack{&Survey::has_both_directions, "pulling and releasing differ by it",
         "readings of both directions"},
    Lack{&Survey::sheath_angle_varies, "it shows where sheath angles differ",
         "more than one of them"}};

const Lack* lack_of(const Cause& cause, const Survey& survey) {
  if (!cause.subjects(survey).empty()) return nullptr;
  for (const Lack& lack : lacks) {
    Survey changed = survey;
    changed.*lack.has = true;
    if (!cause.subjects(changed).empty()) return &lack;
  }
  return nullptr;
}

InputError cannot_show(const Cause& cause, const Survey& survey) {
  if (const Lack* lack = lack_of(cause, survey)) {
    return InputError({.what = lack->why, .expected = lack->wanted});
  }
  return InputError("the experiment has no routing, channel or part that it could be about");
}

// The first few.
std::string list_of_names(const Cause& cause, const std::vector<Subject>& subjects) {
  constexpr std::size_t most = 8;
  std::vector<std::string> names;
  for (const Subject& subject : subjects) {
    const std::string name = name_of(cause, subject);
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  }
  const bool is_long = names.size() > most;
  if (is_long) names.resize(most);
  return fmt::format("{}{}", fmt::join(names, ", "), is_long ? ", …" : "");
}

std::vector<Subject> subjects_named(const std::string& name, const Cause& cause,
                                    const Survey& survey) {
  const std::vector<Subject> possible = cause.subjects(survey);
  if (possible.empty()) throw cannot_show(cause, survey);
  std::vector<Subject> named;
  for (const Subject& subject : possible) {
    if (name_of(cause, subject) == name ||
        cause.is_also_named(subject, subject_part(name), survey)) {
      named.push_back(subject);
    }
  }
  if (!named.empty()) return named;
  throw InputError({.what = "this experiment has no such thing",
                    .expected = list_of_names(cause, possible),
                    .form = InputForm::unknown});
}

double number_of(const Setting& setting, const Parameter& parameter) {
  const std::string& text = setting.value;
  const auto value = number_in(text);
  const Range range = valid_range(parameter);
  if (value && *value >= range.low && *value <= range.high) return *value;
  throw InputError({.what = setting.key,
                    .value = text,
                    .expected = fmt::format("a number from {} to {}", range.low, range.high),
                    .form = InputForm::cell});
}

// In orders of magnitude where the range is positive; two digits are enough for a middle.
double middle(const Parameter& parameter) {
  const Range range = parameter.literature.value_or(parameter.range);
  const double value =
      range.low > 0 ? std::sqrt(range.low * range.high) : (range.low + range.high) / 2;
  if (value == 0) return value;
  const double unit = std::pow(10, std::floor(std::log10(std::abs(value))) - 1);
  return std::round(value / unit) * unit;
}

bool fits(const Setting& setting, const Subject& subject) {
  const Grasp grasp = setting.key == "recorded" ? *subject.recorded : *subject.actual;
  return to_text(grasp) == setting.value;
}

// ", middle = 50, range = 20:80", as law_of reads it.
std::string covariates_text(const Effect& effect) {
  std::vector<std::string> middles, ranges;
  std::vector<bool> logarithms;
  for (const Covariate& x : covariates(effect)) {
    middles.push_back(fmt::format("{}", x.middle));
    ranges.push_back(fmt::format("{}:{}", x.seen.low, x.seen.high));
    logarithms.push_back(x.logarithmic);
  }
  if (middles.empty()) return "";
  std::string text =
      fmt::format(", middle = {}, range = {}", fmt::join(middles, ","), fmt::join(ranges, ","));
  if (logarithms.size() < 2) return text;
  return text + fmt::format(", logarithmic = {},{}", bool(logarithms[0]), bool(logarithms[1]));
}

// Keeps the subjects that fit a setting of the grasps.
void choose(const Setting& setting, std::vector<Subject>& subjects) {
  std::set<std::string> grasps;
  for (const Subject& subject : subjects) {
    grasps.insert(to_text(setting.key == "recorded" ? *subject.recorded : *subject.actual));
  }
  std::erase_if(subjects, [&](const Subject& subject) { return !fits(setting, subject); });
  if (!subjects.empty()) return;
  throw InputError({.what = setting.key,
                    .value = setting.value,
                    .expected = fmt::format("one of {}", fmt::join(grasps, " or ")),
                    .form = InputForm::cell});
}

void require_each_once(const std::vector<Setting>& settings) {
  std::set<std::string> keys;
  for (const Setting& setting : settings) {
    if (keys.insert(setting.key).second) continue;
    throw InputError(fmt::format("'{}' is set twice", setting.key));
  }
}

class EffectReader {
 public:
  EffectReader(const Cause& cause, std::vector<Subject> subjects,
               const std::vector<Setting>& settings, const Hardware& hardware)
      : cause_(cause),
        parameters_(cause_.parameters(hardware)),
        subjects_(std::move(subjects)),
        values_(parameters_.size()) {
    for (const Setting& setting : settings) read(setting);
  }

  Effect effect() const {
    Effect effect{&cause_, subjects_.front(), {}};
    for (std::size_t i = 0; i < parameters_.size(); ++i) {
      const Parameter& parameter = parameters_[i];
      if (i == 0 && !values_[i]) {
        const Range range = valid_range(parameter);
        throw InputError({.what = "its size is missing",
                          .expected = fmt::format("{}=VALUE, from {} to {}", parameter.name,
                                                  range.low, range.high)});
      }
      effect.values.push_back(values_[i].value_or(middle(parameter)));
    }
    return effect;
  }

 private:
  void read(const Setting& setting) {
    for (std::size_t i = 0; i < parameters_.size(); ++i) {
      if (setting.key != parameters_[i].name) continue;
      values_[i] = number_of(setting, parameters_[i]);
      return;
    }
    const bool about_grasps = subjects_.front().recorded.has_value();
    if (about_grasps && (setting.key == "recorded" || setting.key == "actual")) {
      return choose(setting, subjects_);
    }
    throw InputError({.what = "unknown parameter",
                      .value = setting.key,
                      .expected = known(),
                      .form = InputForm::unknown});
  }

  std::string known() const {
    if (subjects_.front().recorded) return "recorded or actual";
    std::vector<const char*> names;
    for (const Parameter& parameter : parameters_) names.push_back(parameter.name);
    return names.empty() ? "none: it is there or not" : fmt::format("{}", fmt::join(names, ", "));
  }

  const Cause& cause_;
  std::vector<Parameter> parameters_;
  std::vector<Subject> subjects_;
  std::vector<std::optional<double>> values_;
};

Effect read_effect(const NamedEffect& named, const Survey& survey, const Hardware& hardware) {
  require_each_once(named.settings);
  if (is_law_name(named.name)) {
    const NamedLaw law = law_of(named, survey);
    return EffectReader(*law.cause, {Subject{}}, law.settings, hardware).effect();
  }
  const Cause& cause = cause_of(named.name);
  return EffectReader(cause, subjects_named(named.name, cause, survey), named.settings, hardware)
      .effect();
}

}  // namespace

const Lack* lack(const std::string& name, const Survey& survey) {
  const Cause* cause = find_cause(cause_part(name));
  return cause == nullptr ? nullptr : lack_of(*cause, survey);
}

Effect effect_of(const NamedEffect& named, const Survey& survey, const Hardware& hardware) {
  try {
    return read_effect(named, survey, hardware);
  } catch (const InputError& error) {
    throw error.at(fmt::format("'{}'", named.name));
  }
}

std::string size_text(const Effect& effect, const Hardware& hardware) {
  const Subject& subject = effect.subject;
  if (subject.recorded && subject.actual) {
    return fmt::format("recorded {}, really {}", to_text(*subject.recorded),
                       to_text(*subject.actual));
  }
  const std::vector<Parameter> parameters = effect.cause->parameters(hardware);
  std::string text;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const std::string unit = parameters[i].unit;
    text += fmt::format("{}{} = {}{}", i == 0 ? "" : ", ", parameters[i].name, effect.values[i],
                        unit == "1" || unit.empty() ? "" : " " + unit);
  }
  return text + covariates_text(effect);
}

}  // namespace reeve::causes
