#include "reports/check_report.hpp"

#include <fmt/format.h>

#include "reports/json.hpp"
#include "reports/text_table.hpp"

namespace reeve {
namespace {

std::string number_text(double value) { return fmt::format("{:.4g}", value); }

std::string published_text(const CheckItem& item) {
  return item.printed.empty() ? number_text(item.published) : item.printed;
}

std::string reasons(const CheckReport& report) {
  std::string text;
  for (const CheckItem& item : report.items) {
    if (item.reason.empty()) continue;
    text += fmt::format("{} {}, {}: {}\n", item.routing, item.source, item.quantity, item.reason);
  }
  return text.empty() ? "" : "\nWhy they differ\n" + text;
}

std::string misprints(const CheckReport& report) {
  std::string text;
  for (const CheckedMisprint& misprint : report.misprints) {
    text += fmt::format("{} {}: {}\n", misprint.routing, misprint.source, misprint.text);
  }
  return text.empty() ? "" : "\nMisprints that change no number\n" + text;
}

}  // namespace

std::string check_table(const CheckReport& report) {
  TextTable table({"<routing", "<source", "<quantity", "published", "computed", "<status"});
  for (const CheckItem& item : report.items) {
    table.add({item.routing, item.source, item.quantity, published_text(item),
               number_text(item.computed), name(item.status)});
  }
  return fmt::format("{}{}{}\n{} agree, {} explained, {} differ\n", table.text(), reasons(report),
                     misprints(report), report.count(CheckStatus::agrees),
                     report.count(CheckStatus::explained), report.count(CheckStatus::differs));
}

std::string check_json(const CheckReport& report) {
  Json json;
  json["checks"] = Json::array();
  for (const CheckItem& item : report.items) {
    json["checks"].push_back({{"routing", item.routing},
                              {"source", item.source},
                              {"quantity", item.quantity},
                              {"published", number(item.published)},
                              {"computed", number(item.computed)},
                              {"status", name(item.status)},
                              {"reason", item.reason.empty() ? Json(nullptr) : Json(item.reason)}});
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

}  // namespace reeve
