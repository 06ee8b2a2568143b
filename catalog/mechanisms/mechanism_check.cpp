#include "catalog/mechanisms/mechanism_check.hpp"

#include <fmt/format.h>

#include <cmath>

#include "catalog/mechanisms/named_values.hpp"
#include "catalog/solution.hpp"

namespace reeve::catalog {
namespace {

// Closed forms and solver both use exact ratios; what is left is rounding of doubles.
constexpr double closed_form_tolerance = 1e-9;

bool is_published(double value, const PublishedNumber& number, const NamedValues& values) {
  if (!number.equals) return rounds_to(value, number.printed);
  const double form = number.equals->evaluate(values);
  return std::abs(value - form) <= closed_form_tolerance * std::abs(form);
}

// How far apart, in words and as a part of what is computed.
std::string difference(const CheckItem& item) {
  const std::string printed =
      item.printed.empty() ? fmt::format("{:.6g}", item.published) : item.printed;
  return fmt::format("{} is published and {:.4g} computed ({:+.1f} %)", printed, item.computed,
                     100 * (item.published / item.computed - 1));
}

void judge_explained(const PublishedNumber& number, const NamedValues& values, CheckItem& item) {
  const double given = number.explained_by.evaluate(values);
  if (is_published(given, number, values)) {
    item.status = CheckStatus::explained;
    item.reason = fmt::format("{}; {} = {:.4g}: {}", difference(item), number.explained_by.text(),
                              given, number.reason);
  } else {
    item.reason = fmt::format("{}; {} = {:.4g}, which is listed for it, does not give it",
                              difference(item), number.explained_by.text(), given);
  }
}

void judge(const Mechanism& mechanism, const PublishedNumber& number, const NamedValues& values,
           CheckItem& item) {
  const bool agrees = is_published(item.computed, number, values);
  switch (number.standing) {
    case NumberStanding::plain:
      item.status = agrees ? CheckStatus::agrees : CheckStatus::differs;
      if (!agrees) item.reason = difference(item) + ", and nothing is listed for it";
      return;
    case NumberStanding::used:
      item.status = agrees ? CheckStatus::used : CheckStatus::differs;
      if (!agrees) item.reason = difference(item) + ", though the coefficient is said to be its";
      return;
    case NumberStanding::explained:
    case NumberStanding::open:
      break;
  }
  if (agrees) {
    item.reason = fmt::format("it agrees, though {}:{}:{} lists it as one that differs",
                              mechanism.file, number.at.line, number.at.column);
  } else if (number.standing == NumberStanding::open) {
    item.status = CheckStatus::open;
    item.reason = fmt::format("{}; {}", difference(item), number.reason);
  } else {
    judge_explained(number, values, item);
  }
}

CheckItem check_number(const Mechanism& mechanism, const PublishedNumber& number) {
  const NamedValues values = solved_values(number);
  CheckItem item;
  item.family = mechanism.family;
  item.routing = mechanism.name;
  item.source = number.source;
  item.quantity = {CheckedKind::in_words, 0};
  item.in_words = number.quantity;
  item.inferred_from = number.rig.inferred_from;
  item.printed = number.equals ? "" : number.printed.digits;
  item.published = number.equals ? number.equals->evaluate(values) : number.printed.value;
  item.computed = number.computed.evaluate(values);
  judge(mechanism, number, values, item);
  return item;
}

}  // namespace

CheckReport check_mechanism(const Mechanism& mechanism) {
  CheckReport report;
  for (const PublishedNumber& number : mechanism.numbers) {
    report.items.push_back(check_number(mechanism, number));
  }
  for (const Misprint& misprint : mechanism.misprints) {
    report.misprints.push_back({mechanism.name, misprint.source, misprint.text, mechanism.family});
  }
  return report;
}

}  // namespace reeve::catalog
