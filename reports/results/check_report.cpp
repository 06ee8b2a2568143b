#include "reports/results/check_report.hpp"

#include <fmt/format.h>

#include "reports/json.hpp"
#include "reports/results/check_words.hpp"

namespace reeve::reports {
namespace {

std::string number_text(double value) { return fmt::format("{:.4g}", value); }

std::string published_text(const CheckItem& item) {
  return item.printed.empty() ? number_text(item.published) : item.printed;
}

Section reasons(const CheckReport& report) {
  Section section{"Why they differ", std::nullopt, {}};
  for (const CheckItem& item : report.items) {
    if (item.reason.empty()) continue;
    section.lines.push_back(
        {fmt::format("{}{}, {}: {}", item.routing.empty() ? "" : item.routing + " ", item.source,
                     quantity_text(item.quantity), item.reason)});
  }
  return section;
}

Section misprints(const CheckReport& report) {
  Section section{"Misprints that change no number", std::nullopt, {}};
  for (const CheckedMisprint& misprint : report.misprints) {
    section.lines.push_back(
        {fmt::format("{} {}: {}", misprint.routing, misprint.source, misprint.text)});
  }
  return section;
}

Tint tint(CheckStatus status) {
  switch (status) {
    case CheckStatus::agrees:
      return Tint::none;
    case CheckStatus::explained:
      return Tint::notable;
    case CheckStatus::differs:
      return Tint::bad;
  }
  return Tint::none;
}

}  // namespace

Sheet check_sheet(const CheckReport& report) {
  Table table{{text_column("routing"), text_column("source"), text_column("quantity"),
               number_column("published"), number_column("computed"), text_column("status")},
              {}};
  for (const CheckItem& item : report.items) {
    table.add({item.routing.empty() ? "-" : item.routing, item.source, quantity_text(item.quantity),
               published_text(item), number_text(item.computed), status_name(item.status)},
              tint(item.status));
  }
  Sheet sheet{{{"", table, {}}}};
  sheet.add(reasons(report));
  sheet.add(misprints(report));
  sheet.add(
      {"",
       std::nullopt,
       {{fmt::format("{} agree, {} explained, {} differ", report.count(CheckStatus::agrees),
                     report.count(CheckStatus::explained), report.count(CheckStatus::differs))}}});
  return sheet;
}

std::string check_json(const CheckReport& report) {
  Json json;
  json["checks"] = Json::array();
  for (const CheckItem& item : report.items) {
    json["checks"].push_back({{"routing", text_or_null(item.routing)},
                              {"source", item.source},
                              {"quantity", quantity_text(item.quantity)},
                              {"published", number(item.published)},
                              {"computed", number(item.computed)},
                              {"status", status_name(item.status)},
                              {"reason", text_or_null(item.reason)}});
  }
  json["misprints"] = Json::array();
  for (const CheckedMisprint& misprint : report.misprints) {
    json["misprints"].push_back(
        {{"routing", misprint.routing}, {"source", misprint.source}, {"text", misprint.text}});
  }
  json["agrees"] = report.count(CheckStatus::agrees);
  json["explained"] = report.count(CheckStatus::explained);
  json["differs"] = report.count(CheckStatus::differs);
  json["version"] = version_json();
  return print(json);
}

}  // namespace reeve::reports
