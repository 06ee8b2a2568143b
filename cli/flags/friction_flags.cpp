#include "cli/flags/friction_flags.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>
#include <string_view>
#include <utility>

#include "cli/inputs.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "readings/units.hpp"

namespace reeve::cli {
namespace {

constexpr double greatest_coefficient = 10;

CLI::Option* add_coefficient(CLI::App& command, const std::string& name,
                             std::optional<double>& value, const std::string& help) {
  return command.add_option(name, value, help)->check(number_from(0, greatest_coefficient));
}

}  // namespace

double parse_angle(const std::string& text) {
  const std::string_view given = trimmed(text);
  double angle = 0;
  const char* const end = given.data() + given.size();
  const auto [rest, error] = std::from_chars(given.data(), end, angle);
  const std::string_view unit = trimmed({rest, static_cast<std::size_t>(end - rest)});
  const auto known =
      unit.empty() ? std::optional(own_unit(Dimension::angle)) : find_unit(unit, Dimension::angle);
  const bool is_number = error == std::errc{} && std::isfinite(angle) && angle >= 0;
  constexpr double most_without_unit = 20;  // rad; three turns, and few in degrees
  const bool is_clear = !unit.empty() || angle <= most_without_unit;
  if (is_number && known && is_clear) return known->converted(angle);
  throw InputError({.value = text, .expected = "an angle such as 180deg or 3.14rad"});
}

void FrictionFlags::add_to(CLI::App& command) {
  options_ = {
      add_coefficient(command, "--mu", mu_,
                      "Friction coefficient of tubes and sheaths, in place of the hardware's"),
      add_coefficient(command, "--tube-mu", tube_mu_, "Friction coefficient of the tubes alone"),
      add_coefficient(command, "--sheath-mu", sheath_mu_,
                      "Friction coefficient of the sheaths alone"),
      command.add_option("--sheath-bend", sheath_bend_,
                         "Sum of the bends of a sheath, such as 180deg or 3.14rad; its length has "
                         "no effect")};
}

bool FrictionFlags::is_given() const {
  return std::ranges::any_of(options_, [](const auto* option) { return option->count() > 0; });
}

void FrictionFlags::exclude(CLI::Option& model) {
  for (CLI::Option* option : options_) option->excludes(&model);
}

void FrictionFlags::apply(Hardware& hardware) const {
  if (!is_given()) return;
  if (const auto tube = tube_mu_ ? tube_mu_ : mu_) hardware.tube.mu = *tube;
  if (const auto sheath = sheath_mu_ ? sheath_mu_ : mu_) hardware.sheath.mu = *sheath;
  if (sheath_bend_) {
    hardware.sheath.angle_rad =
        for_name("--sheath-bend", [&] { return parse_angle(*sheath_bend_); });
  }
  HardwareOrigin origin = hardware.origin ? *hardware.origin : HardwareOrigin{"default", {}};
  origin.file += " with " + given();
  hardware.origin = std::make_shared<const HardwareOrigin>(std::move(origin));
  for_option(given(), [&] { validate(hardware); });
}

void FrictionFlags::require_to_act(Hardware& hardware, const LookAtNetworks& look) const {
  const auto require = [&](bool is_given, const char* option, std::vector<ContactKind> kinds,
                           LawValue value) {
    if (!is_given || kinds.empty()) return;
    ValueUse use(hardware, std::move(kinds), value);
    look(use);
    require_taken(option, use);
    if (!use.has_owners()) return;
    HardwareOrigin origin = *hardware.origin;
    origin.file += fmt::format(" ({})", left_alone(option, use));
    hardware.origin = std::make_shared<const HardwareOrigin>(std::move(origin));
  };
  std::vector<ContactKind> of_mu;
  if (!tube_mu_) of_mu.push_back(ContactKind::tube);
  if (!sheath_mu_) of_mu.push_back(ContactKind::sheath);
  require(mu_.has_value(), "--mu", of_mu, LawValue::mu);
  require(tube_mu_.has_value(), "--tube-mu", {ContactKind::tube}, LawValue::mu);
  require(sheath_mu_.has_value(), "--sheath-mu", {ContactKind::sheath}, LawValue::mu);
  require(sheath_bend_.has_value(), "--sheath-bend", {ContactKind::sheath}, LawValue::angle);
}

std::string FrictionFlags::given() const {
  std::vector<std::string> texts;
  for (const CLI::Option* option : options_) {
    if (option->count() > 0) texts.push_back(option->get_name() + " " + option->results().front());
  }
  return fmt::format("{}", fmt::join(texts, " "));
}

}  // namespace reeve::cli
